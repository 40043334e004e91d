#include "engine/parallel/sort.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <utility>

#include "engine/parallel/parallel.hpp"

namespace quarry::parallel {
namespace {

constexpr int kDigitBits = 8;
constexpr std::size_t kRadix = std::size_t{1} << kDigitBits;
constexpr std::size_t kSortChunk = 65536;
// Below this a comparison sort of pairs is faster than eight counting passes.
constexpr std::size_t kSmall = 8192;
// From here on the highest digit goes first: fewer keys are in the cache as they are.
constexpr std::size_t kMany = std::size_t{1} << 20;
constexpr std::size_t kSmallRange = 1024;  // as kSmall, of a part in the cache
// Parts of up to so many keys, or of so small a share, are sorted by one thread each.
constexpr std::size_t kLargestPart = 65536;
constexpr std::size_t kFewestParts = 32;

// Keys with their values, and room for as many.
struct Columns {
  std::vector<std::uint64_t> keys;
  std::vector<std::uint32_t> values;
};

void sort_small(Columns& from, std::size_t begin, std::size_t end) {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> pairs(end - begin);
  for (std::size_t i = begin; i < end; ++i) pairs[i - begin] = {from.keys[i], from.values[i]};
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t i = begin; i < end; ++i) std::tie(from.keys[i], from.values[i]) = pairs[i - begin];
}

constexpr std::size_t digit_of(std::uint64_t key, int shift) { return (key >> shift) & (kRadix - 1); }

// Bits in which the keys differ.
std::uint64_t varying_bits(const std::vector<std::uint64_t>& keys) {
  const std::uint64_t first = keys.front();
  return reduce_ordered(
      keys.size(), std::uint64_t{0},
      [&](std::size_t begin, std::size_t end) {
        std::uint64_t bits = 0;
        for (std::size_t i = begin; i < end; ++i) bits |= keys[i] ^ first;
        return bits;
      },
      [](std::uint64_t a, std::uint64_t b) { return a | b; }, kSortChunk);
}

using Counts = std::vector<std::array<std::uint32_t, kRadix>>;  // of each digit, by chunk

Counts count_digits(const std::vector<std::uint64_t>& keys, int shift) {
  Counts counts((keys.size() + kSortChunk - 1) / kSortChunk);
  for_each_chunk(keys.size(), kSortChunk, [&](std::size_t begin, std::size_t end) {
    auto& count = counts[begin / kSortChunk];
    count.fill(0);
    for (std::size_t i = begin; i < end; ++i) ++count[digit_of(keys[i], shift)];
  });
  return counts;
}

// Moves what is in `from` to its places in `to` by one digit, stably.
void scatter(const Columns& from, Columns& to, int shift, Counts counts) {
  std::uint32_t total = 0;
  for (std::size_t digit = 0; digit < kRadix; ++digit)
    for (auto& count : counts) total += std::exchange(count[digit], total);
  for_each_chunk(from.keys.size(), kSortChunk, [&](std::size_t begin, std::size_t end) {
    auto& at = counts[begin / kSortChunk];
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t place = at[digit_of(from.keys[i], shift)]++;
      to.keys[place] = from.keys[i];
      to.values[place] = from.values[i];
    }
  });
}

// Sorts a range by the digits below `top`; the range of `room` is used up.
void sort_range(Columns& columns, Columns& room, std::size_t begin, std::size_t end, std::uint64_t varying,
                int top) {
  if (end - begin < kSmallRange) return sort_small(columns, begin, end);
  Columns* from = &columns;
  Columns* to = &room;
  for (int shift = 0; shift < top; shift += kDigitBits) {
    if (digit_of(varying, shift) == 0) continue;
    std::array<std::uint32_t, kRadix> at{};
    for (std::size_t i = begin; i < end; ++i) ++at[digit_of(from->keys[i], shift)];
    auto total = static_cast<std::uint32_t>(begin);
    for (std::uint32_t& count : at) total += std::exchange(count, total);
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t place = at[digit_of(from->keys[i], shift)]++;
      to->keys[place] = from->keys[i];
      to->values[place] = from->values[i];
    }
    std::swap(from, to);
  }
  if (from == &columns) return;
  std::copy_n(room.keys.data() + begin, end - begin, columns.keys.data() + begin);
  std::copy_n(room.values.data() + begin, end - begin, columns.values.data() + begin);
}

// By the highest digit first, then each part of its own, in the cache: where no part is large. False, with
// nothing done, where one is.
bool sort_by_parts(Columns& columns, Columns& room, std::uint64_t varying) {
  const int top = std::max(0, static_cast<int>(std::bit_width(varying)) - kDigitBits);
  Counts counts = count_digits(columns.keys, top);
  std::array<std::uint32_t, kRadix + 1> begin{};
  std::uint32_t largest = 0;
  for (std::size_t digit = 0; digit < kRadix; ++digit) {
    std::uint32_t total = 0;
    for (const auto& count : counts) total += count[digit];
    begin[digit + 1] = begin[digit] + total;
    largest = std::max(largest, total);
  }
  if (largest > std::max<std::size_t>(kLargestPart, columns.keys.size() / kFewestParts)) return false;
  scatter(columns, room, top, std::move(counts));
  std::swap(columns, room);
  for_each_chunk(kRadix, 1, [&](std::size_t digit, std::size_t) {
    sort_range(columns, room, begin[digit], begin[digit + 1], varying, top);
  });
  return true;
}

// By the lowest digit first, all keys at once.
void sort_by_passes(Columns& columns, Columns& room, std::uint64_t varying) {
  for (int shift = 0; shift < 64; shift += kDigitBits) {
    if (digit_of(varying, shift) == 0) continue;
    scatter(columns, room, shift, count_digits(columns.keys, shift));
    std::swap(columns, room);
  }
}

}  // namespace

void stable_sort_by_key(std::vector<std::uint64_t>& keys, std::vector<std::uint32_t>& values) {
  assert(keys.size() == values.size());
  Columns columns{std::move(keys), std::move(values)};
  const std::size_t size = columns.keys.size();
  if (size < kSmall) {
    sort_small(columns, 0, size);
  } else {
    const std::uint64_t varying = varying_bits(columns.keys);
    Columns room{std::vector<std::uint64_t>(size), std::vector<std::uint32_t>(size)};
    if (size < kMany || !sort_by_parts(columns, room, varying)) sort_by_passes(columns, room, varying);
  }
  keys = std::move(columns.keys);
  values = std::move(columns.values);
}

std::vector<std::uint32_t> sorted_order(std::vector<std::uint64_t> keys) {
  std::vector<std::uint32_t> order(keys.size());
  std::iota(order.begin(), order.end(), 0U);
  stable_sort_by_key(keys, order);
  return order;
}

}  // namespace quarry::parallel
