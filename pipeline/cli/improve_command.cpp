#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "engine/base/log.hpp"
#include "io/mesh/mesh_format.hpp"
#include "io/page/page.hpp"
#include "io/picture/picture.hpp"
#include "kernels/quality/face.hpp"
#include "pipeline/cli/commands.hpp"
#include "pipeline/cli/common_arguments.hpp"
#include "pipeline/cli/config_file.hpp"
#include "pipeline/cli/demands.hpp"
#include "pipeline/cli/irregular_price.hpp"
#include "pipeline/cli/mesh_output.hpp"
#include "pipeline/cli/mixed_quality.hpp"
#include "pipeline/cli/outputs.hpp"
#include "pipeline/cli/page_output.hpp"
#include "pipeline/cli/progress_bar.hpp"
#include "pipeline/cli/sharpness.hpp"
#include "pipeline/cli/summary_text.hpp"
#include "pipeline/improve/improve_report.hpp"
#include "pipeline/section/section_report.hpp"

namespace quarry::cli {
namespace {

struct ImproveArguments {
  ImproveOptions improve;
  CommonArguments common;
  std::string output, report, picture, page, config;
  std::string cleanup = "full", elements = "same", sharp = "auto";
  std::optional<double> mixed_quality;
  std::vector<std::string> require;
  MeshOutput written;
};

void check(ImproveArguments& arguments) {
  if (arguments.improve.input.empty())
    throw Error(ErrorKind::kUsage, "no mesh is given; see quarry improve --help");
  if (arguments.output.empty()) throw Error(ErrorKind::kUsage, "no output is given: name it with -o OUT.vtu");
  check_readable_extension(arguments.improve.input);
  arguments.written.check(arguments.output);
  if (!arguments.picture.empty()) check_picture_extension(arguments.picture);
  if (!arguments.page.empty()) check_page_extension(arguments.page);
  arguments.improve.cleanup = clean_up_level_of(arguments.cleanup);
  arguments.improve.sharp_degrees = sharpness_of(arguments.sharp);
  const double mixed_quality = mixed_quality_of(arguments.elements, arguments.mixed_quality);
  if (arguments.elements == "mixed") arguments.improve.mixed_quality = mixed_quality;
  check_irregular_price(arguments.improve.irregular_price, arguments.improve.cleanup);
  check_outputs({arguments.output, arguments.report, arguments.picture, arguments.page},
                {arguments.improve.input, price_file(arguments.improve.irregular_price)});
}

void write_mesh_file(const ImproveArguments& arguments, const ImproveResult& result,
                     const std::string& hash) {
  const std::vector<double> jacobians = scaled_jacobians(result.mesh);
  MeshWriteOptions options = arguments.written.write_options();
  options.fields = {
      {"quarry_version", QUARRY_VERSION},
      {"input_hash", hash},
      {"options", option_text(resolved_options(arguments.improve, result)) + arguments.written.text()}};
  options.names = result.names;
  options.groups = result.groups;
  options.scaled_jacobian = jacobians;
  write_mesh(arguments.output, result.mesh, options);
}

void write_job_report(const ImproveArguments& arguments, const ImproveResult& result, const std::string& hash,
                      const QualitySummary& quality) {
  if (arguments.report.empty()) return;
  JobReport report = report_improvement(arguments.improve, result, quality);
  report.version = QUARRY_VERSION;
  report.input_hash = hash;
  report.threads = arguments.common.resolved_threads();
  report.options.insert(report.options.end(), {{"output", arguments.output},
                                               {"report", arguments.report},
                                               {"picture", arguments.picture},
                                               {"page", arguments.page},
                                               {"compress", arguments.written.compress},
                                               {"order", arguments.written.order},
                                               {"for", arguments.written.consumer},
                                               {"split-fractures", arguments.written.split_fractures},
                                               {"require", arguments.require},
                                               {"config", arguments.config}});
  write_report(arguments.report, report);
}

void tell(const ImproveArguments& arguments, const ImproveResult& result, const QualitySummary& quality) {
  for (const std::string& note : result.notes) log::warn("{}", note);
  log::info("lines: {} tagged edges and the boundary, kept as {} straight pieces between {} fixed nodes",
            result.tagged_edges, result.pieces, result.nodes);
  if (result.sharp_edges > 0)
    log::info("{} edges at which the surface turns by {:g} degrees or more are kept too", result.sharp_edges,
              result.sharp_degrees);
  tell_quality(result.before, "before: ");
  tell_quality(quality, "after: ");
  tell_times(result.times, arguments.common.resolved_threads());
  log::info("wrote {}", arguments.output);
}

void run(ImproveArguments& arguments) {
  check(arguments);
  const std::vector<Demand> demands = parse_demands(arguments.require);
  ProgressBar bar(!arguments.common.quiet);
  const Progress progress = bar.progress();
  const std::string hash = hash_inputs(arguments.improve);
  ImproveResult result = improve_mesh(arguments.improve, progress);
  progress.throw_if_cancelled();
  const QualitySummary quality = summarize_quality(result.mesh);
  try {
    require_demands(demands, result.mesh, quality);
  } catch (const Error&) {
    // The report tells what the mesh would have been like.
    write_job_report(arguments, result, hash, quality);
    throw;
  }
  StageClock clock(progress);
  clock.start("writing");
  arguments.written.prepare(result.mesh);
  write_mesh_file(arguments, result, hash);
  if (!arguments.picture.empty()) write_picture(arguments.picture, result.mesh, PictureOptions());
  if (!arguments.page.empty()) write_mesh_page(arguments.page, result.mesh, quality, arguments.improve.input);
  clock.stop();
  result.times.insert(result.times.end(), clock.times().begin(), clock.times().end());
  write_job_report(arguments, result, hash, quality);
  bar.clear();
  tell(arguments, result, quality);
}

void add_options(CLI::App& command, ImproveArguments& arguments) {
  const auto option = [&](const char* name, auto& value, const char* type, const char* group,
                          const std::string& help) {
    return command.add_option(name, value, help)->type_name(type)->group(group);
  };
  command.add_option("inputs", arguments.improve.input, "the mesh to improve: " + readable_mesh_formats())
      ->type_name("MESH");
  const char* shape = "Elements";
  option("--cleanup", arguments.cleanup, "none|local|full|fewest", shape,
         "topological clean-up: none moves vertices alone; full is the default; fewest goes on for as few "
         "irregular vertices as it can")
      ->check(CLI::IsMember({"none", "local", "full", "fewest"}).description(""));
  option("--elements", arguments.elements, "same|mixed", shape,
         "same (default): quadrilaterals and triangles stay what they are; mixed: in the end two triangles "
         "take the place of each quadrilateral that is worse than --mixed-quality")
      ->check(CLI::IsMember({"same", "mixed"}).description(""));
  option("--mixed-quality", arguments.mixed_quality, "Q", shape, kMixedQualityHelp)
      ->check(CLI::Range(0.0, 1.0));
  add_irregular_price(command, arguments.improve.irregular_price);
  option("--size", arguments.improve.size, "H", shape,
         "wanted length of an element's edge, in the plane; default: sizes stay as they are");
  option(
      "--tolerance", arguments.improve.tolerance, "D", shape,
      "how far from a straight stretch of a line or of the boundary a vertex may lie and still slide along "
      "it; default: what rounding needs");
  option("--sharp", arguments.sharp, "auto|DEGREES", shape,
         "of a mesh in space: edges across which it turns by so many degrees are kept; auto (default): from "
         "what the mesh itself tells");
  const char* output = "Output";
  option("-o,--output", arguments.output, "OUT", output, "the mesh to write: " + writable_mesh_formats());
  option("--report", arguments.report, "FILE.json", output, "counts, times, quality before and after; JSON");
  option("--picture", arguments.picture, "FILE.svg|.png", output,
         "a drawing of the mesh with its lines on top");
  option("--page", arguments.page, "FILE.html", output,
         "a page with a view that turns, and the quality; needs no network");
  add_mesh_output_options(command, arguments.written, output);
  option("--require", arguments.require, "FIGURE=LIMIT", output,
         "exit code 6, and no mesh, unless it is met; the figures stand below")
      ->delimiter(',')
      ->take_all()
      ->allow_extra_args(false);
  add_common_options(command, arguments.common);
  option("--config", arguments.config, "FILE.toml", "Running",
         "the same keys without dashes (inputs for the mesh); the command line wins");
}

}  // namespace

void add_improve_command(CLI::App& program) {
  CLI::App* command =
      program.add_subcommand("improve", "clean-up and shape optimisation of a quad or mixed mesh");
  const auto arguments = std::make_shared<ImproveArguments>();
  add_options(*command, *arguments);
  command->footer("\nFigures of --require, several with commas:\n" + demand_help() +
                  "\nExample: quarry improve gmsh.msh -o better.msh --report better.json");
  command->callback([command, arguments] {
    if (!arguments->config.empty()) apply_config(*command, arguments->config);
    run_job(arguments->common, [&] { run(*arguments); });
  });
}

}  // namespace quarry::cli
