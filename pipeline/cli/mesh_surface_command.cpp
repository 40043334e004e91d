#include "pipeline/cli/mesh_surface_command.hpp"

#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "engine/base/log.hpp"
#include "engine/mesh/pinch.hpp"
#include "io/lines/companion_file.hpp"
#include "io/mesh/mesh_format.hpp"
#include "io/page/page.hpp"
#include "io/picture/picture.hpp"
#include "kernels/quality/face.hpp"
#include "kernels/quality/summary.hpp"
#include "pipeline/cli/demands.hpp"
#include "pipeline/cli/not_built.hpp"
#include "pipeline/cli/outputs.hpp"
#include "pipeline/cli/page_output.hpp"
#include "pipeline/cli/progress_bar.hpp"
#include "pipeline/cli/sharpness.hpp"
#include "pipeline/cli/summary_text.hpp"
#include "pipeline/report/input_hash.hpp"
#include "pipeline/section/section_report.hpp"
#include "pipeline/surface/surface_report.hpp"
#include "surface/repair/sheets.hpp"

namespace quarry::cli {
namespace {

// Options that mean something for lines alone are told, not passed over.
void refuse_options_of_lines(const MeshArguments& arguments) {
  const SectionOptions& section = arguments.section;
  const auto refuse = [](bool given, const char* name) {
    if (given) throw Error(ErrorKind::kUsage, fmt::format("{} is for lines; the input is a surface", name));
  };
  refuse(section.snap.has_value() && arguments.lines.empty(), "--snap without --lines");
  refuse(section.min_edge.has_value(), "--min-edge");
  refuse(section.tolerance.has_value(), "--tolerance");
  refuse(!section.boundary.empty(), "--boundary");
  refuse(!arguments.start.empty(), "--start");
  refuse(!arguments.orient.empty(), "--orient");
  refuse(arguments.preset != "default", "--preset");
  refuse(section.fronts.has_value(), "--fronts");
  refuse(section.project, "--project");
  refuse(section.as_is, "--as-is");
  refuse(!section.section.empty(), "--section");
  refuse(!section.seed_points.empty(), "--seed-point");
  const auto not_built = [](bool given, const char* name) {
    if (given) fail_not_built(fmt::format("{} on a surface", name), "leave it out");
  };
  not_built(arguments.elements == "mixed" || arguments.mixed_quality.has_value(), "--elements mixed");
  not_built(arguments.method != "deferred", "--method");
  not_built(!section.sizes.uniform(), "a size by place (--size-field, --refine-near, --between-lines)");
  not_built(arguments.written.split_fractures, "--split-fractures");
  not_built(!section.irregular_price.empty(), "--irregular-price");
}

void check_options_of_matching(const MeshArguments& arguments) {
  const bool matches = arguments.quads == "matching" && arguments.elements == "quad";
  if (arguments.section.anneal > 0 && !matches)
    throw Error(ErrorKind::kUsage, "--anneal needs quadrilaterals by --quads matching");
  if (arguments.keep_boundary && arguments.elements != "tri" && !matches)
    throw Error(ErrorKind::kUsage,
                "--keep-boundary needs --quads matching: fields and clusters halve every edge");
}

SurfaceOptions options_of(const MeshArguments& arguments) {
  refuse_options_of_lines(arguments);
  check_options_of_matching(arguments);
  const SectionOptions& section = arguments.section;
  SurfaceOptions options;
  options.inputs = section.inputs;
  options.lines = arguments.lines;
  options.curvature = arguments.curvature;
  if (options.curvature && !(*options.curvature > 0 && std::isfinite(*options.curvature)))
    throw Error(ErrorKind::kUsage, fmt::format("--curvature is {}: it must be above 0", *options.curvature));
  options.snap = section.snap;
  if (section.snap && !(*section.snap >= 0 && std::isfinite(*section.snap)))
    throw Error(ErrorKind::kUsage, fmt::format("--snap is {}: it must be 0 or more", *section.snap));
  options.size = section.size;
  options.count = section.count;
  options.max_elements = section.max_elements;
  if (arguments.output.empty()) throw Error(ErrorKind::kUsage, "no output is given: name it with -o OUT.vtu");
  if (section.size.has_value() == section.count.has_value())
    throw Error(ErrorKind::kUsage, "give either --size or --count");
  for (const auto& [name, value] : {std::pair("--size", section.size), std::pair("--count", section.count)})
    if (value && !(*value > 0 && std::isfinite(*value)))
      throw Error(ErrorKind::kUsage, fmt::format("{} is {}: it must be above 0", name, *value));
  options.elements = arguments.elements == "tri" ? Elements::kTriangle : Elements::kQuad;
  if (arguments.quads == "cluster") options.method = SurfaceQuads::kCluster;
  if (arguments.quads == "matching") options.method = SurfaceQuads::kMatching;
  options.keep_boundary = arguments.keep_boundary;
  options.anneal = section.anneal;
  options.seed = section.seed;
  options.cleanup = clean_up_level_of(arguments.cleanup.empty() ? "full" : arguments.cleanup);
  options.features.sharp_degrees = sharpness_of(arguments.sharp);
  options.repair.weld = arguments.weld;
  options.repair.fill_holes = arguments.fill_holes;
  return options;
}

// Points at which sheets meet are one point in the file.
void write_repaired(const std::string& path, const SurfaceResult& result) {
  RepairedSurface repaired;
  repaired.surface = result.repaired;
  Mesh mesh = make_sheets(repaired);
  static_cast<void>(mesh.add_tag<VertexId, std::uint8_t>(kPinchTag, 1));
  auto region = mesh.add_tag<FaceId, std::int32_t>("region");
  for (const FaceId f : mesh.faces()) region[f] = result.repaired.groups[f.value()];
  MeshWriteOptions options;
  options.names = result.names;
  write_mesh(path, mesh, options);
}

void write_mesh_file(const MeshArguments& arguments, const SurfaceOptions& surface,
                     const SurfaceResult& result, const std::string& hash) {
  const std::vector<double> jacobians = scaled_jacobians(result.mesh);
  MeshWriteOptions options = arguments.written.write_options();
  options.fields = {{"quarry_version", QUARRY_VERSION},
                    {"input_hash", hash},
                    {"options", option_text(resolved_options(surface, result)) + arguments.written.text()}};
  options.names = result.names;
  options.scaled_jacobian = jacobians;
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

// What the repair did may be the reason, and its surface is where to look.
void tell_of_failure(const MeshArguments& arguments, const SurfaceOptions& surface, SurfaceResult& result,
                     const std::string& hash, const Error& error) {
  if (result.repaired.triangles.empty()) return;
  if (!arguments.repaired.empty()) write_repaired(arguments.repaired, result);
  result.mesh = Mesh();
  const QualitySummary none = summarize_quality(result.mesh);
  for (const std::string& note : report_surface(surface, result, none).notes) log::info("{}", note);
  result.notes.push_back("no mesh was made: " + error.message());
  write_job_report(arguments, surface, result, hash, none);
}

}  // namespace

bool is_surface(const std::vector<std::string>& inputs) {
  return !inputs.empty() && is_mesh_file(inputs.front());
}

std::vector<std::string> surface_input_files(const MeshArguments& arguments) {
  std::vector<std::string> files = arguments.section.inputs;
  for (const std::string& lines : arguments.lines)
    for (std::string& file : files_read_with(lines)) files.push_back(std::move(file));
  return files;
}

void run_mesh_surface(MeshArguments& arguments) {
  const SurfaceOptions options = options_of(arguments);
  const std::vector<std::string> files = surface_input_files(arguments);
  arguments.written.check(arguments.output);
  if (!arguments.repaired.empty()) check_writable_extension(arguments.repaired);
  if (!arguments.picture.empty()) check_picture_extension(arguments.picture);
  if (!arguments.page.empty()) check_page_extension(arguments.page);
  check_outputs({arguments.output, arguments.report, arguments.repaired, arguments.picture, arguments.page},
                files);
  const std::vector<Demand> demands = parse_demands(arguments.require);
  ProgressBar bar(!arguments.common.quiet);
  const Progress progress = bar.progress();
  const std::string hash = hash_files(files);
  SurfaceResult result;
  try {
    mesh_surface(options, result, progress);
  } catch (const Error& error) {
    bar.clear();
    if (error.kind() == ErrorKind::kGeometry) tell_of_failure(arguments, options, result, hash, error);
    throw;
  }
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
  if (!arguments.repaired.empty()) write_repaired(arguments.repaired, result);
  if (!arguments.picture.empty()) write_picture(arguments.picture, result.mesh, PictureOptions());
  if (!arguments.page.empty()) write_mesh_page(arguments.page, result.mesh, quality, options.inputs.front());
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
