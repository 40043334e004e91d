#include "pipeline/section/section.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "engine/base/heap.hpp"
#include "engine/mesh/compact.hpp"
#include "engine/mesh/domain.hpp"
#include "engine/mesh/pinch.hpp"
#include "engine/mesh/validate.hpp"
#include "kernels/deferred/deferred.hpp"
#include "kernels/field/size_field.hpp"
#include "kernels/local/better_flips.hpp"
#include "kernels/matching/whole_outline.hpp"
#include "kernels/smooth/laplacian.hpp"
#include "pipeline/report/count_note.hpp"
#include "pipeline/section/boundary_rule.hpp"
#include "pipeline/section/conservation.hpp"
#include "pipeline/section/count_search.hpp"
#include "pipeline/section/line_tags.hpp"
#include "pipeline/section/outline_measures.hpp"
#include "pipeline/section/point_tags.hpp"
#include "pipeline/section/price_source.hpp"
#include "pipeline/section/read_input.hpp"
#include "pipeline/section/region_names.hpp"
#include "pipeline/section/start.hpp"

namespace quarry {
namespace {

Outline find_outline(const SectionOptions& options, const SectionInput& input, double near) {
  const LineSet& lines = input.lines;
  const BoundaryRule rule = parse_boundary(options.boundary);
  switch (rule.kind) {
    case BoundaryRule::Kind::kFile:
      return boundary_outline(*input.boundary, near);
    case BoundaryRule::Kind::kBox:
      return box_outline(lines, near, rule.margin * (rule.margin_is_share ? lines.box().longer_side() : 1.0));
    case BoundaryRule::Kind::kHull:
      return hull_outline(lines, near);
    case BoundaryRule::Kind::kDefault:
      break;
  }
  return default_outline(lines, near);
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

Mesh start_mesh(const SectionOptions& options, SectionResult& result, const Progress& progress) {
  const double spacing = spacing_of(options, result.lengths.size);
  const NodedLines& lines = result.cleaned.lines;
  if (!result.sizes) return make_start_mesh(options, lines, spacing, result.orient_degrees);
  // Triangles are in proportion to the elements that they become.
  const ScaledSize sizes(result.sizes->field(), spacing / result.lengths.size);
  return make_graded_start(lines, sizes, spacing, result.orient_degrees, result.start, progress);
}

void insert(const SectionOptions& options, SectionResult& result, const Progress& progress) {
  const double spacing = spacing_of(options, result.sizes ? result.sizes->smallest() : result.lengths.size);
  DeferredOptions deferred = options.preset == Preset::kPaper ? paper_options(spacing) : DeferredOptions();
  deferred.spacing = spacing;
  // A triangle becomes two or three quads, or half of one; the start mesh reaches beyond the outline.
  const double share = !makes_quads(options) ? 1.0 : by_matching(options) ? 2.0 : 0.5;
  deferred.max_faces = result.mesh.face_slots() + static_cast<std::size_t>(share * options.max_elements);
  (void)insert_lines(result.mesh, result.cleaned.lines, deferred, result.deferred, progress);
}

// A start mesh with the lines in it, and nothing outside the outline.
void make_triangles(const SectionOptions& options, SectionResult& result, StageClock& clock,
                    const Progress& progress) {
  clock.start("start mesh");
  result.orient_degrees = find_orientation(options, result.outline.rule, result.cleaned.lines);
  result.mesh = start_mesh(options, result, progress);
  const ConstraintTags tags = prepare_start(result.mesh);
  clock.start("insertion");
  result.deferred = {};
  insert(options, result, progress);
  remove_outside(result.mesh, tags, result.cleaned.lines);
  split_pinches(result.mesh, tags);
  if (options.keep_boundary)
    result.whole_outline = make_outline_whole(result.mesh, result.cleaned.lines, progress);
  compact(result.mesh, EntityOrder::kHilbert);
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
    result.matching = {};
    match_to_quads(options, result, progress);
    return;
  }
  QuadOptions quads = options.preset == Preset::kPaper ? paper_quad_options() : QuadOptions();
  quads.mixed.fronts.steps = front_steps(options);
  // Clean-up ends with the same sweeps.
  if (clean_up_level(options) != CleanUpLevel::kNone) quads.square_corners.sweeps = quads.optimise.sweeps = 0;
  result.quads = {};
  result.mesh = make_quads(std::move(result.mesh), result.cleaned.lines, quads, result.quads, progress);
}

void clean_up_quads(const SectionOptions& options, const PriceSource& prices, SectionResult& result,
                    const Progress& progress) {
  if (clean_up_level(options) != CleanUpLevel::kNone) give_back_freed_memory();
  CleanUpOptions clean_up_options;
  clean_up_options.local.price = clean_up_options.patches.price = prices.price(result.cleaned.lines);
  clean_up_options.level = clean_up_level(options);
  const UniformSize size(result.lengths.size);
  if (options.count) {
    clean_up_options.patches.wanted_faces = static_cast<std::size_t>(*options.count);
    clean_up_options.patches.most_growth = clean_up_options.patches.most_shrinkage = kCountTolerance;
  }
  clean_up_options.size = result.sizes ? &result.sizes->field() : &size;
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

// Multiplies the sizes so that their squares fill the domain as often as elements are wanted.
void fit_count(const SectionOptions& options, SectionResult& result) {
  const InsideOutline inside(result.outline);
  result.sizes->fit(squares_of(options, *options.count), box_of(result.outline), std::cref(inside));
  result.lengths.size = result.sizes->largest();
}

void read(const SectionOptions& options, SectionResult& result, StageClock& clock, const Progress& progress) {
  clock.start("reading");
  SectionInput input = read_section_input(options, progress);
  clock.start("cleaning");
  const Box2 box = input.lines.box();
  const double near = options.snap.value_or(0.05 * options.size.value_or(0.01 * box.longer_side()));
  result.outline = find_outline(options, input, near);
  result.lines = std::move(input.lines);
  result.boundary = std::move(input.boundary);
  result.projected = std::move(input.projected);
  result.system = std::move(input.system);
  result.notes = std::move(input.notes);
  const double size = resolve_size(options, box_of(result.outline), area_of(result.outline));
  result.lengths.size = size;
  if (!options.sizes.uniform())
    result.sizes =
        std::make_shared<WantedSizes>(options.sizes, result.lines, file_group_names(options.inputs), size);
  if (result.sizes && options.count) fit_count(options, result);
}

// How many elements the sizes that are wanted by now mean.
void foresee(const SectionOptions& options, SectionResult& result) {
  const double size = result.lengths.size;
  result.elements = predict_elements(options, box_of(result.outline), size, result.sizes.get());
  require_within_budget(options, size, result.elements);
}

// Cleans the lines for the size that is wanted by now.
// wedge: CleanOptions::closed_wedge.
void clean(const SectionOptions& options, double wedge, SectionResult& result, StageClock& clock,
           const Progress& progress) {
  clock.start("cleaning");
  foresee(options, result);
  const double size = result.lengths.size;
  result.lengths =
      resolve_lengths(options, size, result.sizes ? result.sizes->smallest_on(result.lines) : size);
  result.cleaned = clean_lines(result.lines, result.outline,
                               {.snap = result.lengths.snap,
                                .min_edge = result.lengths.min_edge,
                                .tolerance = result.lengths.tolerance,
                                .closed_wedge = wedge},
                               progress);
  require_all_told(result.lines, result.cleaned);
  result.lengths.snap = result.cleaned.options.snap;
  result.lengths.min_edge = result.cleaned.options.min_edge;
  if (result.sizes) {
    result.sizes->set_gaps(result.cleaned.lines);
    foresee(options, result);
  }
  result.cleaned.notes.insert(result.cleaned.notes.begin(), result.notes.begin(), result.notes.end());
}

// The files that may name regions: those of the lines and that of the outline.
std::vector<const LineSet*> sets_of(const SectionResult& result) {
  std::vector<const LineSet*> sets = {&result.lines};
  if (result.boundary) sets.push_back(&*result.boundary);
  return sets;
}

void tell_prediction(const SectionOptions& options, const SectionResult& result) {
  if (!options.on_prediction) return;
  // The start mesh covers the whole box, and its memory is needed; elements remain in the domain alone.
  const Box2 box = box_of(result.outline);
  const double share = std::min(1.0, area_of(result.outline) / (box.width() * box.height()));
  options.on_prediction(share * result.elements, predict_bytes(result.elements));
}

// With --count sizes are mended until the count is met.
void make_elements(const SectionOptions& options, SectionResult& result, StageClock& clock,
                   const Progress& progress) {
  std::optional<CountSearch> search;
  if (options.count && options.start != StartMesh::kFile) search.emplace(*options.count, result.lengths.size);
  for (bool first = true;; first = false) {
    clean(options, closed_wedge(options), result, clock, progress);
    if (first) tell_prediction(options, result);
    make_triangles(options, result, clock, progress);
    if (makes_quads(options)) {
      clock.start("quads");
      convert_to_quads(options, result, progress);
    }
    if (!search) return;
    const std::optional<double> size = search->next(static_cast<double>(result.mesh.count_alive_faces()));
    if (!size) return;
    if (result.sizes) result.sizes->multiply(*size / result.lengths.size);
    result.lengths.size = *size;
  }
}

}  // namespace

SectionResult clean_section(const SectionOptions& options, const Progress& progress) {
  SectionResult result;
  StageClock clock(progress);
  read(options, result, clock, progress);
  clean(options, 0, result, clock, progress);  // a narrow crossing stays one
  clock.stop();
  result.times = clock.times();
  return result;
}

SectionResult mesh_section(const SectionOptions& options, const Progress& progress) {
  SectionResult result;
  StageClock clock(progress);
  const PriceSource prices(options.irregular_price);
  const std::vector<SeedPoint> seeds = parse_seed_points(options.seed_points);
  read(options, result, clock, progress);
  make_elements(options, result, clock, progress);
  if (makes_quads(options)) {
    clock.start("clean-up");
    clean_up_quads(options, prices, result, progress);
    if (options.elements == Elements::kMixed) cut_into_triangles(options, result);
    if (by_matching(options)) require_convex_quads(result.mesh);
  } else {
    clock.start("smoothing");
    result.flips = flip_to_better(result.mesh, progress);
    result.smoothing = smooth_laplacian(result.mesh, result.cleaned.lines, LaplacianOptions(), progress);
  }
  clock.start("finishing");
  const ConstraintTags final_tags = ConstraintTags::of(result.mesh);
  result.regions = label_regions(result.mesh, final_tags);
  extract_edges(result.mesh, final_tags, result.cleaned.lines);
  require_lines_kept(result.mesh, result.cleaned);
  tag_points(result.mesh, result.cleaned);
  result.groups = tag_lines(result.mesh, result.lines, options.inputs);
  if (result.outline.rule == OutlineRule::kBox) tag_box_sides(result.mesh, result.groups);
  name_regions(result.mesh, sets_of(result), seeds, result.groups);
  mark_pinches(result.mesh, final_tags);
  require_valid(result.mesh);
  if (const auto note = count_note(options.count, result.mesh, "lines and boundary"))
    result.cleaned.notes.push_back(*note);
  clock.stop();
  result.times = clock.times();
  return result;
}

}  // namespace quarry
