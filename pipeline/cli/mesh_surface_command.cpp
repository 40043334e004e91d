#include "pipeline/cli/mesh_surface_command.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "engine/base/log.hpp"
#include "io/mesh/mesh_format.hpp"
#include "kernels/quality/face.hpp"
#include "kernels/quality/summary.hpp"
#include "pipeline/cli/demands.hpp"
#include "pipeline/cli/not_built.hpp"
#include "pipeline/cli/outputs.hpp"
#include "pipeline/cli/progress_bar.hpp"
#include "pipeline/cli/summary_text.hpp"
#include "pipeline/report/input_hash.hpp"
#include "pipeline/section/section_report.hpp"
#include "pipeline/surface/surface_report.hpp"

namespace quarry::cli {
namespace {

SurfaceOptions options_of(const MeshArguments& arguments) {
  const SectionOptions& section = arguments.section;
  SurfaceOptions options;
  options.inputs = section.inputs;
  options.size = section.size;
  options.count = section.count;
  options.max_elements = section.max_elements;
  if (arguments.output.empty()) throw Error(ErrorKind::kUsage, "no output is given: name it with -o OUT.vtu");
  if (section.size.has_value() == section.count.has_value())
    throw Error(ErrorKind::kUsage, "give either --size or --count");
  for (const auto& [name, value] : {std::pair("--size", section.size), std::pair("--count", section.count)})
    if (value && !(*value > 0 && std::isfinite(*value)))
      throw Error(ErrorKind::kUsage, fmt::format("{} is {}: it must be above 0", name, *value));
  if (arguments.elements == "mixed") fail_not_built("--elements mixed on a surface", "use quad or tri");
  options.elements = arguments.elements == "tri" ? Elements::kTriangle : Elements::kQuad;
  options.cleanup = clean_up_level_of(arguments.cleanup.empty() ? "full" : arguments.cleanup);
  return options;
}

void write_mesh_file(const MeshArguments& arguments, const SurfaceOptions& surface,
                     const SurfaceResult& result, const std::string& hash) {
  const std::vector<double> jacobians = scaled_jacobians(result.mesh);
  MeshWriteOptions options;
  options.fields = {{"quarry_version", QUARRY_VERSION},
                    {"input_hash", hash},
                    {"options", option_text(resolved_options(surface, result))}};
  options.names = result.names;
  options.scaled_jacobian = jacobians;
  options.compress = arguments.compress;
  write_mesh(arguments.output, result.mesh, options);
}

void write_job_report(const MeshArguments& arguments, const SurfaceOptions& surface,
                      const SurfaceResult& result, const std::string& hash, const QualitySummary& quality) {
  if (arguments.report.empty()) return;
  JobReport report = report_surface(surface, result, quality);
  report.command = "mesh";
  report.version = QUARRY_VERSION;
  report.input_hash = hash;
  report.threads = arguments.common.resolved_threads();
  write_report(arguments.report, report);
}

}  // namespace

bool is_surface(const std::vector<std::string>& inputs) {
  return !inputs.empty() && is_mesh_file(inputs.front());
}

void run_mesh_surface(MeshArguments& arguments) {
  const SurfaceOptions options = options_of(arguments);
  check_writable_extension(arguments.output);
  check_outputs({arguments.output, arguments.report, arguments.picture}, options.inputs);
  const std::vector<Demand> demands = parse_demands(arguments.require);
  ProgressBar bar(!arguments.common.quiet);
  const Progress progress = bar.progress();
  const std::string hash = hash_files(options.inputs);
  SurfaceResult result = mesh_surface(options, progress);
  StageClock clock(progress);
  clock.start("measuring");
  const QualitySummary quality = summarize_quality(result.mesh);
  clock.start("writing");
  try {
    require_demands(demands, result.mesh, quality);
  } catch (const Error&) {
    // The report tells what the mesh would have been like.
    write_job_report(arguments, options, result, hash, quality);
    throw;
  }
  write_mesh_file(arguments, options, result, hash);
  clock.stop();
  result.times.insert(result.times.end(), clock.times().begin(), clock.times().end());
  write_job_report(arguments, options, result, hash, quality);
  bar.clear();
  for (const std::string& note : report_surface(options, result, quality).notes) log::info("{}", note);
  log::info("features: {} curves between {} nodes", result.features.curves, result.features.nodes);
  tell_quality(quality);
  tell_times(result.times, arguments.common.resolved_threads());
  log::info("wrote {}", arguments.output);
}

}  // namespace quarry::cli
