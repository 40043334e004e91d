// Numbers of text files: the values that std::from_chars gives, sooner for the short numbers that files are
// made of.
#pragma once

#include <bit>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <string_view>
#include <type_traits>

#include <system_error>

namespace quarry {
namespace detail {

// Where digits end, and the number that they make after others, modulo 2^64.
struct Digits {
  const char* stop;
  std::uint64_t value;
};

inline constexpr std::uint64_t kTens[] = {1, 10, 100, 1000, 10000, 100000, 1000000, 10000000, 100000000};

// Eight characters at a time: their digits up to the first other character, by arithmetic on all bytes of a
// word at once (little-endian: the first character is the lowest byte).
inline int leading_digits(std::uint64_t word) {
  // Bit 7 of a byte: above '9', or below '0'. What carries and borrows spoil lies above the first such byte.
  const std::uint64_t others =
      ((word + 0x4646464646464646U) | (word - 0x3030303030303030U)) & 0x8080808080808080U;
  return std::countr_zero(others) / 8;
}

// The number of so many leading digits, at least one: they move to the end of eight, behind zeros, where
// pairs, then fours, then all are joined.
inline std::uint64_t value_of_digits(std::uint64_t word, int count) {
  std::uint64_t digits = (word - 0x3030303030303030U) << (64 - 8 * count);
  digits = 10 * digits + (digits >> 8);
  constexpr std::uint64_t kPairs = 0x000000FF000000FFU;
  return (((digits & kPairs) * (100 + (std::uint64_t{1000000} << 32))) +
          (((digits >> 16) & kPairs) * (1 + (std::uint64_t{10000} << 32)))) >>
         32;
}

[[gnu::always_inline]] inline Digits take_digits(const char* at, const char* end, std::uint64_t value) {
  if constexpr (std::endian::native == std::endian::little) {
    while (end - at >= 8) {
      std::uint64_t word = 0;
      std::memcpy(&word, at, sizeof(word));
      const int count = leading_digits(word);
      if (count > 0) value = kTens[count] * value + value_of_digits(word, count);
      at += count;
      if (count < 8) return {at, value};
    }
  }
  for (; at != end; ++at) {
    const auto digit = static_cast<std::uint64_t>(static_cast<unsigned char>(*at)) - '0';
    if (digit > 9) break;
    value = 10 * value + digit;
  }
  return {at, value};
}

// What may be too large, and what is no number, is for the library to judge. Apart, so that the rest stays
// small enough to become part of its callers.
template <class Number>
[[gnu::noinline]] std::from_chars_result read_rare_number(const char* begin, const char* end, Number& value) {
  return std::from_chars(begin, end, value);
}

// The powers of ten that are doubles.
inline constexpr double kExactPowers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                          1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                          1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
inline constexpr std::int64_t kLargestPower = 22;
inline constexpr std::uint64_t kLargestMantissa = std::uint64_t{1} << 53;

}  // namespace detail

// As std::from_chars(begin, end, value), for a signed integer.
template <class Integer>
  requires std::is_signed_v<Integer> && std::is_integral_v<Integer>
std::from_chars_result read_number(const char* begin, const char* end, Integer& value) {
  const bool minus = begin != end && *begin == '-';
  const char* const first = begin + (minus ? 1 : 0);
  const detail::Digits digits = detail::take_digits(first, end, 0);
  constexpr std::ptrdiff_t kSafeDigits = std::numeric_limits<Integer>::digits10;
  if (digits.stop == first || digits.stop - first > kSafeDigits)
    return detail::read_rare_number(begin, end, value);
  const auto size = static_cast<Integer>(digits.value);
  value = static_cast<Integer>(minus ? -size : size);
  return {digits.stop, std::errc()};
}

// As std::from_chars(begin, end, value), for a double. Both a mantissa up to 2^53 and a power of ten up to
// 10^22 are doubles, so that their product or quotient, which is rounded once, is the nearest double to the
// decimal number (Clinger 1990).
inline std::from_chars_result read_number(const char* begin, const char* end, double& value) {
  constexpr std::ptrdiff_t kSafeDigits = 19;
  const bool minus = begin != end && *begin == '-';
  const char* const first = begin + (minus ? 1 : 0);
  detail::Digits digits = detail::take_digits(first, end, 0);
  std::ptrdiff_t count = digits.stop - first;
  std::int64_t power = 0;
  if (digits.stop != end && *digits.stop == '.') {
    const char* const fraction = digits.stop + 1;
    digits = detail::take_digits(fraction, end, digits.value);
    power = fraction - digits.stop;
    count -= power;
  }
  if (count == 0 || count > kSafeDigits) return detail::read_rare_number(begin, end, value);
  if (digits.stop != end && (*digits.stop == 'e' || *digits.stop == 'E')) {
    const char* exponent = digits.stop + 1;
    const bool below = exponent != end && *exponent == '-';
    if (exponent != end && (*exponent == '-' || *exponent == '+')) ++exponent;
    const detail::Digits shift = detail::take_digits(exponent, end, 0);
    if (shift.stop == exponent || shift.stop - exponent > 4)
      return detail::read_rare_number(begin, end, value);
    power += below ? -static_cast<std::int64_t>(shift.value) : static_cast<std::int64_t>(shift.value);
    digits.stop = shift.stop;
  }
  if (digits.value > detail::kLargestMantissa || power > detail::kLargestPower ||
      power < -detail::kLargestPower)
    return detail::read_rare_number(begin, end, value);
  const auto mantissa = static_cast<double>(digits.value);
  const double size =
      power < 0 ? mantissa / detail::kExactPowers[-power] : mantissa * detail::kExactPowers[power];
  value = minus ? -size : size;
  return {digits.stop, std::errc()};
}

// The number that the whole text is, if it is one and finite: of what people write after an option.
inline std::optional<double> parse_finite(std::string_view text) {
  double value = 0;
  const auto [stop, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = failure == std::errc() && stop == text.data() + text.size();
  return whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

}  // namespace quarry
