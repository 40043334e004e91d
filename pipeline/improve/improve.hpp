// The improve job: a finished mesh of any tool in, the same domain with better faces out. Edges that bear a
// tag, interfaces between regions and the boundary stay where they are, and in space the edges at which the
// surface turns sharply; vertices on them slide along straight stretches, and corners, ends and junctions
// stay fixed. Nothing is written here.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/progress.hpp"
#include "engine/mesh/mesh.hpp"
#include "io/mesh/mesh_file.hpp"
#include "kernels/cleanup/clean_up.hpp"
#include "kernels/cluster/low_quads.hpp"
#include "kernels/quality/summary.hpp"
#include "kernels/smooth/sweep.hpp"
#include "pipeline/report/stages.hpp"

namespace quarry {

struct ImproveOptions {
  std::string input;
  CleanUpLevel cleanup = CleanUpLevel::kFull;
  // Where irregular vertices are dear to the clean-up, as pipeline/section/price_source.hpp reads it.
  std::string irregular_price = {};
  // At the end, quads with a smaller scaled Jacobian are cut into triangles where that helps; unset: none is.
  std::optional<double> mixed_quality = {};
  // Wanted edge of the elements in input units; unset: sizes stay as they are.
  std::optional<double> size = {};
  // How far a vertex of a tagged edge or of the boundary may lie from the straight stretch along which it
  // slides, in input units; unset: 1e-9 of the longer side of the box, so that only what is straight as it
  // was written counts as straight.
  std::optional<double> tolerance = {};
  // Of a mesh in space: from which angle between faces on an edge is sharp, as in FeatureOptions.
  std::optional<double> sharp_degrees = {};
};

struct ImproveResult {
  // Faces with the tag "region"; edge entities with the tags "constraint" and "kind": those of the input and
  // the boundary; points and groups of the input. Compact, in Hilbert order.
  Mesh mesh;
  std::vector<Grouping> groups;
  GroupNames names;  // of the groups of the input
  QualitySummary before;
  double tolerance = 0;          // as used
  std::size_t turned = 0;        // faces that were clockwise
  std::size_t invalid = 0;       // faces that had a corner which does not turn left
  std::size_t tagged_edges = 0;  // edges of the input that bear a tag
  std::size_t nodes = 0;         // vertices that stay fixed
  std::size_t pieces = 0;        // straight stretches
  std::size_t sharp_edges = 0;   // of a mesh in space, that no file tags
  double sharp_degrees = 0;      // as used
  CleanUpReport clean_up;
  SweepReport smoothing, squaring, corners;
  LowQuadReport low_quads;         // with mixed_quality
  std::vector<std::string> notes;  // one line each: what the user should know
  std::vector<StageTime> times;
};

// Throws Error(kInput) for a file that cannot be read or makes no mesh, Error(kUsage) for options that make
// no sense (size, prices and mixed elements in space among them), Error(kGeometry) for a mesh without faces,
// and one that stays invalid, with the place.
[[nodiscard]] ImproveResult improve_mesh(const ImproveOptions& options, const Progress& progress);

}  // namespace quarry
