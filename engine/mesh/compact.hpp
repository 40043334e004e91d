// Renumbering: removes tombstones and orders what is left along a Hilbert curve, tags and sets included.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/mesh/mesh.hpp"

namespace quarry {

enum class EntityOrder {
  kKeep,     // survivors keep their order
  kHilbert,  // vertices by the Hilbert key of their point, faces by that of their first corner; ties by old
             // id
};

struct Renumbering {
  std::vector<std::uint32_t> old_vertex;  // old id of each new vertex
  std::vector<std::uint32_t> old_face;    // old id of each new face
};

// Faces, vertices, edges, tags and sets are renumbered; sets and edges lose members that are deleted, and
// arrays give back what they hold beyond their size. Corners of a face keep their cyclic order and their
// start.
Renumbering compact(Mesh& mesh, EntityOrder order);

}  // namespace quarry
