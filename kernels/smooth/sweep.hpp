// Sweeps over the vertices that still have something to gain: in place, one colour class after the other, the
// same on any number of threads. Regular regions cost one look.
#pragma once

#include <atomic>
#include <cstdint>
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

// Who is to be visited next: a byte a vertex, set by many threads at once.
class WakeList {
 public:
  explicit WakeList(std::size_t vertices) : awake_(vertices, 0) {}

  void wake(VertexId v) {
    std::atomic_ref<std::uint8_t>(awake_[v.value()]).store(1, std::memory_order_relaxed);
  }
  // The vertices awake, ascending; all sleep afterwards.
  std::vector<std::uint32_t> take() {
    std::vector<std::uint32_t> list =
        parallel::filter_indices(awake_.size(), [&](std::size_t i) { return awake_[i] != 0; });
    parallel::for_each(list.size(), [&](std::size_t i) { awake_[list[i]] = 0; });
    return list;
  }

 private:
  std::vector<std::uint8_t> awake_;
};

// A mover is copied for each chunk, so that it may own scratch memory, and has
//   bool wants(const Mesh&, VertexId);                // first look at every vertex: is it worth a visit?
//   bool move(Mesh&, VertexId);                       // true if the vertex moved; reads its star, writes
//   itself void wake(const Mesh&, VertexId, WakeList&);      // after a move: who should be visited in the
//   next sweep
inline constexpr std::size_t kSweepChunk = 256;

template <class Mover>
SweepReport run_sweeps(Mesh& mesh, VertexColouring& colouring, const Mover& mover, int sweeps,
                       const Progress& progress) {
  SweepReport report;
  WakeList list(mesh.vertex_slots());
  parallel::for_each_chunk(mesh.vertex_slots(), 4 * kSweepChunk, [&](std::size_t begin, std::size_t end) {
    Mover own = mover;
    for (std::size_t i = begin; i < end; ++i)
      if (own.wants(std::as_const(mesh), VertexId(i))) list.wake(VertexId(i));
  });
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    progress.throw_if_cancelled();
    const std::vector<std::uint32_t> active = list.take();
    if (active.empty()) break;
    ++report.sweeps;
    report.visited += active.size();
    colouring.extend(active);
    for (const std::vector<std::uint32_t>& members : colouring.classes(active)) {
      report.moved += parallel::reduce_ordered(
          members.size(), std::uint64_t{0},
          [&](std::size_t begin, std::size_t end) {
            Mover own = mover;
            std::uint64_t moved = 0;
            for (std::size_t i = begin; i < end; ++i) {
              const VertexId v(members[i]);
              if (!own.move(mesh, v)) continue;
              ++moved;
              own.wake(std::as_const(mesh), v, list);
            }
            return moved;
          },
          [](std::uint64_t a, std::uint64_t b) { return a + b; }, kSweepChunk);
    }
  }
  return report;
}

}  // namespace quarry
