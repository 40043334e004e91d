// Counter-based random numbers: a value is a pure function of a seed and a counter, so that what an item
// draws depends on the item alone, never on who came before it or on which thread runs it.
#pragma once

#include <cstdint>

namespace quarry {

// A bijection of 32-bit words with good avalanche (the "lowbias32" constants of C. Wellons). Distinct inputs
// give distinct outputs, which is what makes ranks free of ties.
constexpr std::uint32_t mix32(std::uint32_t x) {
  x ^= x >> 16;
  x *= 0x7feb352dU;
  x ^= x >> 15;
  x *= 0x846ca68bU;
  x ^= x >> 16;
  return x;
}

// A bijection of 64-bit words (the finaliser of SplitMix64: Steele, Lea & Flood 2014).
constexpr std::uint64_t mix64(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

// Uniform in [0, 1), a function of seed and counter.
constexpr double uniform01(std::uint64_t seed, std::uint64_t counter) {
  return static_cast<double>(mix64(mix64(seed) ^ counter) >> 11) * 0x1.0p-53;
}

}  // namespace quarry
