#include "surface/project/triangle_blocks.hpp"

#include <algorithm>

#include "engine/parallel/parallel.hpp"

namespace quarry {
namespace {

bool before(Vec3 a, Vec3 b) {
  if (a.x != b.x) return a.x < b.x;
  return a.y != b.y ? a.y < b.y : a.z < b.z;
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
        all.extend(part.low);
        all.extend(part.high);
        return all;
      });
}

std::vector<FloatBox> float_boxes(const FloatFrame& frame, std::span<const Vec3> points,
                                  std::span<const GivenTriangle> triangles) {
  std::vector<FloatBox> boxes(triangles.size());
  parallel::for_each(triangles.size(), [&](std::size_t i) {
    Box3 box;
    for (const std::uint32_t corner : triangles[i]) box.extend(frame.local(points[corner]));
    const Vec3 margin{FloatFrame::kRayMargin, FloatFrame::kRayMargin, FloatFrame::kRayMargin};
    boxes[i] = {FloatFrame::rounded(box.low - margin), FloatFrame::rounded(box.high + margin)};
  });
  return boxes;
}

}  // namespace

OrderedTriangle::OrderedTriangle(std::span<const Vec3> points, const GivenTriangle& given) : place{0, 1, 2} {
  std::sort(place.begin(), place.end(),
            [&](std::uint8_t i, std::uint8_t j) { return before(points[given[i]], points[given[j]]); });
  for (std::size_t i = 0; i < 3; ++i) corners[i] = points[given[place[i]]];
}

Vec3 OrderedTriangle::unit_normal() const {
  const Vec3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
  return ((mirrored() ? -1 : 1) / length(normal)) * normal;
}

CornerWeights OrderedTriangle::as_given(const CornerWeights& weights) const {
  CornerWeights given{};
  for (std::size_t i = 0; i < 3; ++i) given[place[i]] = weights[i];
  return given;
}

void TriangleBlock::set(std::size_t lane, TriangleId number, const OrderedTriangle& triangle) {
  numbers[lane] = number;
  places[lane] = triangle.place;
  for (std::size_t i = 0; i < 3; ++i) {
    corners[i].x[lane] = triangle.corners[i].x;
    corners[i].y[lane] = triangle.corners[i].y;
    corners[i].z[lane] = triangle.corners[i].z;
  }
}

OrderedTriangle TriangleBlock::triangle(std::size_t lane) const {
  OrderedTriangle triangle;
  triangle.place = places[lane];
  for (std::size_t i = 0; i < 3; ++i)
    triangle.corners[i] = {corners[i].x[lane], corners[i].y[lane], corners[i].z[lane]};
  return triangle;
}

TriangleBlocks::TriangleBlocks(std::span<const Vec3> points, std::span<const GivenTriangle> triangles,
                               const std::string& instruction_set)
    : box_(box_of(points, triangles)),
      frame_(box_),
      tree_(float_boxes(frame_, points, triangles), instruction_set),
      blocks_(tree_.blocks().size()),
      slots_(triangles.size()) {
  parallel::for_each(blocks_.size(), [&](std::size_t block) {
    for (std::uint32_t lane = 0; lane < BoxTree::kBlockSize; ++lane) {
      const std::uint32_t number = tree_.blocks()[block][lane];
      if (number == BoxTree::kNone) continue;
      blocks_[block].set(lane, TriangleId(number), OrderedTriangle(points, triangles[number]));
      slots_[number] = {static_cast<std::uint32_t>(block), lane};
    }
  });
}

}  // namespace quarry
