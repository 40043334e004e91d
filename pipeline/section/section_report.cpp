#include "pipeline/section/section_report.hpp"

#include <algorithm>
#include <cstdint>
#include <type_traits>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/lines/companion_file.hpp"
#include "pipeline/report/input_hash.hpp"
#include "pipeline/report/line_description.hpp"
#include "pipeline/report/line_distance.hpp"
#include "pipeline/report/low_quad_counts.hpp"
#include "pipeline/report/region_summary.hpp"
#include "pipeline/section/boundary_rule.hpp"
#include "pipeline/section/price_source.hpp"
#include "pipeline/section/region_names.hpp"

namespace quarry {
namespace {

std::int64_t whole(std::uint64_t count) { return static_cast<std::int64_t>(count); }

std::string boundary_text(const SectionOptions& options) {
  switch (parse_boundary(options.boundary).kind) {
    case BoundaryRule::Kind::kDefault:
      return "default";
    case BoundaryRule::Kind::kFile:
      return "file";
    default:
      return options.boundary;
  }
}

std::string start_text(const SectionOptions& options) {
  if (options.start == StartMesh::kFile) return "file";
  return options.start == StartMesh::kDelaunay ? "delaunay" : "4-8";
}

const char* name_of(Elements elements) {
  switch (elements) {
    case Elements::kTriangle:
      return "tri";
    case Elements::kMixed:
      return "mixed";
    case Elements::kQuad:
      break;
  }
  return "quad";
}

std::vector<ReportItem> counts_of(const SectionOptions& options, const SectionResult& result,
                                  const QualitySummary& quality) {
  const CleanCounts& c = result.cleaned.counts;
  const DeferredReport& d = result.deferred;
  std::vector<ReportItem> counts = {{"vertices", whole(quality.vertices)},
                                    {"triangles", whole(quality.triangles.faces)},
                                    {"quads", whole(quality.quads.faces)},
                                    {"line_edges", whole(quality.edges)},
                                    {"regions", std::int64_t{result.regions}},
                                    {"input_lines", whole(result.cleaned.ledger.size())},
                                    {"input_points", whole(result.cleaned.points.size())},
                                    {"cleaned_nodes", whole(result.cleaned.lines.nodes.size())},
                                    {"cleaned_pieces", whole(result.cleaned.lines.pieces.size())},
                                    {"crossings", std::int64_t{c.crossings}},
                                    {"closed_wedges", std::int64_t{c.closed_wedges}},
                                    {"reroutes", std::int64_t{c.reroutes}},
                                    {"simplified_bends", std::int64_t{c.simplified}},
                                    {"collapsed_pieces", std::int64_t{c.collapsed}},
                                    {"short_pieces_kept", std::int64_t{c.short_pieces}},
                                    {"duplicate_lines", std::int64_t{c.duplicate_lines}},
                                    {"empty_segments", std::int64_t{c.empty_segments}},
                                    {"cut_dangles", std::int64_t{c.cut_dangles}},
                                    {"i_nodes", std::int64_t{c.nodes.isolated}},
                                    {"y_nodes", std::int64_t{c.nodes.abutting}},
                                    {"x_nodes", std::int64_t{c.nodes.crossing}},
                                    {"e_nodes", std::int64_t{c.nodes.edge}},
                                    {"smallest_line_angle", c.smallest_angle},
                                    {"largest_move", c.largest_move},
                                    {"attractions", whole(d.attractions)},
                                    {"flips", whole(d.flips)},
                                    {"splits", whole(d.splits)},
                                    {"fallbacks", whole(d.fallbacks)},
                                    {"rebuilt_pieces", whole(d.rebuilt)},
                                    {"pairs", whole(result.quads.mixed.pairing.pairs)},
                                    {"single_triangles", whole(result.quads.mixed.pairing.singles)},
                                    {"steiner_points", whole(result.matching.steiner_points)},
                                    {"annealing_moves", whole(result.matching.search.annealing_moves)},
                                    {"edges_halved_for_parity", whole(result.matching.parity.halved_edges)},
                                    {"forced_merges_opened", whole(result.matching.ears.opened)}};
  if (options.elements == Elements::kMixed) add_low_quads(counts, result.low_quads);
  return counts;
}

void add_sizes(std::vector<ReportItem>& items, const SizeOptions& options, const WantedSizes& sizes) {
  if (!options.file.empty()) items.push_back({"size-field", std::string("file")});
  if (!options.near.empty()) items.push_back({"refine-near", options.near});
  if (options.between) items.push_back({"between-lines", *options.between});
  items.push_back({"gradation", options.gradation});
  items.push_back({"smallest", sizes.smallest()});
}

}  // namespace

std::vector<ReportItem> resolved_options(const SectionOptions& options, const SectionResult& result) {
  std::vector<ReportItem> items = {
      {"size", result.lengths.size},
      {"snap", result.lengths.snap},
      {"min-edge", result.lengths.min_edge},
      {"tolerance", result.lengths.tolerance},
      {"boundary", boundary_text(options)},
      {"elements", std::string(name_of(options.elements))},
      {"method", std::string("deferred")},
      {"start", start_text(options)},
      {"orient", result.orient_degrees},
      {"preset", std::string(options.preset == Preset::kPaper ? "paper" : "default")},
      {"fronts", whole(static_cast<std::uint64_t>(front_steps(options)))},
      {"quads", std::string(options.quads == QuadMethod::kMatching ? "matching" : "cluster")},
      {"keep-boundary", whole(options.keep_boundary ? 1 : 0)},
      {"cleanup", std::string(name_of(clean_up_level(options)))},
      {"seed", whole(options.seed)}};
  if (options.quads == QuadMethod::kMatching)
    items.push_back({"anneal", whole(static_cast<std::uint64_t>(options.anneal))});
  if (!options.irregular_price.empty())
    items.push_back({"irregular-price", price_text(options.irregular_price)});
  if (options.elements == Elements::kMixed) items.push_back({"mixed-quality", options.mixed_quality});
  if (result.sizes) add_sizes(items, options.sizes, *result.sizes);
  if (!result.projected.empty()) items.push_back({"project", result.projected});
  if (options.as_is) items.push_back({"as-is", true});
  if (!options.section.empty()) items.push_back({"section", options.section});
  if (!options.seed_points.empty()) items.push_back({"seed-point", options.seed_points});
  return items;
}

std::string option_text(const std::vector<ReportItem>& options) {
  std::string text;
  for (const ReportItem& item : options) {
    const std::string value = std::visit(
        [](const auto& v) {
          if constexpr (std::is_same_v<std::decay_t<decltype(v)>, std::vector<std::string>>)
            return fmt::format("{}", fmt::join(v, ","));
          else
            return fmt::format("{}", v);
        },
        item.value);
    text += fmt::format("{}{}={}", text.empty() ? "" : " ", item.name, value);
  }
  return text;
}

std::vector<std::string> input_files(const SectionOptions& options) {
  std::vector<std::string> paths;
  for (const std::string& input : options.inputs)
    for (std::string& file : files_read_with(input)) paths.push_back(std::move(file));
  if (boundary_text(options) == "file")
    for (std::string& file : files_read_with(options.boundary)) paths.push_back(std::move(file));
  if (options.start == StartMesh::kFile) paths.push_back(options.start_file);
  if (const std::string prices = price_file(options.irregular_price); !prices.empty())
    paths.push_back(prices);
  if (!options.sizes.file.empty()) paths.push_back(options.sizes.file);
  return paths;
}

std::string hash_inputs(const SectionOptions& options) { return hash_files(input_files(options)); }

namespace {

// Those of the last mesh that --count asked for, in the order in which they ran; none of a job that only
// cleans.
std::vector<PassReport> passes_of(const SectionOptions& options, const SectionResult& result) {
  if (result.mesh.face_slots() == 0) return {};
  std::vector<PassReport> passes;
  if (result.sizes) passes.push_back(result.start);
  passes.insert(passes.end(), {result.deferred.nodes, result.deferred.pieces});
  const auto append = [&](const std::vector<PassReport>& more) {
    passes.insert(passes.end(), more.begin(), more.end());
  };
  if (options.keep_boundary) passes.push_back(result.whole_outline);
  if (!makes_quads(options)) {
    passes.push_back(result.flips);
  } else if (options.quads == QuadMethod::kMatching) {
    passes.push_back(result.matching.flips);
    append(result.matching.openings);
    append(result.matching.rings);
  } else {
    if (front_steps(options) > 0) append({result.quads.mixed.fronts.splits, result.quads.mixed.fronts.swaps});
    append(result.quads.mixed.rearrange);
  }
  return passes;
}

}  // namespace

JobReport report_section(const SectionOptions& options, const SectionResult& result, QualitySummary quality) {
  JobReport report;
  report.options = resolved_options(options, result);
  report.input_files = options.inputs;
  report.outline = result.outline.text;
  report.lines = result.cleaned.ledger;
  report.points = result.cleaned.points;
  describe_lines(result.lines, 0, report);
  if (result.mesh.face_slots() > 0) {
    report.line_distances = measure_line_distances(result.mesh, result.lines, result.cleaned.ledger);
    report.regions = summarize_regions(result.mesh, result.groups);
  }
  report.counts = counts_of(options, result, quality);
  report.quality = std::move(quality);
  report.passes = passes_of(options, result);
  if (clean_up_level(options) != CleanUpLevel::kNone) report.clean_up = result.clean_up;
  report.times = result.times;
  report.notes = result.cleaned.notes;
  return report;
}

}  // namespace quarry
