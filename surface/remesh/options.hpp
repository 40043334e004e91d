// Options and report of surface remeshing.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/geometry/vec.hpp"
#include "engine/operation/pass.hpp"

namespace quarry {

struct RemeshOptions {
  // Edges of rims are not split, as those where sheets meet never are; fix_rims keeps them from all else.
  bool keep_rims = false;
  // How many triangles there are to be. 0: as many as are equilateral, with the wanted edges.
  double wanted_faces = 0;
  // Rounds of splits, collapses, flips and moves.
  int rounds = 8;
  // An edge is split if it is longer than this many wanted edges, and collapsed if shorter than that many, if
  // nothing longer than the first comes of it (Botsch & Kobbelt, A remeshing approach to multiresolution
  // modeling, SGP 2004).
  double longest = 4.0 / 3, shortest = 4.0 / 5;
  // No triangle may turn farther than this from the normals of the surface at its corners, nor from the
  // triangles whose place it takes: the cosine.
  double least_turn_cosine = 0.5;
  // Collapses along features may not leave them by more than this share of the wanted edge.
  double feature_deviation = 0.1;
  // Moves may not lower the measure of a star's worst triangle where it is below this.
  double content = 0.6;
  // If positive: points of the surface farther from the mesh, after the first round, than this share of the
  // edge of a square as large as the triangle there have been lost: tips and pits. If they lie in few places,
  // remeshing ends there, before its last moves: the mesh is valid and of no use.
  double lost_from = 0;
};

struct RemeshReport {
  // Of RemeshOptions::lost_from: where the first round has lost the surface, if in few places.
  std::vector<Vec3> lost;
  // All rounds together.
  PassReport splits{.name = "splits"}, collapses{.name = "collapses"}, flips{.name = "flips"};
  std::uint64_t moves = 0;
  std::uint64_t rounds = 0;
};

}  // namespace quarry
