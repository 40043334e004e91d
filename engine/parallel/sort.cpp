#include "engine/parallel/sort.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <numeric>

#include "engine/parallel/parallel.hpp"

namespace quarry::parallel {
namespace {

constexpr std::size_t kRadix = 256;
constexpr std::size_t kSortChunk = 65536;
// Below this a comparison sort of pairs is faster than eight counting passes.
constexpr std::size_t kSmall = 8192;

void sort_small(std::vector<std::uint64_t>& keys, std::vector<std::uint32_t>& values) {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> pairs(keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i) pairs[i] = {keys[i], values[i]};
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t i = 0; i < keys.size(); ++i) std::tie(keys[i], values[i]) = pairs[i];
}

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

}  // namespace

void stable_sort_by_key(std::vector<std::uint64_t>& keys, std::vector<std::uint32_t>& values) {
  assert(keys.size() == values.size());
  const std::size_t size = keys.size();
  if (size < kSmall) {
    sort_small(keys, values);
    return;
  }
  const std::uint64_t varying = varying_bits(keys);
  const std::size_t chunk_count = (size + kSortChunk - 1) / kSortChunk;
  std::vector<std::array<std::uint32_t, kRadix>> offsets(chunk_count);
  std::vector<std::uint64_t> other_keys(size);
  std::vector<std::uint32_t> other_values(size);
  for (int shift = 0; shift < 64; shift += 8) {
    if (((varying >> shift) & (kRadix - 1)) == 0) continue;
    for_each_chunk(size, kSortChunk, [&](std::size_t begin, std::size_t end) {
      auto& count = offsets[begin / kSortChunk];
      count.fill(0);
      for (std::size_t i = begin; i < end; ++i) ++count[(keys[i] >> shift) & (kRadix - 1)];
    });
    std::uint32_t total = 0;
    for (std::size_t digit = 0; digit < kRadix; ++digit)
      for (auto& count : offsets) total += std::exchange(count[digit], total);
    for_each_chunk(size, kSortChunk, [&](std::size_t begin, std::size_t end) {
      auto& at = offsets[begin / kSortChunk];
      for (std::size_t i = begin; i < end; ++i) {
        const std::uint32_t to = at[(keys[i] >> shift) & (kRadix - 1)]++;
        other_keys[to] = keys[i];
        other_values[to] = values[i];
      }
    });
    keys.swap(other_keys);
    values.swap(other_values);
  }
}

std::vector<std::uint32_t> sorted_order(std::vector<std::uint64_t> keys) {
  std::vector<std::uint32_t> order(keys.size());
  std::iota(order.begin(), order.end(), 0U);
  stable_sort_by_key(keys, order);
  return order;
}

}  // namespace quarry::parallel
