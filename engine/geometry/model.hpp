// What meshing kernels may ask of the domain that they mesh. A kernel written against the concept runs on the
// plane and on a surface; what the model answers decides where points may lie and which side is up.
#pragma once

#include <concepts>

#include "engine/geometry/predicates.hpp"
#include "engine/geometry/space_point.hpp"
#include "engine/geometry/vec.hpp"

namespace quarry {

// Model::Point: a position in the plane (Vec2), or one in space with the normal there (SpacePoint).
// project(p): the point of the domain nearest to p.
// normal(p): the unit normal of the domain at (the projection of) p.
// orientation(a, b, c): > 0 if a, b, c turn left seen from the side that the normal points to, < 0 if right.
// All are const and safe to call from many threads at once.
template <class Model>
concept GeometryModel = requires(const Model& model, const typename Model::Point& p) {
  { model.project(p) } -> std::same_as<typename Model::Point>;
  { model.normal(p) } -> std::same_as<Vec3>;
  { model.orientation(p, p, p) } -> std::same_as<double>;
};

// The plane: every point lies on it, and orientation is exact.
struct PlaneModel {
  using Point = Vec2;

  [[nodiscard]] Vec2 project(Vec2 p) const { return p; }
  [[nodiscard]] Vec3 normal(Vec2 /*p*/) const { return {0, 0, 1}; }
  [[nodiscard]] double orientation(Vec2 a, Vec2 b, Vec2 c) const { return orient2d(a, b, c); }
};

static_assert(GeometryModel<PlaneModel>);

// A surface in space, whatever it is made of: kernels are instantiated for this one class.
class SpaceModel {
 public:
  using Point = SpacePoint;

  virtual ~SpaceModel() = default;

  // The nearest point of the part of the surface whose normals turn by less than a right angle from p.up,
  // with the normal there (of length 1).
  [[nodiscard]] virtual SpacePoint project(const SpacePoint& p) const = 0;

  [[nodiscard]] static Vec3 normal(const SpacePoint& p) {
    const double size = length(p.up);
    return size > 0 ? (1 / size) * p.up : Vec3{0, 0, 1};
  }
  // By the sum of the normals at the three.
  [[nodiscard]] static double orientation(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c) {
    return dot(cross(b.place - a.place, c.place - a.place), a.up + b.up + c.up);
  }
};

static_assert(GeometryModel<SpaceModel>);

}  // namespace quarry
