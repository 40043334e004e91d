#include <memory>
#include <string>

#include <fmt/format.h>

#include "engine/base/progress.hpp"
#include "io/mesh/mesh_format.hpp"
#include "pipeline/cli/commands.hpp"
#include "pipeline/cli/common_arguments.hpp"
#include "pipeline/cli/interrupt.hpp"
#include "pipeline/cli/outputs.hpp"
#include "pipeline/report/job_report.hpp"

namespace quarry::cli {
namespace {

struct QualityArguments {
  CommonArguments common;
  std::string input;
  bool json = false;
};

template <std::size_t kBins>
std::string histogram_row(const char* name, const ShapeSummary& shape,
                          const std::array<std::size_t, kBins>& bins) {
  std::string row = fmt::format("{:32}", name);
  for (const std::size_t count : bins) row += fmt::format(" {:8.3f}", 100 * shape.share(count));
  return row + "\n";
}

std::string range_row(const char* name, const ValueRange& range) {
  return fmt::format("{:32} {:12.6g} {:12.6g} {:12.6g}\n", name, range.min, range.mean, range.max);
}

std::string table(const QualitySummary& quality) {
  const ShapeSummary& s = quality.all;
  std::string text = fmt::format("quads {}, triangles {}, vertices {}, line edges {}\n", quality.quads.faces,
                                 quality.triangles.faces, quality.vertices, quality.edges);
  text += fmt::format("area {:.10g}, boundary length {:.10g}, shortest edge {:.6g}\n\n", quality.area,
                      quality.boundary_length, s.shortest_edge);
  text += fmt::format("{:32} {:>12} {:>12} {:>12}\n", "", "min", "mean", "max");
  text += range_row("scaled Jacobian", s.scaled_jacobian);
  text += range_row("smallest angle of a face", s.min_angle);
  text += range_row("Lo's measure (quads: Lee & Lo)", s.lo_measure);
  text += range_row("longest by shortest edge", s.aspect);
  text += fmt::format(
      "\nscaled Jacobian below 0.2: {:.4f}%, not positive: {:.4f}%; largest angle {:.2f}, over 150: "
      "{:.4f}%\n",
      100 * s.share(s.scaled_jacobian_below_0p2), 100 * s.share(s.scaled_jacobian_not_positive), s.max_angle,
      100 * s.share(s.max_angle_over_150));
  text += fmt::format("inner vertices whose valence is not {}: {:.3f}% (away from lines {:.3f}%)\n\n",
                      quality.valence.regular, 100 * quality.valence.irregular_share(),
                      100 * quality.valence.free_irregular_share());
  text += "per cent of the faces, by equal bins\n";
  text += histogram_row("scaled Jacobian, 0 to 1", s, s.scaled_jacobian_histogram);
  text += histogram_row("Lo's measure, 0 to 1", s, s.lo_histogram);
  text += histogram_row("smallest angle, 0 to 90 degrees", s, s.min_angle_histogram);
  return text;
}

void run(const QualityArguments& arguments) {
  const Progress progress({}, &interrupt_token());
  const Mesh mesh = read_mesh(arguments.input);
  progress.throw_if_cancelled();
  const QualitySummary quality = summarize_quality(mesh);
  progress.throw_if_cancelled();
  write_standard_output(arguments.json ? quality_text(quality) : table(quality));
}

}  // namespace

void add_quality_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand("quality", "every measure of a mesh file");
  const auto arguments = std::make_shared<QualityArguments>();
  command->add_option("mesh", arguments->input, "the mesh to measure: " + readable_mesh_formats())
      ->required()
      ->type_name("MESH");
  command->add_flag("--json", arguments->json, "as JSON, with the keys of a report's \"quality\"");
  add_common_options(*command, arguments->common);
  command->callback([arguments] { run_job(arguments->common, [&] { run(*arguments); }); });
}

}  // namespace quarry::cli
