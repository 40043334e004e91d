#include "engine/geometry/hilbert.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace quarry {
namespace {

template <std::size_t Dimension>
using Cell = std::array<std::uint32_t, Dimension>;

std::uint32_t cell_number(double offset, double side, unsigned order) {
  const double cells = static_cast<double>(std::uint32_t{1} << order);
  if (!(side > 0)) return 0;
  return static_cast<std::uint32_t>(std::clamp(offset / side * cells, 0.0, cells - 1));
}

// Each bit says whether the bits above it have an odd sum.
std::uint32_t parity_above(std::uint32_t bits) {
  std::uint32_t parity = bits >> 1;
  for (unsigned shift = 1; shift < 32; shift *= 2) parity ^= parity >> shift;
  return parity;
}

// Turns the coordinates of a cell into its key, with bit k of each number holding one digit of the key
// (Skilling's "transposed" form). From the highest bit down, the bits below are exchanged or inverted
// according to the bit. Written with masks, for the bits of ordinary points defeat branch prediction.
template <std::size_t Dimension>
Cell<Dimension> transposed_key(Cell<Dimension> x, unsigned order) {
  for (unsigned bit = order - 1; bit > 0; --bit) {
    const std::uint32_t below = (std::uint32_t{1} << bit) - 1;
    for (std::size_t i = 0; i < Dimension; ++i) {
      const std::uint32_t invert = (0U - ((x[i] >> bit) & 1U)) & below;
      const std::uint32_t exchange = (x[0] ^ x[i]) & below & ~invert;
      x[0] ^= invert | exchange;
      x[i] ^= exchange;
    }
  }
  for (std::size_t i = 1; i < Dimension; ++i) x[i] ^= x[i - 1];
  const std::uint32_t parity = parity_above(x[Dimension - 1]);
  for (std::uint32_t& digit : x) digit ^= parity;
  return x;
}

// Blocks of ones, `block` wide, that begin `dimension` blocks apart.
constexpr std::uint64_t spaced_blocks(unsigned block, unsigned dimension) {
  std::uint64_t mask = 0;
  for (unsigned bit = 0; bit < 64; ++bit)
    if (bit / block % dimension == 0) mask |= std::uint64_t{1} << bit;
  return mask;
}

// Moves bit k to bit k * Dimension.
template <unsigned Dimension, unsigned Block = 16>
constexpr std::uint64_t spread(std::uint64_t bits) {
  if constexpr (Block == 0) {
    return bits;
  } else {
    constexpr std::uint64_t kMask = spaced_blocks(Block, Dimension);
    return spread<Dimension, Block / 2>((bits | bits << (Block * (Dimension - 1))) & kMask);
  }
}

template <std::size_t Dimension>
std::uint64_t key_of(const Cell<Dimension>& cell, unsigned order) {
  std::uint64_t key = 0;
  for (const std::uint32_t digits : transposed_key<Dimension>(cell, order))
    key = key << 1 | spread<Dimension>(digits);
  return key;
}

}  // namespace

std::uint64_t hilbert_key(Vec2 p, const Box2& box) {
  const double side = box.longer_side();
  return key_of<2>({cell_number(p.x - box.low.x, side, kHilbertOrder2),
                    cell_number(p.y - box.low.y, side, kHilbertOrder2)},
                   kHilbertOrder2);
}

std::uint64_t hilbert_key(Vec3 p, const Box3& box) {
  const double side = box.longest_side();
  return key_of<3>(
      {cell_number(p.x - box.low.x, side, kHilbertOrder3), cell_number(p.y - box.low.y, side, kHilbertOrder3),
       cell_number(p.z - box.low.z, side, kHilbertOrder3)},
      kHilbertOrder3);
}

}  // namespace quarry
