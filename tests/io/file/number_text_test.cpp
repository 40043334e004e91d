// read_number is std::from_chars, bit by bit and with the same end and error.
#include "io/number_text.hpp"

#include <bit>
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "engine/base/random.hpp"

namespace quarry {
namespace {

template <class Number>
void expect_as_library(const std::string& text) {
  Number ours = 17;
  Number theirs = 17;
  const char* end = text.data() + text.size();
  const auto a = read_number(text.data(), end, ours);
  const auto b = std::from_chars(text.data(), end, theirs);
  EXPECT_EQ(a.ptr - text.data(), b.ptr - text.data()) << text;
  EXPECT_EQ(a.ec, b.ec) << text;
  EXPECT_EQ(std::bit_cast<std::uint64_t>(ours), std::bit_cast<std::uint64_t>(theirs)) << text;
}

TEST(NumberText, IsTheLibrarysForAllFormsOfDoubles) {
  for (const char* text : {"",
                           "-",
                           "+1",
                           ".",
                           "-.",
                           ".5",
                           "-.5",
                           "5.",
                           "-0",
                           "0",
                           "00012.50",
                           "1e5",
                           "1e+5",
                           "1E-5",
                           "1e",
                           "1e+",
                           "1.5ex",
                           "1.5e5x",
                           "1.018757e+002",
                           "1e22",
                           "1e23",
                           "9007199254740992",
                           "9007199254740993",
                           "9007199254740993e-22",
                           "123456789012345678",
                           "1234567890123456789",
                           "12345678901234567890",
                           "0.1234567890123456789",
                           "1e-22",
                           "1e-23",
                           "1e308",
                           "1e309",
                           "-1e999",
                           "5e-324",
                           "1e-400",
                           "1e99999",
                           "0e99999",
                           "nan",
                           "inf",
                           "-inf",
                           "1.2.3",
                           "1 2",
                           "0x10",
                           "1e00005",
                           "1e000000000000000000000005",
                           "0.000000000000000000001"})
    expect_as_library<double>(text);
}

TEST(NumberText, IsTheLibrarysForRandomDoubles) {
  constexpr std::uint64_t kSeed = 5;
  for (std::uint64_t i = 0; i < 20000; ++i) {
    const double value = (uniform01(kSeed, 3 * i) - 0.5) * std::pow(10, static_cast<int>(mix64(i) % 40) - 20);
    const int digits = static_cast<int>(mix64(i + kSeed) % 18);
    expect_as_library<double>(fmt::format("{}", value));
    expect_as_library<double>(fmt::format("{:.{}f}", value, digits));
    expect_as_library<double>(fmt::format("{:.{}e} ", value, digits));
    expect_as_library<double>(fmt::format("{:.{}g}/", value, digits));
  }
}

// Digits are read eight at a time.
TEST(NumberText, EndsAtAnyByteAfterAnyNumberOfDigits) {
  constexpr int kMostDigits = 18;
  const std::string digits = "987654321012345678";
  for (int count = 0; count <= kMostDigits; ++count)
    for (int byte = 0; byte < 256; ++byte) {
      const auto end = static_cast<char>(byte);
      std::string text = digits.substr(0, static_cast<std::size_t>(count));
      text += end;
      expect_as_library<std::int64_t>(text);
      text += "12 3/45:6789";
      expect_as_library<std::int64_t>(text);
      expect_as_library<double>(text);
      // Within the eight that begin before a number's end.
      text.insert(static_cast<std::size_t>(count / 2), 1, end);
      expect_as_library<std::int64_t>(text);
    }
}

TEST(NumberText, IsTheLibrarysForWholeNumbers) {
  for (const char* text :
       {"", "-", "+1", "0", "-0", "007", "12/3", "-12 ", "999999999999999999", "1000000000000000000",
        "9223372036854775807", "-9223372036854775808", "9223372036854775808", "1.5", "x"})
    expect_as_library<std::int64_t>(text);
}

}  // namespace
}  // namespace quarry
