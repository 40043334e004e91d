// A triangulated surface as what meshing kernels ask of a domain (engine/geometry/model.hpp): the nearest
// point, and the normal there, which turns smoothly from triangle to triangle but for features.
#pragma once

#include <vector>

#include "engine/geometry/model.hpp"
#include "surface/model/corner_normals.hpp"
#include "surface/project/triangle_tree.hpp"

namespace quarry {

class SurfaceModel {
 public:
  using Point = Vec3;

  // triangles: as make_sheets and bind_features leave them; not kept.
  SurfaceModel(const Mesh& triangles, const ConstraintTags& tags);

  // The nearest point of the surface, with the normal there (of length 1) and the triangle.
  struct Foot {
    Vec3 point, normal;
    TriangleId triangle;
  };
  [[nodiscard]] Foot foot(const Vec3& p) const;
  // The same of the part of the surface whose triangles turn less than 80 degrees from a direction; any if
  // there is none. near: a triangle that is thought to be close, which saves time and changes nothing.
  [[nodiscard]] Foot foot(const Vec3& p, const Vec3& towards, TriangleId near = {}) const;

  [[nodiscard]] Vec3 project(const Vec3& p) const { return foot(p).point; }
  [[nodiscard]] Vec3 normal(const Vec3& p) const { return foot(p).normal; }
  // By the normal in the middle of the three: corners on a sharp edge have no normal of their own.
  [[nodiscard]] double orientation(const Vec3& a, const Vec3& b, const Vec3& c) const {
    return dot(cross(b - a, c - a), normal((1.0 / 3) * (a + b + c)));
  }

 private:
  [[nodiscard]] Foot foot_of(const SurfacePoint& nearest) const;

  TriangleTree tree_;
  std::vector<CornerNormals> normals_;
};

static_assert(GeometryModel<SurfaceModel>);

}  // namespace quarry
