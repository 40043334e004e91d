// The triangles around a vertex of a surface mesh that is about to move.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "surface/remesh/state.hpp"

namespace quarry {

// Keeps its memory from vertex to vertex.
class MovingStar {
 public:
  struct Corner {
    std::array<VertexId, 3> ids;  // the vertex first
    std::array<Vec3, 3> points;
  };

  explicit MovingStar(const RemeshState& state) : state_(&state), guard_(state.guard()) {}

  void gather(VertexId v) {
    corners_.clear();
    for_each_side_around(state_->mesh, v, [&](SideId s) {
      const std::array ids{v, state_->mesh.target(s), state_->mesh.origin(state_->mesh.previous(s))};
      corners_.push_back({ids, state_->points(ids)});
    });
    place_ = state_->point(v);
    worst_ = worst_at(place_);
  }
  [[nodiscard]] const std::vector<Corner>& corners() const { return corners_; }

  [[nodiscard]] double worst() const { return worst_; }
  // Lo's measure of the worst triangle, were the vertex there.
  [[nodiscard]] double worst_at(Vec3 p) const {
    double worst = 1;
    for (const Corner& c : corners_) worst = std::min(worst, lo_measure(p, c.points[1], c.points[2]));
    return worst;
  }

  // Whether the vertex may go there, where the surface has that normal: no triangle turns over, and the worst
  // does not become worse where it is below `content`.
  [[nodiscard]] bool fits(Vec3 target, Vec3 normal, double content) const {
    const double worst = worst_at(target);
    if (worst < content && worst < worst_) return false;
    return std::all_of(corners_.begin(), corners_.end(), [&](const Corner& c) {
      const Vec3 n = unit_normal(target, c.points[1], c.points[2]);
      const Vec3 before = unit_normal(place_, c.points[1], c.points[2]);
      return !(n == Vec3()) && guard_.agrees(n, normal) && guard_.agrees(n, before) &&
             guard_.agrees(n, state_->normals[c.ids[1]]) && guard_.agrees(n, state_->normals[c.ids[2]]) &&
             (!(normal == Vec3()) || guard_.knows(std::array{c.ids[1], c.ids[2]}) ||
              guard_.faces_along_surface(n, {target, c.points[1], c.points[2]}));
    });
  }

 private:
  const RemeshState* state_;
  TriangleGuard guard_;
  std::vector<Corner> corners_;
  Vec3 place_;
  double worst_ = 0;
};

}  // namespace quarry
