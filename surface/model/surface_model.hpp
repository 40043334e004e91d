// A triangulated surface as what meshing kernels ask of a domain (engine/geometry/model.hpp): the nearest
// point, and the normal there, which turns smoothly from triangle to triangle but for features.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "engine/geometry/model.hpp"
#include "surface/model/corner_normals.hpp"
#include "surface/project/triangle_tree.hpp"

namespace quarry {

// Parts of two surfaces whose normals have a smaller cosine, that of 80 degrees, are not near each other,
// however close they lie: a wall's other side turns by 180.
inline constexpr double kSameSide = 0.17;

class SurfaceModel : public SpaceModel {
 public:
  // triangles: as make_sheets and bind_features leave them; not kept. spacing: of its own points along edges,
  // in input units.
  SurfaceModel(const Mesh& triangles, const ConstraintTags& tags,
               double spacing = std::numeric_limits<double>::infinity());

  // The nearest point of the part of the surface whose triangles turn less than 80 degrees from p.up; of all
  // of it if there is none, or no direction is given (zero).
  [[nodiscard]] SpacePoint project(const SpacePoint& p) const override;
  // In two steps: the point and its triangle, and the normal there.
  [[nodiscard]] SurfacePoint nearest(const SpacePoint& p) const;
  [[nodiscard]] SpacePoint with_normal(const SurfacePoint& p) const;
  // False if all of the surface that lies about as near to a place as its nearest point faces away from the
  // direction: what faces so there lies upside down. About as near: farther by no more than the slack, and,
  // were the surface flat, within the reach of that point (both in input units).
  [[nodiscard]] bool faces_along(Vec3 place, Vec3 direction, double slack,
                                 double reach = std::numeric_limits<double>::infinity()) const;

  // Its own points that are on no feature, with the normals there: vertices, and points in the spacing along
  // all edges that are longer than it, one after the other; farther apart where slivers would get more than
  // four for each square of the spacing. What is farthest from another surface lies on edges, as a rule.
  [[nodiscard]] std::span<const SpacePoint> free_points() const { return free_points_; }

 private:
  void add_edge_points(const Mesh& triangles, const ConstraintTags& tags, double spacing);

  TriangleTree tree_;
  std::vector<CornerNormals> normals_;
  std::vector<SpacePoint> free_points_;
};

}  // namespace quarry
