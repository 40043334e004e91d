// Options of the section job: lines of a plane in, a mesh that honours them out.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/geometry/box.hpp"
#include "kernels/cleanup/clean_up.hpp"
#include "kernels/cluster/low_quads.hpp"
#include "pipeline/section/wanted_sizes.hpp"

namespace quarry {

enum class Elements {
  kQuad,
  kTriangle,
  kMixed,  // quads, but two triangles where a quad would be too bad
};
enum class StartMesh { kCrisscross, kDelaunay, kFile };
enum class QuadMethod { kCluster, kMatching };
enum class Preset { kDefault, kPaper };

struct SectionOptions {
  std::vector<std::string> inputs;
  // What becomes of degrees: brought to the local UTM zone, or taken for lengths; neither: an error.
  bool project = false;
  bool as_is = false;
  // "x=VALUE" or "y=VALUE": the lines that stand in this vertical plane; "": seen from above.
  std::string section;
  // As pipeline/section/boundary_rule.hpp reads it.
  std::string boundary;
  // Wanted edge of the final elements in input units; or about how many elements. Exactly one is given.
  std::optional<double> size;
  std::optional<double> count;
  // Where elements are to be smaller than that.
  SizeOptions sizes;
  // Names of regions: "X,Y,NAME", in the coordinates of the mesh.
  std::vector<std::string> seed_points;
  double max_elements = 2e8;
  // Lengths in input units; unset: 0.05, 0.1 and 0.05 of the smallest size wanted on a line.
  std::optional<double> snap, min_edge, tolerance;
  Elements elements = Elements::kQuad;
  // Of mixed meshes: quads with a smaller scaled Jacobian are cut into triangles where that helps.
  double mixed_quality = LowQuadOptions().quality;
  StartMesh start = StartMesh::kCrisscross;
  std::string start_file;
  // Direction of the start mesh; neither: along the box where the outline is one, else as for orient_auto.
  std::optional<double> orient_degrees;
  bool orient_auto = false;  // along the direction that the lines prefer
  Preset preset = Preset::kDefault;
  // Steps that alignment fronts take away from the lines before triangles are paired; unset: what the preset
  // says (none, or 4 as published).
  std::optional<int> fronts;
  QuadMethod quads = QuadMethod::kCluster;
  // Sweeps of annealing while triangles are matched.
  int anneal = 0;
  // The boundary has the outline's own vertices alone: none added, none moved. With matching.
  bool keep_boundary = false;
  // Topological clean-up of quads; unset: full, or none with the published procedure.
  std::optional<CleanUpLevel> cleanup;
  // Where irregular vertices are dear to the clean-up, as pipeline/section/price_source.hpp reads it.
  std::string irregular_price;
  std::uint64_t seed = 0;
  // Told before meshing begins: about how many elements and how many bytes of memory it will take.
  std::function<void(double elements, double bytes)> on_prediction;
};

// The lengths that a job works with once the size is known, all in input units.
struct ResolvedLengths {
  double size = 0;
  double snap = 0;
  double min_edge = 0;
  double tolerance = 0;
};

// The size asked for, or what --count means in a domain of this area and box. Throws Error(kUsage) for values
// that make no sense.
[[nodiscard]] double resolve_size(const SectionOptions& options, const Box2& box, double area);

// Fills in defaults; smallest: the smallest size wanted on a line. Throws Error(kUsage) for values that make
// no sense.
[[nodiscard]] ResolvedLengths resolve_lengths(const SectionOptions& options, double size, double smallest);

// So many elements take the area of so many squares of the wanted size.
[[nodiscard]] double squares_of(const SectionOptions& options, double elements);

// Throws Error(kBudget) if so many elements are more than max_elements.
void require_within_budget(const SectionOptions& options, double size, double elements);

// True if the mesh is made of quads, all or most of them.
[[nodiscard]] bool makes_quads(const SectionOptions& options);

// Steps of alignment fronts that the options and their preset ask for.
[[nodiscard]] int front_steps(const SectionOptions& options);

// Below which angle wedges between the lines of a mesh are closed, in degrees (CleanOptions::closed_wedge);
// none with the published procedure, nor where the outline takes no vertex.
[[nodiscard]] double closed_wedge(const SectionOptions& options);

// The clean-up that the options and their preset ask for; none for triangles.
[[nodiscard]] CleanUpLevel clean_up_level(const SectionOptions& options);

// About how many elements of one size a box takes; sizes: of the elements, where they differ.
[[nodiscard]] double predict_elements(const SectionOptions& options, const Box2& box, double size,
                                      const WantedSizes* sizes);

// Bytes of memory that a job of so many elements takes at its peak.
[[nodiscard]] double predict_bytes(double elements);

}  // namespace quarry
