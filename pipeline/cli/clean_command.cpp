#include <limits>
#include <memory>

#include "engine/base/error.hpp"
#include "engine/base/log.hpp"
#include "io/lines/coordinate_system.hpp"
#include "io/lines/geojson_writer.hpp"
#include "pipeline/cli/commands.hpp"
#include "pipeline/cli/config_file.hpp"
#include "pipeline/cli/mesh_arguments.hpp"
#include "pipeline/cli/node_file.hpp"
#include "pipeline/cli/outputs.hpp"
#include "pipeline/cli/progress_bar.hpp"
#include "pipeline/cli/summary_text.hpp"
#include "pipeline/section/section_report.hpp"

namespace quarry::cli {
namespace {

struct CleanArguments {
  SectionOptions section;
  CommonArguments common;
  std::string output, nodes, report, config;
};

void check(CleanArguments& arguments) {
  SectionOptions& section = arguments.section;
  if (section.inputs.empty())
    throw Error(ErrorKind::kUsage, "no input file is given; see quarry clean --help");
  if (arguments.output.empty())
    throw Error(ErrorKind::kUsage, "no output is given: name it with -o OUT.geojson");
  if (!arguments.output.ends_with(".geojson") && !arguments.output.ends_with(".json"))
    throw Error(ErrorKind::kUsage, arguments.output + ": cleaned lines are written as .geojson or .json");
  if (!arguments.nodes.empty() && !arguments.nodes.ends_with(".geojson") &&
      !arguments.nodes.ends_with(".json"))
    throw Error(ErrorKind::kUsage, arguments.nodes + ": nodes are written as .geojson or .json");
  if (!section.size) {
    // The other lengths follow from the snapping distance as they would from the size that has it as its
    // default.
    if (!section.snap || !(*section.snap > 0))
      throw Error(ErrorKind::kUsage, "give --size H, or --snap T above 0");
    section.size = 20 * *section.snap;
  }
  section.max_elements = std::numeric_limits<double>::infinity();
  std::vector<std::string> inputs = section.inputs;
  inputs.push_back(section.boundary);
  check_outputs({arguments.output, arguments.nodes, arguments.report}, inputs);
}

void write_job_report(const CleanArguments& arguments, const SectionResult& result, const std::string& hash) {
  if (arguments.report.empty()) return;
  JobReport report = report_section(arguments.section, result, {});
  report.command = "clean";
  report.version = QUARRY_VERSION;
  report.input_hash = hash;
  report.threads = arguments.common.resolved_threads();
  write_report(arguments.report, report);
}

void run(CleanArguments& arguments) {
  check(arguments);
  ProgressBar bar(!arguments.common.quiet);
  const Progress progress = bar.progress();
  const std::string hash = hash_inputs(arguments.section);
  const SectionResult result = clean_section(arguments.section, progress);
  progress.throw_if_cancelled();
  GeojsonWriteOptions options{&result.lines, system_urn(result.system), {}};
  for (const PointEntry& point : result.cleaned.points) options.points.push_back(point.node);
  write_lines_geojson(arguments.output, result.cleaned.lines, options);
  if (!arguments.nodes.empty())
    write_node_file(arguments.nodes, result.cleaned.lines, system_urn(result.system));
  write_job_report(arguments, result, hash);
  bar.clear();
  tell_lines(result);
  tell_nodes(result);
  tell_effort(result, arguments.common.resolved_threads());
  log::info("wrote {}", arguments.output);
}

}  // namespace

void add_clean_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand("clean", "snap, node and repair lines only");
  const auto arguments = std::make_shared<CleanArguments>();
  add_line_options(*command, arguments->section);
  command->add_option("-o,--output", arguments->output, "the cleaned lines")
      ->type_name("OUT.geojson")
      ->group("Output");
  command
      ->add_option("--nodes", arguments->nodes,
                   "points where lines end, abut and cross, with their class: I, Y, X; E on the outline")
      ->type_name("FILE.geojson")
      ->group("Output");
  command->add_option("--report", arguments->report, "what became of each line; JSON")
      ->type_name("FILE.json")
      ->group("Output");
  add_common_options(*command, arguments->common);
  command->add_option("--config", arguments->config, "the same keys without dashes; the command line wins")
      ->type_name("FILE.toml")
      ->group("Running");
  command->footer(
      "\nWithout --size, H is 20 times --snap. Example: quarry clean raw.geojson -o clean.geojson --snap "
      "0.5");
  command->callback([command, arguments] {
    if (!arguments->config.empty()) apply_config(*command, arguments->config);
    run_job(arguments->common, [&] { run(*arguments); });
  });
}

}  // namespace quarry::cli
