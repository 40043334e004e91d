#include "surface/project/packed_triangles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/geometry/hilbert.hpp"
#include "engine/parallel/parallel.hpp"
#include "engine/parallel/sort.hpp"

namespace quarry {
namespace {

using GivenTriangle = std::array<std::uint32_t, 3>;

// Floats beyond this overflow when squared, which does no harm; but the cast itself must not.
constexpr double kLargestFloat = 3e38;

float to_float(double value) { return static_cast<float>(std::clamp(value, -kLargestFloat, kLargestFloat)); }

bool before(Vec3 a, Vec3 b) {
  if (a.x != b.x) return a.x < b.x;
  return a.y != b.y ? a.y < b.y : a.z < b.z;
}

PackedTriangle pack(std::span<const Vec3> points, const GivenTriangle& given, TriangleId number) {
  PackedTriangle packed{.number = number, .place = {0, 1, 2}};
  std::sort(packed.place.begin(), packed.place.end(),
            [&](std::uint8_t i, std::uint8_t j) { return before(points[given[i]], points[given[j]]); });
  for (std::size_t i = 0; i < 3; ++i) packed.corners[i] = points[given[packed.place[i]]];
  return packed;
}

Vec3 unit_normal_of(std::span<const Vec3> points, const GivenTriangle& given) {
  const Vec3 a = points[given[0]];
  const Vec3 normal = cross(points[given[1]] - a, points[given[2]] - a);
  const double size = length(normal);
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  return size > 0 ? (1 / size) * normal : Vec3{kNone, kNone, kNone};
}

Box3 box_of(std::span<const Vec3> points, std::span<const GivenTriangle> triangles) {
  return parallel::reduce_ordered(
      triangles.size(), Box3(),
      [&](std::size_t begin, std::size_t end) {
        Box3 box;
        for (std::size_t i = begin; i < end; ++i)
          for (const std::uint32_t corner : triangles[i]) box.extend(points[corner]);
        return box;
      },
      [](Box3 all, const Box3& part) {
        if (part.low.x <= part.high.x) {
          all.extend(part.low);
          all.extend(part.high);
        }
        return all;
      });
}

std::vector<std::uint32_t> spatial_order(std::span<const Vec3> points,
                                         std::span<const GivenTriangle> triangles, const Box3& box) {
  std::vector<std::uint64_t> keys(triangles.size());
  parallel::for_each(triangles.size(), [&](std::size_t i) {
    const auto& [a, b, c] = triangles[i];
    keys[i] = hilbert_key((1.0 / 3) * (points[a] + points[b] + points[c]), box);
  });
  return parallel::sorted_order(std::move(keys));
}

}  // namespace

CornerWeights weights_as_given(const PackedTriangle& triangle, const CornerWeights& weights) {
  CornerWeights given{};
  for (std::size_t i = 0; i < 3; ++i) given[triangle.place[i]] = weights[i];
  return given;
}

FloatFrame::FloatFrame(const Box3& box) {
  const double side = box.longest_side();
  if (!(side >= 0)) return;  // no triangles
  center_ = box.low + 0.5 * (box.high - box.low);
  if (side > std::numeric_limits<double>::min()) scale_ = std::ldexp(1.0, -std::ilogb(side));
}

FloatPoint FloatFrame::rounded(Vec3 local) {
  return {to_float(local.x), to_float(local.y), to_float(local.z)};
}

float FloatFrame::covering_radius(double distance, double slack) const {
  const double radius = (distance * scale_ + slack) * (1 + 1e-6);
  return radius < kLargestFloat ? static_cast<float>(radius) : std::numeric_limits<float>::infinity();
}

PackedTriangles::PackedTriangles(std::span<const Vec3> points, std::span<const GivenTriangle> triangles)
    : box_(box_of(points, triangles)),
      frame_(box_),
      triangles_(triangles.size()),
      normals_(triangles.size()),
      slots_(triangles.size()) {
  const std::vector<std::uint32_t> order = spatial_order(points, triangles, box_);
  parallel::for_each(order.size(), [&](std::size_t slot) {
    const std::uint32_t number = order[slot];
    triangles_[slot] = pack(points, triangles[number], TriangleId(number));
    normals_[slot] = unit_normal_of(points, triangles[number]);
    slots_[number] = static_cast<std::uint32_t>(slot);
  });
}

std::vector<FloatBox> PackedTriangles::float_boxes() const {
  std::vector<FloatBox> boxes(size());
  parallel::for_each(size(), [&](std::size_t slot) {
    Box3 box;
    for (const Vec3 corner : triangles_[slot].corners) box.extend(frame_.local(corner));
    const Vec3 margin{kRayMargin, kRayMargin, kRayMargin};
    boxes[slot] = {FloatFrame::rounded(box.low - margin), FloatFrame::rounded(box.high + margin)};
  });
  return boxes;
}

}  // namespace quarry
