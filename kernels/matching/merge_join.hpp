// Makes the quad mesh of a join: a triangle with one arc becomes half of a quad, one with three arcs three
// parts around a Steiner point, each of them half of a quad.
#pragma once

#include <cstdint>

#include "kernels/matching/join.hpp"

namespace quarry {

// Vertices keep their numbers; Steiner points (free) follow in the order of their triangles. Quads are in the
// order of the triangle that holds the smaller side of their arc, so that they lie as the triangles lay.
// Constraint tags are carried over; tombstones of faces vanish. Connectivity is computed in closed form, in
// parallel; the triangle mesh is consumed. A Steiner point is put where the smallest corner of its three
// quads is largest, with other Steiner points next to it at the centroids of their triangles; in space it
// lies in its triangle.
[[nodiscard]] Mesh merge_join(Mesh&& triangles, const DualArcs& join);

// How many triangles the join splits.
[[nodiscard]] std::uint64_t count_steiner_points(const DualArcs& join);

}  // namespace quarry
