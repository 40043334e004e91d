// The sizes that a mesh has, by place, so that they can be wanted again once its faces are others.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/geometry/box.hpp"
#include "engine/mesh/mesh.hpp"
#include "kernels/field/size_field.hpp"

namespace quarry {

// At each place the edge of the square that has the mean area of the faces nearby: those in the smallest cell
// of a quadtree around it that holds enough of them. Two triangles count as one quad. Keeps nothing of the
// mesh, which has at least one face.
class InputSize final : public SizeField {
 public:
  explicit InputSize(const Mesh& mesh);
  [[nodiscard]] double at(Vec2 p) const override;

 private:
  Box2 box_;
  std::vector<std::uint64_t> keys_;  // of the faces along a Hilbert curve, ascending: cells are ranges of it
  std::vector<double> area_before_;  // the sum of the areas of the faces before each in that order
};

}  // namespace quarry
