// The code of LocalSmoother, for those who instantiate it for a model of their own; for the plane that is
// done in local_smoother.cpp.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>

#include "engine/parallel/parallel.hpp"
#include "kernels/quality/element.hpp"
#include "kernels/quality/space_face.hpp"
#include "kernels/smooth/local_smoother.hpp"

namespace quarry {
namespace local_smoother {

inline constexpr std::size_t kSmoothChunk = 256;

// How far to go along each Newton step: successive over-relaxation. On blocks of 9 to 1,521 vertices flat
// ones settle soonest at 1.7 and bent ones at 2.1.
inline constexpr double kRelaxation = 1.9;
// The reach of one step, as a share of the edges at the vertex.
inline constexpr double kReach = 0.6;
inline constexpr int kAttempts = 5;
// eps of the first untangling sweep and how it shrinks.
inline constexpr double kFirstRegularisation = 0.3;
inline constexpr double kShrinkage = 0.6;
inline constexpr double kLastRegularisation = 1e-2;
// In space no face may become worse that is worse than this.
inline constexpr double kContentInSpace = 0.3;
// Where a corner has a smaller sine than this, eps is this share of the squared edges once untangled, too.
inline constexpr double kFlat = 0.15;

// Twice the area of the triangle or quad of these places, the first of which is the origin.
inline double doubled_area(Vec2 next, Vec2 opposite, Vec2 previous) {
  return cross(opposite, previous - next);
}

}  // namespace local_smoother

template <GeometryModel Model>
double LocalSmoother<Model>::run(MeshEditor& editor, std::span<const VertexId> movable,
                                 const LocalShapeOptions& options) {
  gather(editor, movable);
  find_mean_area();
  areas_.clear();
  if (options.area_averages != LocalShapeOptions::kAllAlike) find_areas(options.area_averages);
  star_ = ShapeStar(options.target);
  smallest_move_ = options.smallest_move;
  if (movable.size() >= kParallel) colour();
  awake_.assign(movable.size(), 1);
  bool valid = all_valid();
  double regularisation = local_smoother::kFirstRegularisation;
  for (int i = 0; i < options.untangling_sweeps && !valid; ++i) {
    sweep(regularisation);
    regularisation =
        std::max(local_smoother::kShrinkage * regularisation, local_smoother::kLastRegularisation);
    valid = all_valid();
  }
  awake_.assign(movable.size(), 1);
  for (int i = 0; i < options.sweeps; ++i)
    if (sweep(0) == 0) break;
  for (std::size_t i = 0; i < movable.size(); ++i) set_place(editor, movable[i], points_[i]);
  double smallest = 1;
  for (const FaceNumbers& face : faces_) smallest = std::min(smallest, quality(face));
  return smallest;
}

template <GeometryModel Model>
void LocalSmoother<Model>::gather(const MeshEditor& editor, std::span<const VertexId> movable) {
  numbers_.clear(3 * movable.size());
  points_.clear();
  begin_.clear();
  corners_.clear();
  faces_.clear();
  classes_.clear();
  for (const VertexId v : movable) {
    [[maybe_unused]] const bool fresh = numbers_.number(v).second;
    assert(fresh && !editor.mesh().on_boundary(v));
    points_.push_back(place_of<Point>(editor, v));
  }
  begin_.push_back(0);
  for (std::size_t i = 0; i < movable.size(); ++i)
    gather_star(editor, movable[i], static_cast<std::uint32_t>(i));
}

template <GeometryModel Model>
void LocalSmoother<Model>::gather_star(const MeshEditor& editor, VertexId v, std::uint32_t i) {
  const Mesh& mesh = editor.mesh();
  const auto number = [&](VertexId w) {
    const auto [n, fresh] = numbers_.number(w);
    if (fresh) points_.push_back(place_of<Point>(editor, w));
    return n;
  };
  for_each_side_around(mesh, v, [&](SideId s) {
    const SideId forward = mesh.next(s);
    const std::uint32_t next = number(mesh.origin(forward));
    const bool quad = mesh.corner_count(s.face()) == 4;
    corners_.push_back({next, quad ? number(mesh.target(forward)) : kNone});
  });
  begin_.push_back(static_cast<std::uint32_t>(corners_.size()));
  for_each_face(i, [&](std::uint32_t next, std::uint32_t opposite, std::uint32_t previous) {
    // Of the corners that move the one of smallest number stands for its face; the others have larger
    // numbers.
    if (std::min({next, opposite, previous}) > i) faces_.push_back({i, next, opposite, previous});
  });
}

// Each vertex gets the smallest colour that none of its face mates before it has: no two of a class share a
// face.
template <GeometryModel Model>
void LocalSmoother<Model>::colour() {
  const std::size_t count = begin_.size() - 1;
  std::vector<std::uint32_t> colours(count);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::uint32_t base = 0;; base += 64) {
      std::uint64_t used = 0;
      const auto mark = [&](std::uint32_t mate) {
        if (mate < i && colours[mate] - base < 64) used |= std::uint64_t{1} << (colours[mate] - base);
      };
      for (const StarCorner& corner : star_of(i)) {
        mark(corner.next);
        mark(corner.opposite);
      }
      if (~used == 0) continue;
      colours[i] = base + static_cast<std::uint32_t>(std::countr_one(used));
      break;
    }
    if (colours[i] >= classes_.size()) classes_.resize(colours[i] + 1);
    classes_[colours[i]].push_back(static_cast<std::uint32_t>(i));
  }
}

// Faces that are turned over count negative: the sum is the area of the region, whatever lies inside.
template <GeometryModel Model>
void LocalSmoother<Model>::find_mean_area() {
  double area = 0;
  double squares = 0;
  double count = 0;
  for (const FaceNumbers& face : faces_) {
    const bool quad = face[2] != kNone;
    const auto frame = frame_at(*model_, points_[face[0]]);
    const Vec2 next = frame.relative(points_[face[1]]);
    const Vec2 previous = frame.relative(points_[face[3]]);
    area +=
        0.5 * local_smoother::doubled_area(next, quad ? frame.relative(points_[face[2]]) : next, previous);
    squares += 0.5 * (squared_length(next) + squared_length(previous));
    count += quad ? 1 : 0.5;
  }
  // A region that is itself turned over has no area to share; its edges still tell a size.
  constexpr double kThin = 1e-6;
  area_ = std::max(area, kThin * squares) / std::max(count, 0.5);
}

// Of the faces around each vertex; then with those of the movable vertices around, and its own as all of
// them.
template <GeometryModel Model>
void LocalSmoother<Model>::find_areas(int averages) {
  const std::size_t count = begin_.size() - 1;
  areas_.resize(count);
  parallel::for_each(count, [&](std::size_t i) {
    const auto frame = frame_at(*model_, points_[i]);
    double area = 0, faces = 0;
    for_each_face(static_cast<std::uint32_t>(i), [&](std::uint32_t next, std::uint32_t opposite,
                                                     std::uint32_t previous) {
      const bool quad = opposite != kNone;
      const Vec2 out = frame.relative(points_[next]);
      area += 0.5 * std::abs(local_smoother::doubled_area(out, quad ? frame.relative(points_[opposite]) : out,
                                                          frame.relative(points_[previous])));
      faces += quad ? 1 : 0.5;
    });
    areas_[i] = area / std::max(faces, 0.5);
  });
  std::vector<double> before;
  for (int round = 0; round < averages; ++round) {
    before = areas_;
    parallel::for_each(count, [&](std::size_t i) {
      double sum = 0, weight = 0;
      for (const StarCorner& corner : star_of(i)) {
        if (corner.next >= count) continue;
        sum += before[corner.next];
        weight += 1;
      }
      if (weight > 0) areas_[i] = 0.5 * (before[i] + sum / weight);
    });
  }
}

template <GeometryModel Model>
bool LocalSmoother<Model>::valid(const FaceNumbers& face) const {
  const std::size_t corners = face[2] == kNone ? 3 : 4;
  std::array<std::uint32_t, 4> ring = face;
  if (corners == 3) ring[2] = face[3];
  if constexpr (kInSpace) return quality_in_space(face, points_[face[0]]) > 0;
  for (std::size_t k = 0; k < corners; ++k)
    if (!(model_->orientation(points_[ring[k]], points_[ring[(k + 1) % corners]],
                              points_[ring[(k + 2) % corners]]) > 0))
      return false;
  return true;
}

template <GeometryModel Model>
bool LocalSmoother<Model>::all_valid() const {
  return std::all_of(faces_.begin(), faces_.end(), [&](const FaceNumbers& face) { return valid(face); });
}

template <GeometryModel Model>
double LocalSmoother<Model>::quality(const FaceNumbers& face) const {
  if constexpr (kInSpace) return quality_in_space(face, points_[face[0]]);
  const std::size_t corners = face[2] == kNone ? 3 : 4;
  std::array<std::uint32_t, 4> ring = face;
  if (corners == 3) ring[2] = face[3];
  double smallest = 1;
  for (std::size_t k = 0; k < corners; ++k) {
    const auto frame = frame_at(*model_, points_[ring[k]]);
    const Vec2 out = frame.relative(points_[ring[(k + 1) % corners]]);
    const Vec2 back = frame.relative(points_[ring[(k + corners - 1) % corners]]);
    smallest = std::min(smallest, corner_scaled_jacobian(back, {}, out));
  }
  if (corners == 3) smallest *= 2 / kSqrt3;
  return smallest > 0 && !valid(face) ? 0 : smallest;
}

template <GeometryModel Model>
std::size_t LocalSmoother<Model>::sweep(double regularisation) {
  if (classes_.empty()) {
    std::size_t moved = 0;
    for (std::uint32_t i = 0; i + 1 < begin_.size(); ++i) moved += visit(i, regularisation, star_) ? 1 : 0;
    return moved;
  }
  std::size_t moved = 0;
  parallel::isolated([&] {
    for (const std::vector<std::uint32_t>& members : classes_) moved += move_all(members, regularisation);
  });
  return moved;
}

template <GeometryModel Model>
std::size_t LocalSmoother<Model>::move_all(std::span<const std::uint32_t> members, double regularisation) {
  return parallel::reduce_ordered(
      members.size(), std::size_t{0},
      [&](std::size_t begin, std::size_t end) {
        ShapeStar star = star_;
        std::size_t moved = 0;
        for (std::size_t k = begin; k < end; ++k) moved += visit(members[k], regularisation, star) ? 1 : 0;
        return moved;
      },
      [](std::size_t a, std::size_t b) { return a + b; }, local_smoother::kSmoothChunk);
}

template <GeometryModel Model>
bool LocalSmoother<Model>::visit(std::uint32_t i, double regularisation, ShapeStar& star) {
  if (awake_[i] == 0) return false;
  const bool moved = move(i, regularisation, star);
  // While the regularisation changes from sweep to sweep nobody sleeps.
  awake_[i] = moved || regularisation > 0 ? 1 : 0;
  if (!moved) return false;
  // Mates are of other classes; several threads may wake the same one.
  const auto wake = [&](std::uint32_t mate) {
    if (mate < awake_.size()) std::atomic_ref(awake_[mate]).store(1, std::memory_order_relaxed);
  };
  for (const StarCorner& corner : star_of(i)) {
    wake(corner.next);
    wake(corner.opposite);
  }
  return true;
}

template <GeometryModel Model>
bool LocalSmoother<Model>::move(std::uint32_t i, double regularisation, ShapeStar& star) {
  const auto frame = frame_at(*model_, points_[i]);
  const double area = areas_.empty() ? area_ : areas_[i];
  star.clear();
  for_each_face(i, [&](std::uint32_t next, std::uint32_t opposite, std::uint32_t previous) {
    const Vec2 out = frame.relative(points_[next]);
    const Vec2 back = frame.relative(points_[previous]);
    if (opposite == kNone)
      star.add_triangle(out, back, area);
    else
      star.add_quad(out, frame.relative(points_[opposite]), back, area);
  });
  const bool untangling = regularisation > 0;
  const double edge = star.mean_squared_edge();
  double eps = regularisation * area;
  if (!untangling) {
    star.follow_stretch();
    if (star.has_corner_below(local_smoother::kFlat)) eps = local_smoother::kFlat * edge;
  }
  const Quadratic here = star.expand(eps);
  Vec2 step = local_smoother::kRelaxation * here.step();
  if (squared_length(step) > local_smoother::kReach * local_smoother::kReach * edge)
    step = (local_smoother::kReach * std::sqrt(edge / squared_length(step))) * step;
  for (int attempt = 0; attempt < local_smoother::kAttempts; ++attempt, step = 0.5 * step) {
    if (!(squared_length(step) > smallest_move_ * smallest_move_ * edge)) return false;
    const Point target = model_->project(frame.at(step));
    // What lies farther from where the step led than the step was long is another sheet, or round an edge.
    if (kInSpace && squared_length(frame.relative(target) - step) > squared_length(step)) continue;
    if (!(star.value(frame.relative(target), eps) < here.value)) continue;
    if (!untangling && !keeps_valid(i, target)) continue;
    points_[i] = target;
    return true;
  }
  return false;
}

// With the first corner at a place of its own.
template <GeometryModel Model>
double LocalSmoother<Model>::quality_in_space(const FaceNumbers& face, const Point& first) const {
  if constexpr (kInSpace) {
    if (face[2] == kNone)
      return scaled_jacobian_in_space(std::array{first, points_[face[1]], points_[face[3]]});
    return scaled_jacobian_in_space(std::array{first, points_[face[1]], points_[face[2]], points_[face[3]]});
  } else {
    return 0;
  }
}

template <GeometryModel Model>
bool LocalSmoother<Model>::keeps_valid(std::uint32_t i, const Point& target) const {
  const Point& place = points_[i];
  if constexpr (kInSpace) {
    // The energy of the tangent plane may fall while the face in space folds.
    bool kept = true;
    for_each_face(i, [&](std::uint32_t next, std::uint32_t opposite, std::uint32_t previous) {
      if (!kept) return;
      const FaceNumbers face{i, next, opposite, previous};
      const double after = quality_in_space(face, target);
      kept = after >= local_smoother::kContentInSpace || after >= quality_in_space(face, place);
    });
    return kept;
  }
  // The vertex is the second of a corner's three points, by turning them.
  const auto keeps = [&](const Point& before, const Point& after) {
    return model_->orientation(before, target, after) > 0 || !(model_->orientation(before, place, after) > 0);
  };
  bool kept = true;
  for_each_face(i, [&](std::uint32_t next, std::uint32_t opposite, std::uint32_t previous) {
    kept = kept && keeps(points_[previous], points_[next]);
    if (opposite == kNone || !kept) return;
    kept = keeps(points_[opposite], points_[next]) && keeps(points_[previous], points_[opposite]);
  });
  return kept;
}

}  // namespace quarry
