// Close-to-longest recursive bisection (Araujo & Celes 2014, section 3.1.2): which edge must be bisected
// first, and the bisection.
#pragma once

#include <optional>

#include "engine/operation/cavity.hpp"
#include "engine/operation/editor.hpp"
#include "kernels/deferred/state.hpp"

namespace quarry::deferred {

// The edge to bisect now so that s can be bisected soon: goes from triangle to triangle while one at the edge
// has an edge longer than 1 / close_to_longest times it. Each step goes to a longer edge, so it ends.
[[nodiscard]] SideId edge_to_split_first(const Mesh& mesh, const State& state, SideId s);

// The longest edge of a face; ties go to the side of smallest index.
[[nodiscard]] SideId longest_side(const Mesh& mesh, FaceId f);

// A bisection: the edge, where, and what the new vertex is bound to.
struct Refinement {
  SideId side;
  Vec2 point;
  Support support;
};

// The bisection that brings that of s nearer, with its claims; none if s is shorter than the floor, or if
// rounding leaves no valid bisection.
[[nodiscard]] std::optional<Refinement> propose_refinement(const Mesh& mesh, const State& state, SideId s,
                                                           Cavity& cavity);

}  // namespace quarry::deferred
