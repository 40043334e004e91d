// The last step to a mixed mesh: a quad that is too bad is cut into two triangles where that helps. Nothing
// else changes, no vertex moves and no edge goes, so that the mesh stays conforming, keeps its lines, and
// differs from the mesh of quads in these cuts alone.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/mesh/mesh.hpp"

namespace quarry {

struct LowQuadOptions {
  // Quads whose scaled Jacobian is below this are cut,
  double quality = 0.3;
  // if that of the worse triangle is at least so many times as large, or at least `quality`. A corner of the
  // outline or between lines stays as sharp as it is: there a triangle counts 2 / sqrt(3) times what the quad
  // does, by the definition of its scaled Jacobian, and is the natural face.
  double least_gain = 1.1;
};

struct LowQuadReport {
  std::uint64_t low = 0;  // quads below the quality
  std::uint64_t cut = 0;  // of them
};

// True if the face is a quad below the quality whose better cut helps. Quads that are not convex are cut
// wherever both triangles are valid.
[[nodiscard]] bool cut_would_help(const Mesh& mesh, FaceId f, const LowQuadOptions& options);

// Cuts all such quads of a planar mesh with ConstraintTags along their better diagonals. The second triangle
// of each gets a new slot at the end, in the order of the quads; other tags of it have their initial values.
LowQuadReport cut_low_quads(Mesh& mesh, const LowQuadOptions& options);

}  // namespace quarry
