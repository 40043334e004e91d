// Collapse of chords: rows of faces go from end to end so that vertices of opposite charge become one. What
// operations inside a cell between lines cannot do, since it changes the number of edges on each line that
// the chord crosses.
//
// The inverse, which puts a row in along a path of edges, is of no use here: it splits each vertex of the
// path in two whose charges have the sum of its own, and so never lowers the valence energy where no charge
// is beyond one.
#pragma once

#include <cstddef>

#include "engine/base/progress.hpp"
#include "engine/mesh/mesh.hpp"
#include "kernels/cleanup/chord_charges.hpp"
#include "kernels/cleanup/chord_report.hpp"
#include "kernels/cleanup/irregular_price.hpp"
#include "kernels/smooth/local_smoother.hpp"

namespace quarry {

struct ChordOptions {
  // The least valence energy for each root of the number of faces of the mesh, which is about one row of it,
  // that goes: the mesh becomes coarser all along a chord.
  double least_gain = 0.5;
  // Rounds: chords that share faces go one after the other. No more after one in which none went. 0: none.
  int most_rounds = 6;
  // The shortest sets of a round are looked at, as many as together are so many times as long as the mesh has
  // faces: they gain most for their faces, and the time stays linear in the faces.
  double most_walked = 1;
  // The whole mesh: collapses that take its number of faces further than this share from `wanted_faces` (0:
  // those at the start) are left out.
  double most_shrinkage = 0.1;
  std::size_t wanted_faces = 0;
  // As of patches, see PatchOptions.
  double least_jacobian = 0.3;
  double largest_edge_ratio = 6;
  // Rows on either side of the faces beside a chord that are smoothed with it.
  int rows = 4;
  LocalShapeOptions smoothing{.untangling_sweeps = 6, .sweeps = 8, .area_averages = 8};
  IrregularPrice price;  // empty: all places cost the same
};

// The mesh: planar, of quads and triangles, with ConstraintTags, in one piece. Vertices on lines keep to
// them, and fixed ones stay. Tombstones stay. charges: of the mesh. The result does not depend on the number
// of threads.
ChordReport collapse_chords(Mesh& mesh, SectorCharges charges, const ChordOptions& options,
                            const Progress& progress);

}  // namespace quarry
