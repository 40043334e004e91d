// Makes a mesh of quads and single triangles from a triangle mesh and its pairing.
#pragma once

#include "engine/mesh/constraint.hpp"
#include "kernels/cluster/pairing.hpp"

namespace quarry {

// Merges the pairs. Vertices keep their numbers, faces their order (a quad stands where the smaller of its
// triangles stood), constraint tags are carried over; tombstones of faces vanish. Connectivity is computed in
// closed form, in parallel; the triangle mesh is consumed.
[[nodiscard]] Mesh merge_pairs(Mesh&& triangles, const Pairing& pairing);

}  // namespace quarry
