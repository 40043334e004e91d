#include "surface/project/ray_crossing.hpp"

#include <cmath>
#include <utility>

#include "engine/geometry/predicates.hpp"

namespace quarry {
namespace {

std::array<double, 3> axes(Vec3 v) { return {v.x, v.y, v.z}; }

// Which side of ab the origin of the plane lies on once it is moved by (e, e * e), e next to nothing: the
// sign of side + e (a.y - b.y) + e e (b.x - a.x). The other way round for ba.
double moved_side(double side, Vec2 a, Vec2 b) {
  if (side != 0) return side;
  return a.y != b.y ? a.y - b.y : b.x - a.x;
}

// Where the origin lies between a (0) and b (1), with which it is in line.
double parameter_of_origin(Vec2 a, Vec2 b) {
  const bool by_x = std::abs(a.x - b.x) >= std::abs(a.y - b.y);
  const double from = by_x ? a.x : a.y;
  const double to = by_x ? b.x : b.y;
  return from / (from - to);
}

bool before(Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

}  // namespace

ShearedRay::ShearedRay(Vec3 origin, Vec3 direction) : origin_(origin) {
  const auto d = axes(direction);
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (std::abs(d[axis]) > std::abs(d[z_])) z_ = axis;
  x_ = (z_ + 1) % 3;
  y_ = (z_ + 2) % 3;
  // So that what turns left is seen from its front, whichever way the ray goes.
  if (d[z_] > 0) std::swap(x_, y_);
  shear_x_ = d[x_] / d[z_];
  shear_y_ = d[y_] / d[z_];
  stretch_z_ = d[z_];
}

ShearedRay::ShearedCorners ShearedRay::shear(const TriangleCorners& corners) const {
  ShearedCorners result;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto offset = axes(corners[i] - origin_);
    result[i] = {{offset[x_] - shear_x_ * offset[z_], offset[y_] - shear_y_ * offset[z_]},
                 offset[z_] / stretch_z_};
  }
  return result;
}

// For each corner, the side of the edge across from it that the ray passes.
ShearedRay::Sides ShearedRay::sides_of(const ShearedCorners& corners) {
  const auto& [a, b, c] = corners;
  return {orient2d(b.across, c.across, {0, 0}), orient2d(c.across, a.across, {0, 0}),
          orient2d(a.across, b.across, {0, 0})};
}

std::optional<RayCrossing> ShearedRay::touch(const TriangleCorners& corners) const {
  const ShearedCorners sheared = shear(corners);
  const Sides sides = sides_of(sheared);
  const bool left = sides[0] > 0 || sides[1] > 0 || sides[2] > 0;
  const bool right = sides[0] < 0 || sides[1] < 0 || sides[2] < 0;
  if (left == right) return std::nullopt;
  return crossing(sheared, sides, left);
}

std::optional<RayCrossing> ShearedRay::cross(const TriangleCorners& corners) const {
  const ShearedCorners sheared = shear(corners);
  const Sides sides = sides_of(sheared);
  int left = 0, right = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double side = moved_side(sides[i], sheared[(i + 1) % 3].across, sheared[(i + 2) % 3].across);
    left += side > 0 ? 1 : 0;
    right += side < 0 ? 1 : 0;
  }
  if (left < 3 && right < 3) return std::nullopt;
  return crossing(sheared, sides, left == 3);
}

// sides: none of one sign and another of the other, and not all 0.
RayCrossing ShearedRay::crossing(const ShearedCorners& corners, const Sides& sides, bool from_front) const {
  RayCrossing result{.from_front = from_front};
  std::size_t zeros = 0;
  std::size_t zero = 0, other = 0;  // corners with and without a side of 0
  for (std::size_t i = 0; i < 3; ++i) {
    if (sides[i] == 0) ++zeros;
    (sides[i] == 0 ? zero : other) = i;
  }
  if (zeros == 2) {
    result.weights[other] = 1;
    result.parameter = corners[other].along;
    return result;
  }
  if (zeros == 1) {
    // In an order that all triangles with this edge agree on.
    std::size_t from = (zero + 1) % 3, to = (zero + 2) % 3;
    if (before(corners[to].across, corners[from].across)) std::swap(from, to);
    const double between = parameter_of_origin(corners[from].across, corners[to].across);
    result.weights[from] = 1 - between;
    result.weights[to] = between;
    result.parameter = corners[from].along + between * (corners[to].along - corners[from].along);
    return result;
  }
  const double whole = sides[0] + sides[1] + sides[2];
  for (std::size_t i = 0; i < 3; ++i) {
    result.weights[i] = sides[i] / whole;
    result.parameter += result.weights[i] * corners[i].along;
  }
  return result;
}

}  // namespace quarry
