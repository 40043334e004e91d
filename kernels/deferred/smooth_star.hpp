// Local smoothing after an attraction (Araujo & Celes 2014, section 3.1.4): the vertex and its link, guarded.
#pragma once

#include "engine/operation/editor.hpp"
#include "kernels/deferred/state.hpp"

namespace quarry::deferred {

// Smooths v and the vertices joined to it; needs two rings of claims around v. Free vertices go towards the
// mean of their link, sliding ones along their piece, nodes and the hull stay. By default a move is kept only
// if the worst triangle of the star does not get worse: without that guard, edges collapse and ruin spreads.
void smooth_star(MeshEditor& editor, const State& state, VertexId v);

}  // namespace quarry::deferred
