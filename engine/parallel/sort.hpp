// Stable sorting of keys with their values, the same on any number of threads.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

namespace quarry::parallel {

// Sorts keys ascending and carries values along; equal keys keep their order. Both have the same size.
// A radix sort with digits of 8 bits: the highest digit first where that makes parts of similar size, which
// then fit a cache each, else the lowest first; digits that are the same everywhere are skipped.
void stable_sort_by_key(std::vector<std::uint64_t>& keys, std::vector<std::uint32_t>& values);

// The permutation that sorts keys ascending and stably: keys[order[0]] <= keys[order[1]] <= ...
[[nodiscard]] std::vector<std::uint32_t> sorted_order(std::vector<std::uint64_t> keys);

// Unsigned integers in the order of the doubles (no NaN; -0 comes before +0).
inline std::uint64_t ordered_bits(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  return (bits >> 63) != 0 ? ~bits : bits | (std::uint64_t{1} << 63);
}

}  // namespace quarry::parallel
