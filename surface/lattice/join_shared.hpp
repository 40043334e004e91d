// Joins the vertices of a surface mesh that have one lattice point.
#pragma once

#include "engine/base/progress.hpp"
#include "surface/lattice/lattice_state.hpp"

namespace quarry {

// Collapses the edges between vertices that share a lattice point, as the guard of remeshing allows with the
// options of the state's mesh; `lowest`: the measure that triangles may sink to. What it won are
// collapses.
PassReport join_shared_points(LatticeState& state, double lowest, const Progress& progress);

// How many vertices would be left if every edge were collapsed that join_shared_points looks at.
[[nodiscard]] std::size_t count_after_joins(const LatticeState& state);

}  // namespace quarry
