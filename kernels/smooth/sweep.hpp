// Sweeps over the vertices that still have something to gain: in place, block by block and between blocks one
// colour class after the other, the same on any number of threads. Regular regions cost one look.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "engine/base/progress.hpp"
#include "engine/mesh/mesh.hpp"
#include "engine/operation/colour.hpp"
#include "engine/parallel/parallel.hpp"

namespace quarry {

struct SweepReport {
  std::uint64_t sweeps = 0;
  std::uint64_t visited = 0;  // vertices looked at, over all sweeps but the first look
  std::uint64_t moved = 0;    // accepted moves
};
inline void add(SweepReport& sum, const SweepReport& part) {
  sum.sweeps += part.sweeps;
  sum.visited += part.visited;
  sum.moved += part.moved;
}

// Who is to be visited next: a byte a vertex, set by many threads at once.
class WakeList {
 public:
  // Vertices that may_move(VertexId) refuses sleep for ever.
  template <class MayMove>
  WakeList(std::size_t vertices, const MayMove& may_move) : state_(vertices) {
    parallel::for_each(vertices,
                       [&](std::size_t i) { state_[i] = may_move(VertexId(i)) ? kAsleep : kFrozen; });
  }

  [[nodiscard]] bool frozen(VertexId v) const { return state_[v.value()] == kFrozen; }
  void wake(VertexId v) {
    std::atomic_ref<std::uint8_t> state(state_[v.value()]);
    if (state.load(std::memory_order_relaxed) == kAsleep) state.store(kAwake, std::memory_order_relaxed);
  }
  // Wakes v and all that share a face with it: those whose stars a move of v changes.
  void wake_star(const Mesh& mesh, VertexId v) {
    wake(v);
    for_each_side_around(mesh, v, [&](SideId side) {
      for (SideId s = mesh.next(side); s != side; s = mesh.next(s)) wake(mesh.origin(s));
    });
  }
  // The vertices awake, ascending; all sleep afterwards.
  std::vector<std::uint32_t> take() {
    std::vector<std::uint32_t> list =
        parallel::filter_indices(state_.size(), [&](std::size_t i) { return state_[i] == kAwake; });
    parallel::for_each(list.size(), [&](std::size_t i) { state_[list[i]] = kAsleep; });
    return list;
  }

 private:
  static constexpr std::uint8_t kAsleep = 0, kAwake = 1, kFrozen = 2;
  std::vector<std::uint8_t> state_;
};

// A mover is copied for each chunk, so that it may own scratch memory, and has
//   bool may_move(VertexId) const;
//   void first_look(const Mesh&, WakeList&) const;  // wakes who is worth a visit in the first sweep
//   bool move(Mesh&, VertexId);             // true if the vertex moved; reads its star, writes itself
inline constexpr std::size_t kSweepChunk = 256;

// Wakes the corners of the faces for which wants(FaceId) holds.
template <class Wants>
void wake_corners(const Mesh& mesh, WakeList& list, const Wants& wants) {
  parallel::for_each(mesh.face_slots(), [&](std::size_t i) {
    const FaceId f(i);
    if (!mesh.alive(f) || !wants(f)) return;
    for (int k = 0; k < mesh.corner_count(f); ++k) list.wake(mesh.corner(f, k));
  });
}

// Blocks of consecutive vertices. Where numbers follow a curve through space (engine/mesh/compact) a block is
// an area that fits the cache of a core, and most of its vertices share faces with others of it alone.
class SweepBlocks {
 public:
  explicit SweepBlocks(const Mesh& mesh) : mesh_(&mesh), inside_(mesh.vertex_slots(), kUnknown) {}

  [[nodiscard]] std::size_t count() const { return (inside_.size() + kSize - 1) / kSize; }
  // Those of a block among vertices that ascend.
  [[nodiscard]] static std::span<const std::uint32_t> of_block(std::size_t block,
                                                               const std::vector<std::uint32_t>& vertices) {
    const auto begin = std::lower_bound(vertices.begin(), vertices.end(), block * kSize);
    return {begin, std::lower_bound(begin, vertices.end(), (block + 1) * kSize)};
  }
  // Whether all vertices that share a face with v are of its block. Not to be asked about one by two threads.
  [[nodiscard]] bool inside(VertexId v) {
    std::uint8_t& known = inside_[v.value()];
    if (known == kUnknown) known = look(v) ? kInside : kAtBorder;
    return known == kInside;
  }

 private:
  static constexpr std::size_t kSize = 2048;
  static constexpr std::uint8_t kUnknown = 0, kInside = 1, kAtBorder = 2;

  [[nodiscard]] bool look(VertexId v) const {
    bool result = true;
    for_each_side_around(*mesh_, v, [&](SideId side) {
      for (SideId s = mesh_->next(side); s != side; s = mesh_->next(s))
        result = result && mesh_->origin(s).value() / kSize == v.value() / kSize;
    });
    return result;
  }

  const Mesh* mesh_;
  std::vector<std::uint8_t> inside_;
};

// Moves these one after the other, by a mover of one's own; returns how many moved.
template <class Mover>
std::uint64_t move_each(Mesh& mesh, WakeList& list, Mover mover, std::span<const std::uint32_t> vertices) {
  std::uint64_t moved = 0;
  for (const std::uint32_t i : vertices) {
    const VertexId v(i);
    if (!mover.move(mesh, v)) continue;
    ++moved;
    list.wake_star(mesh, v);
  }
  return moved;
}

struct InsideSweep {
  std::uint64_t moved = 0;
  std::vector<std::uint32_t> rest;  // those that are at the border of their block, ascending
};

// Moves the active vertices (ascending) that lie inside blocks.
template <class Mover>
InsideSweep sweep_inside_blocks(Mesh& mesh, SweepBlocks& blocks, WakeList& list, const Mover& mover,
                                const std::vector<std::uint32_t>& active) {
  return parallel::reduce_ordered(
      blocks.count(), InsideSweep(),
      [&](std::size_t block, std::size_t) {
        InsideSweep result;
        std::vector<std::uint32_t> inside;
        for (const std::uint32_t v : SweepBlocks::of_block(block, active))
          (blocks.inside(VertexId(v)) ? inside : result.rest).push_back(v);
        result.moved = move_each(mesh, list, mover, inside);
        return result;
      },
      [](InsideSweep sum, const InsideSweep& part) {
        sum.moved += part.moved;
        sum.rest.insert(sum.rest.end(), part.rest.begin(), part.rest.end());
        return sum;
      },
      1);
}

// Each sweep: first the vertices inside blocks, block by block, then those between blocks, by colours.
template <class Mover>
SweepReport run_sweeps(Mesh& mesh, VertexColouring& colouring, const Mover& mover, int sweeps,
                       const Progress& progress) {
  SweepReport report;
  if (sweeps <= 0) return report;
  WakeList list(mesh.vertex_slots(), [&](VertexId v) { return mover.may_move(v); });
  mover.first_look(std::as_const(mesh), list);
  SweepBlocks blocks(mesh);
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    progress.throw_if_cancelled();
    const std::vector<std::uint32_t> active = list.take();
    if (active.empty()) break;
    ++report.sweeps;
    report.visited += active.size();
    const auto [moved, rest] = sweep_inside_blocks(mesh, blocks, list, mover, active);
    report.moved += moved;
    colouring.extend(rest);
    for (const std::vector<std::uint32_t>& members : colouring.classes(rest)) {
      report.moved += parallel::reduce_ordered(
          members.size(), std::uint64_t{0},
          [&](std::size_t begin, std::size_t end) {
            return move_each(mesh, list, mover, std::span(members).subspan(begin, end - begin));
          },
          [](std::uint64_t a, std::uint64_t b) { return a + b; }, kSweepChunk);
    }
  }
  return report;
}

}  // namespace quarry
