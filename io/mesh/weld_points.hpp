// Makes one point of those that are equal, for formats in which every face has points of its own. Equal means
// equal in all coordinates: no tolerance.
//
// A table of hashes is filled in parallel: the place of a point among its equals is a race, but what is kept
// there, the smallest corner of all, is not. So the result is the same on any number of threads and for any
// size of the table.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/base/random.hpp"
#include "engine/geometry/vec.hpp"
#include "engine/parallel/parallel.hpp"
#include "io/mesh/read_cells.hpp"

namespace quarry {

struct WeldedPoints {
  std::vector<std::uint32_t> number;  // of the point of each corner; points are numbered as they first appear
  std::vector<std::uint32_t> first;   // the first corner of each point, ascending
};

// One attempt with a table of so many slots, a power of two.
template <class PointAt>
class PointWelder {
 public:
  PointWelder(std::size_t corners, std::size_t slots, const PointAt& at)
      : at_(at), slots_(slots, kEmpty), slot_of_(corners), bounded_(slots < 2 * corners) {}

  // Nothing if the table is too small.
  std::optional<WeldedPoints> weld() {
    std::atomic<bool> full = false;
    parallel::for_each_chunk(slot_of_.size(), parallel::kChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end && !full.load(std::memory_order_relaxed); i += kBlock)
        if (!insert_block(i, std::min(end, i + kBlock))) full = true;
    });
    if (full) return std::nullopt;
    WeldedPoints result;
    result.first =
        parallel::filter_indices(slot_of_.size(), [&](std::size_t i) { return slots_[slot_of_[i]] == i; });
    parallel::for_each(result.first.size(), [&](std::size_t k) {
      slots_[slot_of_[result.first[k]]] = static_cast<std::uint32_t>(k);
    });
    parallel::for_each(slot_of_.size(), [&](std::size_t i) { slot_of_[i] = slots_[slot_of_[i]]; });
    result.number = std::move(slot_of_);
    return result;
  }

 private:
  static constexpr std::uint32_t kEmpty = 0xffffffff;
  // A run as long as this shows a table that is nearly full.
  static constexpr std::size_t kMostProbes = 64;
  static constexpr std::size_t kBlock = 64;

  [[nodiscard]] std::size_t hash(Vec3 p) const {
    const auto x = std::bit_cast<std::uint64_t>(p.x);
    const auto y = std::bit_cast<std::uint64_t>(p.y);
    const auto z = std::bit_cast<std::uint64_t>(p.z);
    return mix64(x ^ std::rotl(y * 0x9e3779b97f4a7c15ULL, 21) ^ std::rotl(z * 0xd6e8feb86659fd93ULL, 42));
  }

  // The slots of a block are asked for before the first is looked at: the table does not fit into a cache.
  bool insert_block(std::size_t begin, std::size_t end) {
    std::array<Vec3, kBlock> points;
    std::array<std::size_t, kBlock> slots;
    for (std::size_t i = begin; i < end; ++i) {
      points[i - begin] = at_(i);
      slots[i - begin] = hash(points[i - begin]) & (slots_.size() - 1);
      __builtin_prefetch(&slots_[slots[i - begin]]);
    }
    for (std::size_t i = begin; i < end; ++i)
      if (!insert(static_cast<std::uint32_t>(i), points[i - begin], slots[i - begin])) return false;
    return true;
  }

  // Puts a corner into the slot of its point, which keeps the smallest; false if it finds none.
  bool insert(std::uint32_t corner, Vec3 p, std::size_t slot) {
    // Without a bound there are twice as many slots as corners, so that an empty one comes.
    for (std::size_t probe = 0; !bounded_ || probe < kMostProbes; ++probe) {
      std::atomic_ref<std::uint32_t> word(slots_[slot]);
      std::uint32_t seen = word.load(std::memory_order_relaxed);
      if (seen == kEmpty && word.compare_exchange_strong(seen, corner, std::memory_order_relaxed))
        seen = corner;
      if (seen == corner || at_(seen) == p) {
        while (corner < seen && !word.compare_exchange_weak(seen, corner, std::memory_order_relaxed)) {
        }
        slot_of_[corner] = static_cast<std::uint32_t>(slot);
        return true;
      }
      slot = (slot + 1) & (slots_.size() - 1);
    }
    return false;
  }

  const PointAt& at_;
  std::vector<std::uint32_t> slots_;    // a corner of the point; at last the number of the point
  std::vector<std::uint32_t> slot_of_;  // by corner; at last the number of its point
  bool bounded_;
};

// point_at(i) is the point of corner i, as a Vec3 without negative zeros.
template <class PointAt>
WeldedPoints weld_points(std::size_t corners, const PointAt& point_at) {
  // Closed triangulations have a point for every six corners: such a table is half full.
  const std::size_t usual = std::bit_ceil(std::max<std::size_t>(corners / 3, 16));
  if (auto welded = PointWelder(corners, usual, point_at).weld()) return std::move(*welded);
  return std::move(*PointWelder(corners, std::bit_ceil(2 * corners), point_at).weld());
}

// Triangles of three corners each, without their regions.
template <class PointAt>
ReadCells weld_triangles(std::size_t corners, const PointAt& point_at) {
  const WeldedPoints welded = weld_points(corners, point_at);
  ReadCells cells;
  for (auto* coordinate : {&cells.x, &cells.y, &cells.z}) coordinate->resize(welded.first.size());
  parallel::for_each(welded.first.size(), [&](std::size_t k) {
    const Vec3 p = point_at(welded.first[k]);
    cells.x[k] = p.x;
    cells.y[k] = p.y;
    cells.z[k] = p.z;
  });
  cells.faces.resize(corners / 3);
  parallel::for_each(corners / 3, [&](std::size_t f) {
    for (std::size_t k = 0; k < 3; ++k) cells.faces[f][k] = VertexId(welded.number[3 * f + k]);
  });
  return cells;
}

}  // namespace quarry
