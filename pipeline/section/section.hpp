// The section job: reads lines, cleans them, works them into a start mesh, and turns that into quads (or
// smooths its triangles). Nothing is written here.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/progress.hpp"
#include "engine/geometry/line_set.hpp"
#include "engine/mesh/mesh.hpp"
#include "engine/operation/pass.hpp"
#include "io/mesh/mesh_file.hpp"
#include "kernels/cleanup/clean_up.hpp"
#include "kernels/cluster/low_quads.hpp"
#include "kernels/cluster/quads.hpp"
#include "kernels/deferred/options.hpp"
#include "kernels/linework/clean_lines.hpp"
#include "kernels/matching/matching.hpp"
#include "kernels/smooth/sweep.hpp"
#include "pipeline/report/stages.hpp"
#include "pipeline/section/options.hpp"
#include "pipeline/section/wanted_sizes.hpp"

namespace quarry {

struct SectionResult {
  // Faces with the tag "region", and with those of groups where regions have names; edge entities with the
  // tags "constraint" and "kind", and with those of groups and "aperture" where the input says something of
  // its lines; vertices with kPointTag where the input has points. Compact, in Hilbert order.
  Mesh mesh;
  std::vector<Grouping> groups;
  LineSet lines;
  std::optional<LineSet> boundary;  // what the file of the outline holds, if it is one
  std::string projected;            // the plane that degrees were brought to; "" if they were not
  std::string system;               // of the coordinates; "" if unknown
  std::vector<std::string> notes;   // of reading: one line each
  CleanedLines cleaned;
  Outline outline;
  ResolvedLengths lengths;
  std::shared_ptr<WantedSizes> sizes;  // none where all elements are to be of one size
  double elements = 0;                 // expected in the box of the outline
  double orient_degrees = 0;
  std::int32_t regions = 0;
  PassReport start;  // where sizes differ by place
  DeferredReport deferred;
  PassReport whole_outline;  // with keep_boundary
  QuadReport quads;          // of quad meshes by clusters
  MatchingReport matching;   // of quad meshes by matching
  CleanUpReport clean_up;
  LowQuadReport low_quads;  // of mixed meshes
  PassReport flips;         // of triangle meshes, as is smoothing
  SweepReport smoothing;
  std::vector<StageTime> times;
};

// Throws Error: see the kinds in engine/base/error.hpp and docs/contract.md.
[[nodiscard]] SectionResult mesh_section(const SectionOptions& options, const Progress& progress);

// The first half alone: read, find the outline, clean. mesh and what follows it stay empty.
[[nodiscard]] SectionResult clean_section(const SectionOptions& options, const Progress& progress);

}  // namespace quarry
