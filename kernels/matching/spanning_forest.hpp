// The maximum spanning forest of the dual graph of a triangle mesh, by Boruvka's rounds. Arcs are ordered by
// worth, ties by the smaller side of the edge, so that the forest is one and the same whoever grows it.
//   O. Boruvka: O jistem problemu minimalnim, 1926; rounds with pointer jumping as in Chung & Condon 1996.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "kernels/matching/join.hpp"

namespace quarry {

// The worth of sides across which no arc goes.
inline constexpr float kNoArc = -2.0F;

struct SpanningForest {
  DualArcs arcs;
  // The face that stands for the tree of each face: the connected parts of the dual.
  IdVector<FaceId, FaceId> root;
  std::uint64_t rounds = 0;
};

// worth: one for each side slot (four a face), the same from both sides of an edge; kNoArc where the dual has
// no arc. Scratch memory: 28 bytes a triangle beside the result. In parallel, the same on any number of
// threads.
[[nodiscard]] SpanningForest maximum_spanning_forest(const Mesh& mesh, std::span<const float> worth);

}  // namespace quarry
