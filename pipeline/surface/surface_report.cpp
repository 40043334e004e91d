#include "pipeline/surface/surface_report.hpp"

#include <array>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "pipeline/report/line_description.hpp"
#include "pipeline/report/region_summary.hpp"
#include "pipeline/surface/surface_lines.hpp"

namespace quarry {
namespace {

std::int64_t whole(std::uint64_t count) { return static_cast<std::int64_t>(count); }

struct RepairLine {
  const char* name;    // in the report
  const char* action;  // as people read it
  const RepairCount& count;
};

std::array<RepairLine, 12> repair_lines(const RepairReport& repair) {
  return {
      {{"welded_points", "points that went into another", repair.welded},
       {"unused_points", "points without a triangle left out", repair.unused},
       {"degenerate_triangles", "triangles of fewer than three points left out", repair.degenerate},
       {"duplicate_triangles", "triangles that were there twice left out", repair.duplicate},
       {"hanging_triangles", "flat triangles that hung on an edge of two others left out", repair.hanging},
       {"cap_triangles", "flat triangles left out, those across their longest edge cut instead", repair.caps},
       {"turned_triangles", "triangles turned to face as their neighbours do", repair.turned},
       {"filled_holes", "holes filled", repair.filled_holes},
       {"flat_triangles", "triangles without area kept", repair.flat},
       {"branch_edges", "edges of three triangles or more kept: the sheets meet there", repair.branches},
       {"pinch_points", "points in which the surface touches itself, one vertex for each fan of triangles",
        repair.pinches},
       {"seam_edges", "edges along which the one-sided surface is cut", repair.seams}}};
}

std::string places_of(const RepairCount& count) {
  std::string text;
  for (const Vec3 p : count.places) text += fmt::format(" ({:.9g}, {:.9g}, {:.9g})", p.x, p.y, p.z);
  return count.count > count.places.size() ? text + " ..." : text;
}

}  // namespace

std::vector<ReportItem> resolved_options(const SurfaceOptions& options, const SurfaceResult& result) {
  std::vector<ReportItem> items{
      {"size", result.size},
      {"elements", std::string(options.elements == Elements::kTriangle ? "tri" : "quad")},
      {"cleanup",
       std::string(name_of(options.elements == Elements::kTriangle ? CleanUpLevel::kNone : options.cleanup))},
      {"sharp", result.features.sharp_degrees},
      {"curvature", options.curvature.value_or(0)},
      {"weld", options.repair.weld},
      {"fill-holes", std::int64_t{options.repair.fill_holes}}};
  if (options.keep_boundary) items.push_back({"keep-boundary", std::int64_t{1}});
  if (options.elements != Elements::kTriangle)
    items.push_back({"quads", std::string(name_of(result.method))});
  if (result.method == SurfaceQuads::kMatching) {
    items.push_back({"anneal", std::int64_t{options.anneal}});
    items.push_back({"seed", whole(options.seed)});
  }
  return items;
}

JobReport report_surface(const SurfaceOptions& options, const SurfaceResult& result, QualitySummary quality) {
  JobReport report;
  report.options = resolved_options(options, result);
  report.input_files = options.inputs;
  report.outline = "rims of the surface";
  report.regions = summarize_regions(result.mesh);
  const FeatureCounts& f = result.features;
  const RemeshReport& r = result.remesh;
  report.counts = {{"vertices", whole(quality.vertices)},       {"triangles", whole(quality.triangles.faces)},
                   {"quads", whole(quality.quads.faces)},       {"line_edges", whole(quality.edges)},
                   {"feature_nodes", whole(f.nodes)},           {"feature_curves", whole(f.curves)},
                   {"sharp_input_edges", whole(f.sharp_edges)}, {"border_input_edges", whole(f.border_edges)},
                   {"rim_input_edges", whole(f.rim_edges)},     {"join_input_edges", whole(f.join_edges)},
                   {"holes", whole(result.repair.holes)},       {"splits", whole(r.splits.won)},
                   {"collapses", whole(r.collapses.won)},       {"flips", whole(r.flips.won)}};
  if (options.elements != Elements::kTriangle && result.method == SurfaceQuads::kField)
    report.counts.push_back({"singularities", whole(result.lattice.singularities)});
  report.passes = {r.splits, r.collapses, r.flips};
  if (result.method == SurfaceQuads::kField)
    report.passes.insert(report.passes.end(),
                         {result.lattice.joins, result.lattice.collapses, result.lattice.flips});
  if (result.method == SurfaceQuads::kMatching) {
    const MatchingReport& m = result.quads.matching;
    report.counts.insert(report.counts.end(), {{"steiner_points", whole(m.steiner_points)},
                                               {"annealing_moves", whole(m.search.annealing_moves)},
                                               {"edges_halved_for_parity", whole(m.parity.halved_edges)},
                                               {"forced_merges_opened", whole(m.ears.opened)}});
  }
  report.notes = result.notes;
  if (!options.lines.empty()) {
    describe_lines(result.lines, static_cast<std::uint32_t>(report.input_files.size()), report);
    report.input_files.insert(report.input_files.end(), options.lines.begin(), options.lines.end());
    report.counts.insert(report.counts.end(), {{"lines", whole(result.lines.lines.size())},
                                               {"imprinted_lines", whole(result.imprint.imprinted)},
                                               {"line_ends_outside", whole(result.imprint.outside.count)},
                                               {"lost_stretches", whole(result.imprint.lost.count)}});
    report.lines = ledger_of(result.imprint);
    report.line_distances = line_distances(result);
    report.notes.push_back(fmt::format("{} of {} lines lie on the surface, with all or a part of them",
                                       result.imprint.imprinted, result.lines.lines.size()));
    if (result.imprint.outside.count > 0)
      report.notes.push_back(fmt::format("{} times a line leaves the surface or comes to it, at{}",
                                         result.imprint.outside.count, places_of(result.imprint.outside)));
    if (result.imprint.lost.count > 0)
      report.notes.push_back(
          fmt::format("{} stretches of lines could not be followed across the surface, before{}",
                      result.imprint.lost.count, places_of(result.imprint.lost)));
  }
  for (const RepairLine& line : repair_lines(result.repair)) {
    report.counts.push_back({line.name, whole(line.count.count)});
    if (line.count.count > 0)
      report.notes.push_back(
          fmt::format("{} {}, at{}", line.count.count, line.action, places_of(line.count)));
  }
  report.quality = std::move(quality);
  if (options.elements != Elements::kTriangle && options.cleanup != CleanUpLevel::kNone)
    report.clean_up = result.quads.clean_up;
  report.times = result.times;
  return report;
}

}  // namespace quarry
