// One Gauss-Newton step of squaring corners for many vertices at once: the linear system of a block of
// vertices whose surroundings stand still, and its solution by preconditioned conjugate gradients. Sweeps
// over single vertices carry a change one vertex a sweep; this carries it through the block.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/mesh/mesh.hpp"
#include "kernels/smooth/corner_residual.hpp"
#include "kernels/smooth/slide.hpp"

namespace quarry {

// In single precision and in units of the block's edges: steps need no more, and half the memory is half the
// time.
class SquareStep {
 public:
  struct Pair {
    float x = 0, y = 0;
  };

  // demands: by face, empty if nothing is asked of areas; spring as in SquareCornersOptions. All references
  // must outlive the object.
  SquareStep(const Mesh& mesh, const Slide& slide, const IdVector<FaceId, AreaDemand>& demands, double spring)
      : mesh_(&mesh), slide_(&slide), demands_(&demands), spring_(static_cast<float>(spring)) {}

  // Of the vertices begin to end - 1, those with a nonzero `active` may move (that is asked of Slide too).
  // Memory is kept from one block to the next.
  void solve(VertexId begin, VertexId end, const std::vector<std::uint8_t>& active);

  // Calls take(VertexId, Vec2 step) for each vertex that may move.
  template <class Take>
  void for_each_step(const Take& take) const {
    for (std::size_t i = 0; i < unknowns_.size(); ++i)
      take(unknowns_[i].vertex, Vec2{unit_ * static_cast<double>(unknowns_[i].step.x),
                                     unit_ * static_cast<double>(unknowns_[i].step.y)});
  }

 private:
  static constexpr std::uint32_t kFrozen = 0xffffffffU;
  // Rows hold two by two numbers in columns, so that a product is one multiplication of four lanes.
  using Block = std::array<float, 4>;  // xx, yx, xy, yy
  struct Unknown {
    VertexId vertex;
    Pair along;                    // where a sliding vertex may go, of length 1; zero if it may go anywhere
    std::array<float, 3> inverse;  // xx, xy, yy of the inverse of the diagonal block
    Pair step, residual, preconditioned;
  };

  void choose_unknowns(VertexId begin, VertexId end, const std::vector<std::uint8_t>& active);
  void lay_out_rows();
  void assemble();
  template <int kCorners>
  void add_face(FaceId f);
  void finish_diagonal();
  void iterate();
  double precondition();
  double multiply();

  // The number of a vertex's unknown, or kFrozen.
  [[nodiscard]] std::uint32_t unknown_of(VertexId v) const {
    const std::uint32_t i = v.value() - begin_.value();
    return i < numbers_.size() ? numbers_[i] : kFrozen;
  }
  [[nodiscard]] Block& block(std::uint32_t row, std::uint32_t column);

  const Mesh* mesh_;
  const Slide* slide_;
  const IdVector<FaceId, AreaDemand>* demands_;
  float spring_;
  VertexId begin_;
  double unit_ = 1;  // the length that stands for 1
  std::vector<std::uint32_t> numbers_;
  std::vector<Unknown> unknowns_;
  std::vector<Pair> direction_, product_;
  std::vector<std::uint32_t> row_starts_;  // the diagonal is first in each row
  std::vector<std::uint32_t> columns_;
  std::vector<Block> blocks_;
};

}  // namespace quarry
