#include "pipeline/improve/improve_report.hpp"

#include <cstdint>
#include <utility>

#include "pipeline/report/input_hash.hpp"
#include "pipeline/report/low_quad_counts.hpp"
#include "pipeline/report/region_summary.hpp"
#include "pipeline/section/price_source.hpp"

namespace quarry {
namespace {

std::int64_t whole(std::size_t count) { return static_cast<std::int64_t>(count); }

}  // namespace

std::vector<ReportItem> resolved_options(const ImproveOptions& options, const ImproveResult& result) {
  std::vector<ReportItem> items = {{"cleanup", std::string(name_of(options.cleanup))},
                                   {"tolerance", result.tolerance}};
  if (options.size) items.push_back({"size", *options.size});
  if (!options.irregular_price.empty())
    items.push_back({"irregular-price", price_text(options.irregular_price)});
  if (!result.mesh.planar()) items.push_back({"sharp", result.sharp_degrees});
  if (options.mixed_quality) {
    items.push_back({"elements", std::string("mixed")});
    items.push_back({"mixed-quality", *options.mixed_quality});
  }
  return items;
}

std::string hash_inputs(const ImproveOptions& options) {
  std::vector<std::string> paths = {options.input};
  if (const std::string prices = price_file(options.irregular_price); !prices.empty())
    paths.push_back(prices);
  return hash_files(paths);
}

JobReport report_improvement(const ImproveOptions& options, const ImproveResult& result,
                             QualitySummary quality) {
  JobReport report;
  report.command = "improve";
  report.options = resolved_options(options, result);
  report.input_files = {options.input};
  report.outline = "boundary of the mesh";
  report.regions = summarize_regions(result.mesh, result.groups);
  report.counts = {
      {"vertices", whole(quality.vertices)},          {"triangles", whole(quality.triangles.faces)},
      {"quads", whole(quality.quads.faces)},          {"line_edges", whole(quality.edges)},
      {"tagged_edges", whole(result.tagged_edges)},   {"fixed_nodes", whole(result.nodes)},
      {"straight_pieces", whole(result.pieces)},      {"turned_faces", whole(result.turned)},
      {"invalid_faces_before", whole(result.invalid)}};
  if (!result.mesh.planar()) report.counts.push_back({"sharp_edges", whole(result.sharp_edges)});
  if (options.mixed_quality) add_low_quads(report.counts, result.low_quads);
  report.quality = std::move(quality);
  report.quality_before = result.before;
  if (options.cleanup != CleanUpLevel::kNone) report.clean_up = result.clean_up;
  report.notes = result.notes;
  report.times = result.times;
  return report;
}

}  // namespace quarry
