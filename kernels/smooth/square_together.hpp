// Rounds of squaring corners in which all vertices move at once, by Gauss-Newton steps of blocks of vertices,
// and those step back whose faces suffer.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/mesh/mesh.hpp"
#include "kernels/smooth/corner_residual.hpp"
#include "kernels/smooth/slide.hpp"
#include "kernels/smooth/square_corners_options.hpp"
#include "kernels/smooth/square_step.hpp"

namespace quarry {

class SquareTogether {
 public:
  // All must outlive the object.
  SquareTogether(Mesh& mesh, const Slide& slide, const IdVector<FaceId, AreaDemand>& demands,
                 const SquareCornersOptions& options)
      : mesh_(&mesh), slide_(&slide), demands_(&demands), options_(options) {}

  // One round: a step for all vertices at faces with a measure below `content` and for those some rings
  // around them. Vertices whose faces would fall below the floor, or further below it, or turn over (exact),
  // go half of their step, a quarter, or stay, until no face does. Returns how many moved. Blocks are cut
  // from the order of the vertices, elsewhere from round to round: along a Hilbert curve
  // (engine/mesh/compact) they are whole areas, and changes travel far. The same on any number of threads.
  std::uint64_t run();

 private:
  using Step = SquareStep::Pair;

  void choose_active();
  void find_steps();
  void go();
  void place(VertexId v);
  bool keeps(FaceId f) const;
  void mark_corners_unless_kept(FaceId f);
  std::vector<std::uint32_t> step_back();

  Mesh* mesh_;
  const Slide* slide_;
  const IdVector<FaceId, AreaDemand>* demands_;
  SquareCornersOptions options_;
  int rounds_ = 0;
  std::vector<std::uint8_t> active_;    // by vertex
  std::vector<Vec2> before_;            // by vertex: where it was
  std::vector<Step> steps_;             // by vertex
  std::vector<std::uint8_t> halvings_;  // by vertex: of its step; kStays: it stays
  std::vector<std::uint8_t> marked_;    // by vertex: at a face that suffers
};

}  // namespace quarry
