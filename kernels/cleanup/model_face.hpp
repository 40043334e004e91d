// The quality of a face as the verdict on an operation needs it: the scaled Jacobian in the terms of a
// geometry model, positive exactly where the face is valid.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <type_traits>

#include "engine/geometry/model.hpp"
#include "engine/mesh/mesh.hpp"
#include "engine/mesh/point_of.hpp"
#include "kernels/quality/space_face.hpp"

namespace quarry {

inline double size_of(double cross_product) { return std::abs(cross_product); }
inline double size_of(Vec3 cross_product) { return length(cross_product); }

// The sine of the corner at `here`. Its sign is that of the model's orientation, exact in the plane: positive
// if and only if the corner turns left, however small the sine.
template <GeometryModel Model>
[[nodiscard]] double signed_corner_sine(const Model& model, const typename Model::Point& previous,
                                        const typename Model::Point& here,
                                        const typename Model::Point& next) {
  const auto out = next - here;
  const auto back = previous - here;
  const double lengths = std::sqrt(dot(out, out) * dot(back, back));
  if (!(lengths > 0)) return -1;
  const double sine = size_of(cross(out, back)) / lengths;
  const double side = model.orientation(previous, here, next);
  if (side > 0) return std::max(sine, std::numeric_limits<double>::min());
  return side < 0 ? -sine : 0.0;
}

// The smallest corner sine of a quad, of a triangle that times 2 / sqrt(3) [Verdict]. Not positive if and
// only if the face is not valid.
template <GeometryModel Model>
[[nodiscard]] double signed_scaled_jacobian(const Mesh& mesh, const Model& model, FaceId f) {
  constexpr double kTriangleFactor = 1.1547005383792515;
  using Point = typename Model::Point;
  const int count = mesh.corner_count(f);
  Point corners[4];
  for (int i = 0; i < count; ++i) corners[i] = point_of<Point>(mesh, mesh.corner(f, i));
  if constexpr (std::is_same_v<Point, SpacePoint>)
    return scaled_jacobian_in_space(std::span(corners).first(static_cast<std::size_t>(count)));
  double smallest = 1;
  for (int i = 0; i < count; ++i)
    smallest = std::min(smallest, signed_corner_sine(model, corners[(i + count - 1) % count], corners[i],
                                                     corners[(i + 1) % count]));
  return count == 3 ? std::min(1.0, kTriangleFactor * smallest) : smallest;
}

// The longest edge of a face by its shortest; infinite where an edge has no length.
template <GeometryModel Model>
[[nodiscard]] double edge_ratio(const Mesh& mesh, FaceId f) {
  using Point = typename Model::Point;
  const int count = mesh.corner_count(f);
  double shortest = std::numeric_limits<double>::infinity();
  double longest = 0;
  for (int i = 0; i < count; ++i) {
    const auto edge =
        point_of<Point>(mesh, mesh.corner(f, (i + 1) % count)) - point_of<Point>(mesh, mesh.corner(f, i));
    shortest = std::min(shortest, dot(edge, edge));
    longest = std::max(longest, dot(edge, edge));
  }
  return std::sqrt(longest / shortest);
}

}  // namespace quarry
