// The triangles of a surface as searches want them: those of a block of the tree of boxes side by side, one a
// lane, and blocks that are neighbours in space neighbours in memory.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/geometry/box.hpp"
#include "surface/project/box_tree.hpp"
#include "surface/project/float_frame.hpp"
#include "surface/project/triangle_filter.hpp"
#include "surface/project/triangle_point.hpp"

namespace quarry {

using GivenTriangle = std::array<std::uint32_t, 3>;

// A triangle with its corners in ascending order of x, then y, then z: see triangle_point.hpp.
struct OrderedTriangle {
  TriangleCorners corners{};
  std::array<std::uint8_t, 3> place{};  // corners[i] is corner place[i] of the triangle as given

  OrderedTriangle() = default;
  OrderedTriangle(std::span<const Vec3> points, const GivenTriangle& given);

  // Whether the corners turn the other way than as given.
  [[nodiscard]] bool mirrored() const { return (place[0] + 1) % 3 != place[1]; }
  // By the turn of the corners as given; NaN for a triangle without area.
  [[nodiscard]] Vec3 unit_normal() const;
  // Weights of the corners as given.
  [[nodiscard]] CornerWeights as_given(const CornerWeights& weights) const;
};

struct TriangleBlock {
  std::array<LaneVec3<Double2>, 3> corners{};
  std::array<TriangleId, BoxTree::kBlockSize> numbers{};  // none in a lane that is left over
  std::array<std::array<std::uint8_t, 3>, BoxTree::kBlockSize> places{};

  void set(std::size_t lane, TriangleId number, const OrderedTriangle& triangle);
  [[nodiscard]] OrderedTriangle triangle(std::size_t lane) const;
  // Squared distances of p from the triangles, with the bits of closest_on_triangle for each alone.
  [[nodiscard]] Double2 squared_distances(Vec3 p) const {
    const Double2 zero{};
    return closest_on_triangle<Double2>({zero + p.x, zero + p.y, zero + p.z}, corners).squared_distance;
  }
};

class TriangleBlocks {
 public:
  // Where a triangle lies.
  struct Slot {
    std::uint32_t block = 0;
    std::uint32_t lane = 0;
  };

  TriangleBlocks(std::span<const Vec3> points, std::span<const GivenTriangle> triangles,
                 const std::string& instruction_set);

  [[nodiscard]] const Box3& box() const { return box_; }
  [[nodiscard]] const FloatFrame& frame() const { return frame_; }
  // Over boxes around the triangles in local floats, wider by FloatFrame::kRayMargin.
  [[nodiscard]] const BoxTree& tree() const { return tree_; }
  [[nodiscard]] const TriangleBlock& block(std::uint32_t number) const { return blocks_[number]; }
  [[nodiscard]] Slot slot_of(TriangleId triangle) const { return slots_[triangle.value()]; }

 private:
  Box3 box_;
  FloatFrame frame_;
  BoxTree tree_;
  std::vector<TriangleBlock> blocks_;
  std::vector<Slot> slots_;
};

}  // namespace quarry
