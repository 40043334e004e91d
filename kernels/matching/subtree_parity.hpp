// From a spanning forest of the dual to a join in which every triangle has one or three arcs: an arc is taken
// if what lies beyond it in its tree is odd in number. This is the published rule of matching from the
// deepest level upwards, in closed form (Ramaswami, Ramos & Toussaint 1998; Verma & Tautges, Jaal), and in a
// tree of an even number it does not depend on a root.
#pragma once

#include "kernels/matching/join.hpp"

namespace quarry {

// Every tree must have an even number of faces; a tree of an odd number would leave one face with none or two
// arcs. Leaves are peeled by many threads at once; whoever takes the last but one arc of a face goes on from
// there, so that the work is one visit a face.
[[nodiscard]] DualArcs subtree_parity_join(const Mesh& mesh, const DualArcs& forest);

}  // namespace quarry
