// Close-to-longest recursive bisection (Araujo & Celes 2014, section 3.1.2): which edge must be bisected
// first, and the bisection.
#pragma once

#include "engine/operation/cavity.hpp"
#include "engine/operation/editor.hpp"
#include "kernels/deferred/state.hpp"

namespace quarry::deferred {

// The edge to bisect now so that s can be bisected soon: goes from triangle to triangle while one at the edge
// has an edge longer than 1 / close_to_longest times it. Each step goes to a longer edge, so it ends.
[[nodiscard]] SideId edge_to_split_first(const Mesh& mesh, const State& state, SideId s);

// The longest edge of a face; ties go to the side of smallest index.
[[nodiscard]] SideId longest_side(const Mesh& mesh, FaceId f);

// The midpoint of an edge: on its piece where it is constrained. Exactly representable validity is for the
// caller to test (can_split_edge).
[[nodiscard]] Vec2 split_point(const Mesh& mesh, SideId s);
// What a vertex on the edge is bound to.
[[nodiscard]] Support support_on_edge(const Mesh& mesh, const State& state, SideId s);

}  // namespace quarry::deferred
