#include "kernels/smooth/square_together.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <memory>
#include <span>

#include "engine/parallel/parallel.hpp"
#include "engine/parallel/scratch_pool.hpp"
#include "kernels/smooth/star.hpp"

namespace quarry {
namespace {

// Vertices a block: its system fits the cache of a core, and little of it is border.
constexpr std::size_t kBlock = 4096;
// How far from faces that are not content a step reaches, in rings of vertices.
constexpr int kRings = 8;
// Vertices of faces of a smaller measure stay where they are: the derivatives of nearly flat corners are so
// steep that nothing else would count. Sweeps over single vertices help them.
constexpr double kPoor = 0.01;
constexpr std::uint8_t kStays = 3;

void store(std::uint8_t& byte, std::uint8_t value) {
  std::atomic_ref<std::uint8_t>(byte).store(value, std::memory_order_relaxed);
}
std::uint8_t load(std::uint8_t& byte) {
  return std::atomic_ref<std::uint8_t>(byte).load(std::memory_order_relaxed);
}

}  // namespace

void SquareTogether::choose_active() {
  const double content = options_.content * options_.content;
  Mesh& mesh = *mesh_;
  active_.assign(mesh.vertex_slots(), 0);
  std::vector<std::uint8_t> poor(mesh.vertex_slots(), 0);
  parallel::for_each(mesh.face_slots(), [&](std::size_t i) {
    const FaceId f(i);
    if (!mesh.alive(f)) return;
    const double measure = Star::measure_of(mesh, f);
    if (measure >= content) return;
    for (int k = 0; k < mesh.corner_count(f); ++k) {
      store(active_[mesh.corner(f, k).value()], 1);
      if (!(measure >= kPoor)) store(poor[mesh.corner(f, k).value()], 1);
    }
  });
  for (int ring = 1; ring <= kRings; ++ring) {
    const auto inner = static_cast<std::uint8_t>(ring);
    const std::vector<std::uint32_t> border =
        parallel::filter_indices(active_.size(), [&](std::size_t i) { return active_[i] == inner; });
    parallel::for_each(border.size(), [&](std::size_t i) {
      for_each_side_around(mesh, VertexId(border[i]), [&](SideId side) {
        for (SideId s = mesh.next(side); s != side; s = mesh.next(s)) {
          std::uint8_t& outer = active_[mesh.origin(s).value()];
          if (load(outer) == 0) store(outer, inner + 1);
        }
      });
    });
  }
  parallel::for_each(poor.size(), [&](std::size_t i) {
    if (poor[i] != 0) active_[i] = 0;
  });
}

void SquareTogether::find_steps() {
  steps_.assign(mesh_->vertex_slots(), Step{});
  ScratchPool<SquareStep> pool(
      [&] { return std::make_unique<SquareStep>(*mesh_, *slide_, *demands_, options_.spring); });
  const std::size_t shift = rounds_ % 2 == 0 ? 0 : kBlock / 2;
  const std::size_t size = mesh_->vertex_slots();
  parallel::for_each_chunk(size + shift, kBlock, [&](std::size_t begin, std::size_t end) {
    ScratchPool<SquareStep>::Loan step(pool);
    step->solve(VertexId(std::max(begin, shift) - shift), VertexId(end - shift), active_);
    step->for_each_step([&](VertexId v, Vec2 by) {
      steps_[v.value()] = {static_cast<float>(by.x), static_cast<float>(by.y)};
    });
  });
}

void SquareTogether::place(VertexId v) {
  const std::size_t i = v.value();
  const double share = 1.0 / (1 << halvings_[i]);
  const Vec2 step{static_cast<double>(steps_[i].x), static_cast<double>(steps_[i].y)};
  mesh_->set_point(v, halvings_[i] == kStays ? before_[i] : slide_->allowed(v, before_[i] + share * step));
}

void SquareTogether::go() {
  const std::size_t size = mesh_->vertex_slots();
  before_.resize(size);
  halvings_.resize(size);
  marked_.assign(size, 0);
  parallel::for_each(size, [&](std::size_t i) {
    const VertexId v(i);
    before_[i] = mesh_->point(v);
    const bool moves = steps_[i].x != 0 || steps_[i].y != 0;
    halvings_[i] = moves ? 0 : kStays;
    if (moves) place(v);
  });
}

bool SquareTogether::keeps(FaceId f) const {
  const auto corners = static_cast<std::size_t>(mesh_->corner_count(f));
  std::array<Vec2, 4> now, before;
  for (std::size_t k = 0; k < corners; ++k) {
    const VertexId v = mesh_->corner(f, static_cast<int>(k));
    now[k] = mesh_->point(v);
    before[k] = before_[v.value()];
  }
  return keeps_face(std::span(before).first(corners), std::span(now).first(corners),
                    options_.floor * options_.floor, options_.largest_edge_ratio);
}

void SquareTogether::mark_corners_unless_kept(FaceId f) {
  if (keeps(f)) return;
  for (int k = 0; k < mesh_->corner_count(f); ++k) store(marked_[mesh_->corner(f, k).value()], 1);
}

// Moves the vertices marked back by one halving; returns them.
std::vector<std::uint32_t> SquareTogether::step_back() {
  std::vector<std::uint32_t> changed = parallel::filter_indices(
      marked_.size(), [&](std::size_t i) { return marked_[i] != 0 && halvings_[i] != kStays; });
  parallel::for_each(changed.size(), [&](std::size_t i) {
    marked_[changed[i]] = 0;
    ++halvings_[changed[i]];
    place(VertexId(changed[i]));
  });
  return changed;
}

// Ends since a face all of whose corners stay is as it was.
std::uint64_t SquareTogether::run() {
  Mesh& mesh = *mesh_;
  choose_active();
  find_steps();
  ++rounds_;
  go();
  parallel::for_each(mesh.face_slots(), [&](std::size_t i) {
    const FaceId f(i);
    if (!mesh.alive(f)) return;
    bool moved = false;
    for (int k = 0; k < mesh.corner_count(f); ++k)
      moved = moved || halvings_[mesh.corner(f, k).value()] != kStays;
    if (moved) mark_corners_unless_kept(f);
  });
  for (auto changed = step_back(); !changed.empty(); changed = step_back())
    parallel::for_each(changed.size(), [&](std::size_t i) {
      for_each_side_around(mesh, VertexId(changed[i]), [&](SideId s) { mark_corners_unless_kept(s.face()); });
    });
  return parallel::reduce_ordered(
      halvings_.size(), std::uint64_t{0},
      [&](std::size_t begin, std::size_t end) {
        std::uint64_t count = 0;
        for (std::size_t i = begin; i < end; ++i) count += halvings_[i] != kStays ? 1U : 0U;
        return count;
      },
      [](std::uint64_t a, std::uint64_t b) { return a + b; });
}

}  // namespace quarry
