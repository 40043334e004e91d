// The neighbourhood of a point of the domain as places in the plane, so that what moves vertices is written
// once: on the plane differences of coordinates, on a surface coordinates in the tangent plane at the point.
#pragma once

#include <cmath>
#include <cstdint>
#include <type_traits>

#include "engine/geometry/model.hpp"
#include "engine/operation/editor.hpp"

namespace quarry {

// A direction of length 1 across a normal of length 1. The axis of coordinates that is least along the normal
// gives it without cancellation.
inline Vec3 any_tangent(Vec3 normal) {
  const Vec3 size{std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)};
  Vec3 axis{0, 0, 1};
  if (size.x <= size.y && size.x <= size.z)
    axis = {1, 0, 0};
  else if (size.y <= size.z)
    axis = {0, 1, 0};
  const Vec3 across = axis - dot(axis, normal) * normal;
  return (1.0 / length(across)) * across;
}

template <class Point>
class TangentFrame;

template <>
class TangentFrame<Vec2> {
 public:
  TangentFrame(Vec2 place, Vec3 /*normal*/) : place_(place) {}
  [[nodiscard]] Vec2 relative(Vec2 p) const { return p - place_; }
  [[nodiscard]] Vec2 at(Vec2 offset) const { return place_ + offset; }

 private:
  Vec2 place_;
};

template <>
class TangentFrame<SpacePoint> {
 public:
  // normal: of length 1. The frame turns left seen from where it points to.
  TangentFrame(const SpacePoint& point, Vec3 normal)
      : place_(point.place), up_(normal), found_at_(point.found_at) {
    first_ = any_tangent(normal);
    second_ = cross(normal, first_);
  }
  [[nodiscard]] Vec2 relative(const SpacePoint& p) const {
    const Vec3 edge = p.place - place_;
    return {dot(edge, first_), dot(edge, second_)};
  }
  [[nodiscard]] SpacePoint at(Vec2 offset) const {
    return {place_ + offset.x * first_ + offset.y * second_, up_, found_at_};
  }

 private:
  Vec3 place_, up_, first_, second_;
  std::uint32_t found_at_;
};

// The frame of a model at one of its points.
template <GeometryModel Model>
TangentFrame<typename Model::Point> frame_at(const Model& model, const typename Model::Point& place) {
  return {place, model.normal(place)};
}

// Reads and writes a vertex as a point of the model; in space, with the mesh's normals.
template <class Point>
Point place_of(const MeshEditor& editor, VertexId v) {
  if constexpr (std::is_same_v<Point, Vec2>)
    return editor.point(v);
  else
    return {editor.point3(v), editor.get(editor.mesh().normals(), v)};
}
inline void set_place(MeshEditor& editor, VertexId v, Vec2 p) { editor.set_point(v, p); }
inline void set_place(MeshEditor& editor, VertexId v, const SpacePoint& p) {
  editor.set_point3(v, p.place);
  editor.set(editor.mesh().normals(), v, p.up);
}

}  // namespace quarry
