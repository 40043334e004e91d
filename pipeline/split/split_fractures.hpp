// The mesh cut open along its interior constraints, for codes that want both sides of a fracture: each side
// has nodes of its own, at the same places. Where lines cross, each sector between them has its own node; the
// tip of a line within the domain stays one node; a line that ends on the boundary opens it.
#pragma once

#include <cstddef>

#include "engine/mesh/mesh.hpp"

namespace quarry {

struct SplitReport {
  std::size_t edges = 0;  // that became two
  std::size_t new_nodes = 0;
};

// For finished meshes without tombstones (tags region, constraint, kind); the result has the edge tag
// kSideTag (io/mesh/mesh_file.hpp) too. Splits edges of the kind interior constraint that have a face on both
// sides: each becomes two that follow one another and have the same direction, the one on its left first.
// Left and right are the same all along a line, or along each of its parts where it crosses itself. Faces
// keep their numbers, edges their order. The nodes at which a domain touches itself stay one.
[[nodiscard]] Mesh split_fractures(Mesh&& mesh, SplitReport& report);

}  // namespace quarry
