#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "engine/base/log.hpp"
#include "io/mesh/mesh_format.hpp"
#include "io/page/page.hpp"
#include "io/picture/picture.hpp"
#include "kernels/quality/face.hpp"
#include "kernels/quality/summary.hpp"
#include "pipeline/cli/commands.hpp"
#include "pipeline/cli/config_file.hpp"
#include "pipeline/cli/mesh_arguments.hpp"
#include "pipeline/cli/mesh_surface_command.hpp"
#include "pipeline/cli/outputs.hpp"
#include "pipeline/cli/page_output.hpp"
#include "pipeline/cli/progress_bar.hpp"
#include "pipeline/cli/summary_text.hpp"
#include "pipeline/section/point_tags.hpp"
#include "pipeline/section/price_source.hpp"
#include "pipeline/section/section_report.hpp"

namespace quarry::cli {
namespace {

// Jobs from here on take long enough that one may want to stop them at what they are predicted to need; what
// a smaller one was predicted to need is told with its summary, so that a failure is one line.
constexpr double kLongJob = 1e6;

// A count with three digits that mean something: "15900", "1.59 million".
std::string rounded(double count) {
  if (count >= 1e6) return fmt::format("{:.3g} million", count / 1e6);
  const double unit = std::pow(10.0, std::max(0.0, std::floor(std::log10(std::max(count, 1.0))) - 2));
  return fmt::format("{:.0f}", unit * std::round(count / unit));
}

void check(MeshArguments& arguments) {
  fill_section(arguments);
  arguments.written.check(arguments.output);
  if (!arguments.picture.empty()) check_picture_extension(arguments.picture);
  if (!arguments.page.empty()) check_page_extension(arguments.page);
  if (!arguments.section.start_file.empty()) check_readable_extension(arguments.section.start_file);
  std::vector<std::string> inputs = arguments.section.inputs;
  inputs.insert(inputs.end(), {arguments.section.boundary, arguments.section.start_file,
                               price_file(arguments.section.irregular_price)});
  check_outputs({arguments.output, arguments.report, arguments.picture, arguments.page}, inputs);
}

void write_mesh_file(const MeshArguments& arguments, const SectionResult& result, const std::string& hash) {
  const std::vector<double> jacobians = scaled_jacobians(result.mesh);
  MeshWriteOptions options = arguments.written.write_options();
  options.fields = {
      {"quarry_version", QUARRY_VERSION},
      {"input_hash", hash},
      {"options", option_text(resolved_options(arguments.section, result)) + arguments.written.text()}};
  options.groups = result.groups;
  options.names.points = point_names(result.lines);
  options.scaled_jacobian = jacobians;
  write_mesh(arguments.output, result.mesh, options);
}

// What was asked for beside what changes the mesh, so that the report tells how to run the job again.
void add_running_options(const MeshArguments& arguments, JobReport& report) {
  report.options.insert(report.options.end(), {{"max-elements", arguments.section.max_elements},
                                               {"output", arguments.output},
                                               {"report", arguments.report},
                                               {"picture", arguments.picture},
                                               {"page", arguments.page},
                                               {"compress", arguments.written.compress},
                                               {"order", arguments.written.order},
                                               {"for", arguments.written.consumer},
                                               {"split-fractures", arguments.written.split_fractures},
                                               {"require", arguments.require},
                                               {"config", arguments.config}});
}

void write_job_report(const MeshArguments& arguments, const SectionResult& result, const std::string& hash,
                      const QualitySummary& quality) {
  if (arguments.report.empty()) return;
  JobReport report = report_section(arguments.section, result, quality);
  report.command = "mesh";
  report.version = QUARRY_VERSION;
  report.input_hash = hash;
  report.threads = arguments.common.resolved_threads();
  add_running_options(arguments, report);
  write_report(arguments.report, report);
}

// Measuring takes a few per cent of a job.
bool someone_asks_for_quality(const MeshArguments& arguments) {
  return !arguments.common.quiet || !arguments.report.empty() || !arguments.page.empty() ||
         !arguments.require.empty();
}

void run(MeshArguments& arguments) {
  if (is_surface(arguments.section.inputs)) return run_mesh_surface(arguments);
  check(arguments);
  const std::vector<Demand> demands = parse_demands(arguments.require);
  ProgressBar bar(!arguments.common.quiet);
  const Progress progress = bar.progress();
  std::string prediction;
  arguments.section.on_prediction = [&](double elements, double bytes) {
    prediction = fmt::format("about {} elements and at most {:.0f} MB of memory are to be expected",
                             rounded(elements), bytes / 1e6);
    if (elements < kLongJob) return;
    bar.clear();
    log::info("{}", std::exchange(prediction, ""));
  };
  const std::string hash = hash_inputs(arguments.section);
  SectionResult result = mesh_section(arguments.section, progress);
  StageClock clock(progress);
  clock.start("measuring");
  QualitySummary quality;
  if (someone_asks_for_quality(arguments)) quality = summarize_quality(result.mesh);
  clock.start("writing");
  try {
    require_demands(demands, result.mesh, quality);
  } catch (const Error&) {
    // The report tells what the mesh would have been like.
    write_job_report(arguments, result, hash, quality);
    throw;
  }
  arguments.written.prepare(result.mesh);
  write_mesh_file(arguments, result, hash);
  if (!arguments.picture.empty()) write_picture(arguments.picture, result.mesh, PictureOptions());
  if (!arguments.page.empty())
    write_mesh_page(arguments.page, result.mesh, quality, arguments.section.inputs.front());
  clock.stop();
  result.times.insert(result.times.end(), clock.times().begin(), clock.times().end());
  write_job_report(arguments, result, hash, quality);
  bar.clear();
  if (!prediction.empty()) log::info("{}", prediction);
  tell_lines(result);
  tell_quality(quality);
  tell_effort(result, arguments.common.resolved_threads());
  log::info("wrote {}", arguments.output);
}

}  // namespace

void add_mesh_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand("mesh", "lines (section, trace map) -> mesh");
  const auto arguments = std::make_shared<MeshArguments>();
  add_mesh_options(*command, *arguments);
  command->footer("\nFigures of --require, several with commas:\n" + demand_help() +
                  "\nExample: quarry mesh traces.geojson -o traces.vtu --size 5 --boundary area.geojson "
                  "--require irregular=5");
  command->callback([command, arguments] {
    if (!arguments->config.empty()) apply_config(*command, arguments->config);
    run_job(arguments->common, [&] { run(*arguments); });
  });
}

}  // namespace quarry::cli
