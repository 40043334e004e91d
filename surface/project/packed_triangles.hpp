// The triangles of a surface as searches want them: neighbours in space are neighbours in memory, each with
// its corners at hand, beside boxes of floats around them all.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/geometry/box.hpp"
#include "surface/project/box_tree.hpp"
#include "surface/project/triangle_filter.hpp"
#include "surface/project/triangle_point.hpp"

namespace quarry {

struct PackedTriangle {
  TriangleCorners corners{};  // ascending by x, then y, then z: see triangle_point.hpp
  TriangleId number;
  std::array<std::uint8_t, 3> place{};  // corners[i] is corner place[i] of the triangle as given

  // Whether the corners turn the other way in this order than as given.
  [[nodiscard]] bool mirrored() const { return (place[0] + 1) % 3 != place[1]; }
};

// Weights in the given order of the corners.
[[nodiscard]] CornerWeights weights_as_given(const PackedTriangle& triangle, const CornerWeights& weights);

// Where floats are good enough: coordinates about the middle of the surface, with half its longest side
// between 0.5 and 1. Float boxes stay tight in them at coordinates of 6.7e6, and nothing overflows.
class FloatFrame {
 public:
  FloatFrame() = default;
  explicit FloatFrame(const Box3& box);

  // An error that covers all rounding of a point within the surface's box to floats, and of distances
  // reckoned with them: coordinates are off by at most 2^-24 of their size.
  static constexpr double kSlack = 0x1p-20;

  [[nodiscard]] Vec3 local(Vec3 p) const { return scale_ * (p - center_); }
  [[nodiscard]] double scale() const { return scale_; }
  [[nodiscard]] static FloatPoint rounded(Vec3 local);
  // A radius about a local point that covers a distance in input units despite all rounding.
  [[nodiscard]] float covering_radius(double distance, double slack) const;

 private:
  Vec3 center_;
  double scale_ = 1;
};

// How far a ray in local floats may pass by what the ray in double meets: its origin, its direction and the
// sides of the boxes are all rounded, each by at most a few 2^-24.
inline constexpr double kRayMargin = 0x1p-18;

class PackedTriangles {
 public:
  PackedTriangles(std::span<const Vec3> points, std::span<const std::array<std::uint32_t, 3>> triangles);

  [[nodiscard]] std::size_t size() const { return triangles_.size(); }
  [[nodiscard]] const PackedTriangle& operator[](std::uint32_t slot) const { return triangles_[slot]; }
  // Where the triangle with this number lies.
  [[nodiscard]] std::uint32_t slot_of(TriangleId triangle) const { return slots_[triangle.value()]; }
  // By the turn of the corners as given; NaN for a triangle without area.
  [[nodiscard]] Vec3 unit_normal(std::uint32_t slot) const { return normals_[slot]; }
  [[nodiscard]] const Box3& box() const { return box_; }
  [[nodiscard]] const FloatFrame& frame() const { return frame_; }
  // Around each triangle, in local floats, wider by kRayMargin.
  [[nodiscard]] std::vector<FloatBox> float_boxes() const;

 private:
  Box3 box_;
  FloatFrame frame_;
  std::vector<PackedTriangle> triangles_;
  std::vector<Vec3> normals_;
  std::vector<std::uint32_t> slots_;
};

}  // namespace quarry
