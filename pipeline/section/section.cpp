#include "pipeline/section/section.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "engine/mesh/compact.hpp"
#include "engine/mesh/domain.hpp"
#include "engine/mesh/pinch.hpp"
#include "engine/mesh/validate.hpp"
#include "kernels/deferred/deferred.hpp"
#include "kernels/field/size_field.hpp"
#include "kernels/local/better_flips.hpp"
#include "kernels/matching/whole_outline.hpp"
#include "kernels/smooth/laplacian.hpp"
#include "pipeline/section/line_tags.hpp"
#include "pipeline/section/price_source.hpp"
#include "pipeline/section/read_input.hpp"
#include "pipeline/section/start.hpp"

namespace quarry {
namespace {

Outline find_outline(const SectionOptions& options, const SectionInput& input, double near) {
  const LineSet& lines = input.lines;
  if (input.boundary) return boundary_outline(*input.boundary, near);
  if (options.boundary.empty()) return default_outline(lines, near);
  if (options.boundary == "box") return box_outline(lines, near);
  return hull_outline(lines, near);
}

Box2 box_of(const Outline& outline) {
  Box2 box;
  for (const OutlineRing& ring : outline.rings)
    for (const Vec2 p : ring.points) box.extend(p);
  return box;
}

// Of the polygons; those that overlap count twice, which is good enough to foresee a size.
double area_of(const Outline& outline) {
  struct Areas {
    double largest = 0, sum = 0;
  };
  std::map<std::uint32_t, Areas> polygons;
  for (const OutlineRing& ring : outline.rings) {
    double doubled = 0;
    for (std::size_t i = 0; i + 1 < ring.points.size(); ++i)
      doubled += cross(ring.points[i] - ring.points[0], ring.points[i + 1] - ring.points[0]);
    Areas& areas = polygons[ring.polygon];
    areas.largest = std::max(areas.largest, 0.5 * std::abs(doubled));
    areas.sum += 0.5 * std::abs(doubled);
  }
  // All rings of a polygon but the largest are its holes.
  double area = 0;
  for (const auto& [polygon, areas] : polygons) area += std::max(0.0, 2 * areas.largest - areas.sum);
  return area;
}

bool by_matching(const SectionOptions& options) {
  return makes_quads(options) && options.quads == QuadMethod::kMatching;
}

// Spacing of the triangles that become elements of the wanted size. Clusters halve the triangles' edges.
// Matching keeps them: a quad has the area of two triangles, which fall short of a square if they are
// equilateral.
double spacing_of(const SectionOptions& options, double size) {
  constexpr double kSideOfHalfASquare = 1.0745699318235419;
  if (!makes_quads(options)) return size;
  if (!by_matching(options)) return 2 * size;
  return options.start == StartMesh::kDelaunay ? kSideOfHalfASquare * size : size;
}

// The hull of the start mesh stays where it is.
ConstraintTags prepare_start(Mesh& mesh) {
  auto tags = ConstraintTags::add_to(mesh);
  for (const VertexId v : mesh.vertices())
    if (mesh.alive(v) && mesh.on_boundary(v)) tags.support[v] = Support::fixed();
  return tags;
}

void insert(const SectionOptions& options, SectionResult& result, const Progress& progress) {
  const double spacing = spacing_of(options, result.lengths.size);
  DeferredOptions deferred = options.preset == Preset::kPaper ? paper_options(spacing) : DeferredOptions();
  deferred.spacing = spacing;
  // A triangle becomes two or three quads, or half of one; the start mesh reaches beyond the outline.
  const double share = !makes_quads(options) ? 1.0 : by_matching(options) ? 2.0 : 0.5;
  deferred.max_faces = result.mesh.face_slots() + static_cast<std::size_t>(share * options.max_elements);
  (void)insert_lines(result.mesh, result.cleaned.lines, deferred, result.deferred, progress);
}

void match_to_quads(const SectionOptions& options, SectionResult& result, const Progress& progress) {
  MatchingOptions matching;
  matching.searching.annealing_sweeps = options.anneal;
  matching.searching.seed = options.seed;
  matching.keep_boundary = options.keep_boundary;
  // What is inverted still may be mended by the clean-up, or cut.
  matching.require_valid =
      clean_up_level(options) == CleanUpLevel::kNone && options.elements != Elements::kMixed;
  result.mesh = make_quads_by_matching(std::move(result.mesh), result.cleaned.lines, matching,
                                       result.matching, progress);
}

void convert_to_quads(const SectionOptions& options, SectionResult& result, const Progress& progress) {
  if (by_matching(options)) {
    match_to_quads(options, result, progress);
    return;
  }
  QuadOptions quads = options.preset == Preset::kPaper ? paper_quad_options() : QuadOptions();
  quads.mixed.fronts.steps = front_steps(options);
  // Clean-up ends with the same sweeps.
  if (clean_up_level(options) != CleanUpLevel::kNone) quads.square_corners.sweeps = quads.optimise.sweeps = 0;
  result.mesh = make_quads(std::move(result.mesh), result.cleaned.lines, quads, result.quads, progress);
}

void clean_up_quads(const SectionOptions& options, const PriceSource& prices, SectionResult& result,
                    const Progress& progress) {
  CleanUpOptions clean_up_options;
  clean_up_options.local.price = clean_up_options.patches.price = prices.price(result.cleaned.lines);
  clean_up_options.level = clean_up_level(options);
  const UniformSize size(result.lengths.size);
  clean_up_options.size = &size;
  clean_up(result.mesh, result.cleaned.lines, clean_up_options, result.clean_up, progress);
}

void cut_into_triangles(const SectionOptions& options, SectionResult& result) {
  result.low_quads = cut_low_quads(result.mesh, {.quality = options.mixed_quality});
  if (result.low_quads.cut > 0) compact(result.mesh, EntityOrder::kHilbert);
}

// Nothing leaves the engine that is not valid on the doubles as they will be written.
void require_valid(const Mesh& mesh) {
  const std::string failure = validate(mesh, GeometryCheck::kPlanarCorners);
  if (!failure.empty()) throw Error(ErrorKind::kBug, "the mesh is not valid: " + failure);
}

void read_and_clean(const SectionOptions& options, SectionResult& result, StageClock& clock,
                    const Progress& progress) {
  clock.start("reading");
  SectionInput input = read_section_input(options, progress);
  clock.start("cleaning");
  const Box2 box = input.lines.box();
  const double near = options.snap.value_or(0.05 * options.size.value_or(0.01 * box.longer_side()));
  result.outline = find_outline(options, input, near);
  result.lines = std::move(input.lines);
  result.projected = std::move(input.projected);
  result.system = std::move(input.system);
  result.lengths = resolve_lengths(options, box_of(result.outline), area_of(result.outline));
  result.cleaned = clean_lines(result.lines, result.outline,
                               {.snap = result.lengths.snap,
                                .min_edge = result.lengths.min_edge,
                                .tolerance = result.lengths.tolerance},
                               progress);
  result.lengths.snap = result.cleaned.options.snap;
  result.cleaned.notes.insert(result.cleaned.notes.begin(), input.notes.begin(), input.notes.end());
}

void tell_prediction(const SectionOptions& options, const SectionResult& result) {
  if (!options.on_prediction) return;
  // The start mesh covers the whole box, and its memory is needed; elements remain in the domain alone.
  const Box2 box = box_of(result.outline);
  const double in_box = predict_elements(options, box, result.lengths.size);
  const double share = std::min(1.0, area_of(result.outline) / (box.width() * box.height()));
  options.on_prediction(share * in_box, predict_bytes(in_box));
}

}  // namespace

SectionResult clean_section(const SectionOptions& options, const Progress& progress) {
  SectionResult result;
  StageClock clock(progress);
  read_and_clean(options, result, clock, progress);
  clock.stop();
  result.times = clock.times();
  return result;
}

SectionResult mesh_section(const SectionOptions& options, const Progress& progress) {
  SectionResult result;
  StageClock clock(progress);
  const PriceSource prices(options.irregular_price);
  read_and_clean(options, result, clock, progress);
  tell_prediction(options, result);
  clock.start("start mesh");
  result.orient_degrees = find_orientation(options, result.outline.rule, result.cleaned.lines);
  result.mesh = make_start_mesh(options, result.cleaned.lines, spacing_of(options, result.lengths.size),
                                result.orient_degrees);
  const ConstraintTags tags = prepare_start(result.mesh);
  clock.start("insertion");
  insert(options, result, progress);
  remove_outside(result.mesh, tags, result.cleaned.lines);
  split_pinches(result.mesh, tags);
  if (options.keep_boundary) make_outline_whole(result.mesh, result.cleaned.lines, progress);
  compact(result.mesh, EntityOrder::kHilbert);
  if (makes_quads(options)) {
    clock.start("quads");
    convert_to_quads(options, result, progress);
    clock.start("clean-up");
    clean_up_quads(options, prices, result, progress);
    if (options.elements == Elements::kMixed) cut_into_triangles(options, result);
    if (by_matching(options)) require_convex_quads(result.mesh);
  } else {
    clock.start("smoothing");
    flip_to_better(result.mesh, progress);
    result.smoothing = smooth_laplacian(result.mesh, result.cleaned.lines, LaplacianOptions(), progress);
  }
  clock.start("finishing");
  const ConstraintTags final_tags = ConstraintTags::of(result.mesh);
  result.regions = label_regions(result.mesh, final_tags);
  extract_edges(result.mesh, final_tags, result.cleaned.lines);
  result.line_groups = tag_lines(result.mesh, result.lines, options.inputs);
  mark_pinches(result.mesh, final_tags);
  require_valid(result.mesh);
  clock.stop();
  result.times = clock.times();
  return result;
}

}  // namespace quarry
