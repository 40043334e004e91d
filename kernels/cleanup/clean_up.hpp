// Topological clean-up of a planar quad mesh with constraints: local operators, then one-defect patches from
// small to large, inside the cells and then over lines, with sweeps of smoothing over the whole mesh in
// between, which keep large patches acceptable, and the local operators again: vertices of six edges on the
// rims of patches are split. Chords collapse after the smallest patches, when vertices of opposite charge are
// still near to each other. The steps have headers of their own; this is their order and their defaults.
//   C. Verma, T. Tautges: Jaal: engineering a high quality all-quadrilateral mesh generator. IMR 20, 2011.
//   G. Bunin: Non-local topological clean-up. IMR 15, 2006.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "engine/base/progress.hpp"
#include "engine/mesh/constraint.hpp"
#include "kernels/cleanup/chord_collapse.hpp"
#include "kernels/cleanup/chord_report.hpp"
#include "kernels/cleanup/local.hpp"
#include "kernels/cleanup/patch_options.hpp"
#include "kernels/cleanup/patch_report.hpp"
#include "kernels/smooth/optimise.hpp"
#include "kernels/smooth/optimise_shape.hpp"
#include "kernels/smooth/square_corners.hpp"

namespace quarry {

enum class CleanUpLevel : std::uint8_t {
  kNone,    // nothing
  kLocal,   // small changes at single vertices and edges
  kFull,    // and patches up to the size that gives the best elements
  kFewest,  // and larger ones, up to the whole mesh: as few irregular vertices as can be had
};
// The word of the command line: none, local, full, fewest.
[[nodiscard]] const char* name_of(CleanUpLevel level);
// The level of such a word; kNone of any other.
[[nodiscard]] CleanUpLevel clean_up_level_of(std::string_view name);

struct CleanUpOptions {
  CleanUpLevel level = CleanUpLevel::kFull;
  // The wanted edge by place; none: faces stay as large as they are.
  const SizeField* size = nullptr;
  LocalCleanupOptions local;
  // The largest patches of kFull. Beyond about 512 faces each pair of irregular vertices that goes bends
  // thousands of quads.
  PatchOptions patches;
  // Larger patches of kFull are looked for by growth on all sides alone: growth on one side finds a few more
  // of them, and takes most of the time.
  std::size_t thorough = 128;
  // The next larger class of kFull is tried only where this share of the seeds of the one before led to a
  // patch: 0.09 to 0.2 on maps. In fans and combs of lines that nearly touch it is 0.04 and less, the next is
  // 0.01, and takes as long as all else.
  double least_yield = 0.05;
  // Then patches of so many faces that lines cross, whose numbers of edges they may change; kFewest tries
  // larger ones, too. 0: none.
  std::size_t over_lines = 128;
  // What patches have as well, like the price, is theirs.
  ChordOptions chords;
  // Sweeps over the whole mesh at the start and after each size class. Only what is far from good is moved:
  // more sweeps, or moving all, leave as many irregular vertices.
  ShapeOptions between{.sweeps = 1, .content = 0.6, .content_areas = 2, .tolerance = 0.02};
  // Sweeps at the end: first the sizes become even, then the corners square, which makes sizes less even
  // again.
  ShapeOptions shape{.sweeps = 4};
  SquareCornersOptions square_corners{.sweeps = 2, .evenness = 0.26, .rounds_together = 5};
  // In short steps: slender faces in wedges have little room.
  OptimiseOptions optimise{.smallest_step = 0.003};
};

struct CleanUpReport {
  LocalCleanupReport local;
  std::vector<PatchReport> patches;  // one a size class, at last those over lines
  ChordReport chords;                // after the first class
  LocalCleanupReport local_at_end;   // after the patches
  SweepReport between;               // all classes together
  SweepReport shape, square_corners, optimise;
  double local_seconds = 0, patch_seconds = 0, chord_seconds = 0, smoothing_seconds = 0;
};

// Every piece remains a chain of constrained sides between its nodes, along which vertices slide and whose
// number of edges may change; fixed vertices keep their bits. Faces are valid afterwards (exact) where they
// were before; triangles stay as they are. No tombstones are left; vertices and faces are renumbered along a
// Hilbert curve. The same on any number of threads.
void clean_up(Mesh& mesh, const NodedLines& lines, const CleanUpOptions& options, CleanUpReport& report,
              const Progress& progress);

}  // namespace quarry
