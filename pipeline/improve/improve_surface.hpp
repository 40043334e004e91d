// The improve job for a mesh in space: the faces are the surface, and the better ones lie on it.
#pragma once

#include "engine/base/progress.hpp"
#include "io/mesh/read_cells.hpp"
#include "pipeline/improve/improve.hpp"
#include "pipeline/report/stages.hpp"

namespace quarry {

// As improve_mesh, for cells with faces that were read already, on a clock that runs.
[[nodiscard]] ImproveResult improve_surface(const ImproveOptions& options, ReadCells cells, StageClock& clock,
                                            const Progress& progress);

}  // namespace quarry
