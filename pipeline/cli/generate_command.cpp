#include <memory>
#include <string>
#include <vector>

#include "engine/base/error.hpp"
#include "engine/base/log.hpp"
#include "io/number_text.hpp"
#include "pipeline/cli/commands.hpp"
#include "pipeline/cli/common_arguments.hpp"
#include "pipeline/cli/config_file.hpp"
#include "pipeline/cli/outputs.hpp"
#include "pipeline/cli/progress_bar.hpp"
#include "pipeline/cli/whole_number.hpp"
#include "pipeline/generate/fractures.hpp"
#include "pipeline/generate/layers.hpp"

namespace quarry::cli {
namespace {

// What both sorts of models take.
struct ModelArguments {
  CommonArguments common;
  std::string output, config;
  std::vector<double> sides, origin = {0, 0};

  [[nodiscard]] Box2 box(const Box2& otherwise) const {
    const Vec2 low{origin[0], origin[1]};
    return {low, low + (sides.empty() ? otherwise.high : Vec2{sides[0], sides[1]})};
  }
};

struct FractureArguments {
  ModelArguments model;
  FractureOptions options;
  std::vector<std::string> sets;
};

struct LayerArguments {
  ModelArguments model;
  LayerOptions options;
};

// "ANGLE", "ANGLE:KAPPA" or "ANGLE:KAPPA:WEIGHT"
FractureSet parse_set(const std::string& text) {
  FractureSet set;
  double* const fields[] = {&set.degrees, &set.kappa, &set.weight};
  const char* at = text.data();
  const char* const end = at + text.size();
  for (double* const field : fields) {
    const auto [stop, failure] = read_number(at, end, *field);
    if (failure != std::errc() || (stop != end && *stop != ':')) break;
    if (stop == end) return set;
    at = stop + 1;
  }
  throw Error(ErrorKind::kUsage, "--set " + text + ": give ANGLE, ANGLE:KAPPA or ANGLE:KAPPA:WEIGHT");
}

void check_output(const ModelArguments& arguments) {
  if (arguments.output.empty())
    throw Error(ErrorKind::kUsage, "no output is given: name it with -o OUT.geojson");
  if (!arguments.output.ends_with(".geojson") && !arguments.output.ends_with(".json"))
    throw Error(ErrorKind::kUsage, arguments.output + ": models are written as .geojson or .json");
  check_outputs({arguments.output}, {});
}

// Writes and tells.
void finish(const ModelArguments& arguments, const GeneratedModel& model, const Box2& box,
            const Progress& progress, ProgressBar& bar) {
  progress.throw_if_cancelled();
  write_model(arguments.output, model);
  bar.clear();
  log::info("{} lines of {} segments, {:.6g} long in all: {:.4g} by area", model.lines.lines.size(),
            model.segments, model.total_length, model.total_length / (box.width() * box.height()));
  log::info("wrote {}", arguments.output);
}

void run(FractureArguments& arguments) {
  check_output(arguments.model);
  FractureOptions& options = arguments.options;
  options.box = arguments.model.box(options.box);
  if (!arguments.sets.empty()) options.sets.clear();
  for (const std::string& text : arguments.sets) options.sets.push_back(parse_set(text));
  ProgressBar bar(!arguments.model.common.quiet);
  const Progress progress = bar.progress();
  finish(arguments.model, generate_fractures(options, progress), options.box, progress, bar);
}

void run(LayerArguments& arguments) {
  check_output(arguments.model);
  LayerOptions& options = arguments.options;
  options.box = arguments.model.box(options.box);
  ProgressBar bar(!arguments.model.common.quiet);
  const Progress progress = bar.progress();
  finish(arguments.model, generate_layers(options, progress), options.box, progress, bar);
}

// sides: of the box by default, as text.
void add_model_options(CLI::App& command, ModelArguments& arguments, const std::string& sides, bool& outline,
                       std::uint64_t& seed) {
  const char* group = "The box";
  command.add_option("--box", arguments.sides, "its sides; default " + sides)
      ->delimiter(',')
      ->expected(2)
      ->type_name("W,H")
      ->group(group);
  command.add_option("--origin", arguments.origin, "its lower left corner; default 0,0")
      ->delimiter(',')
      ->expected(2)
      ->type_name("X,Y")
      ->group(group);
  command.add_flag("--outline", outline, "the box is a polygon of the file too")->group(group);
  command.add_option("-o,--output", arguments.output, "the model")->type_name("OUT.geojson")->group("Output");
  command.add_option("--seed", seed, "another number, another model; default 0")
      ->check(whole_number())
      ->type_name("S")
      ->group("Running");
  add_common_options(command, arguments.common);
  command.add_option("--config", arguments.config, "the same keys without dashes; the command line wins")
      ->type_name("FILE.toml")
      ->group("Running");
}

void add_fractures(CLI::App& program) {
  CLI::App* command = program.add_subcommand("fractures", "lines of power-law lengths in sets of directions");
  const auto arguments = std::make_shared<FractureArguments>();
  FractureOptions& options = arguments->options;
  const auto option = [&](const char* name, auto& value, const char* type, const char* help) {
    return command->add_option(name, value, help)->type_name(type)->group("Fractures");
  };
  option("--count", options.count, "N", "how many fractures have a part in the box")->check(whole_number());
  option("--p21", options.intensity, "P21", "in place of --count: length of fractures by area");
  option("--exponent", options.exponent, "A", "lengths follow p(l) ~ l^-A; default 2.5");
  option("--lmin", options.shortest, "L", "the shortest; default 0.7 sqrt(area / count), or 1.5 / P21");
  option("--lmax", options.longest, "L", "the longest; default half of the box's shorter side");
  option(
      "--set", arguments->sets, "ANGLE:KAPPA:WEIGHT",
      "a set of directions, may be given several times: degrees counter-clockwise from the x axis, "
      "concentration of von Mises' law (default 30, a scatter of about 10 degrees; 0: any direction), share "
      "(default 1). Without: 30:30:0.6 and 120:30:0.4")
      ->allow_extra_args(false);
  command->add_flag("--curved", options.curved, "undulating arcs in place of straight segments")
      ->group("Fractures");
  add_model_options(*command, arguments->model, "1000,1000", options.outline, options.seed);
  command->footer(
      "\nExample: quarry generate fractures --p21 0.1 --set 20:40 --set 95:40:0.5 --curved -o "
      "traces.geojson");
  command->callback([command, arguments] {
    if (!arguments->model.config.empty()) apply_config(*command, arguments->model.config);
    run_job(arguments->model.common, [&] { run(*arguments); });
  });
}

void add_layers(CLI::App& program) {
  CLI::App* command = program.add_subcommand("layers", "folded horizons, and faults that offset them");
  const auto arguments = std::make_shared<LayerArguments>();
  LayerOptions& options = arguments->options;
  const auto option = [&](const char* name, auto& value, const char* type, const char* help) {
    return command->add_option(name, value, help)->type_name(type)->group("Layers");
  };
  option("--horizons", options.horizons, "N", "how many; default 8")->check(whole_number());
  option("--folds", options.folds, "N", "sines whose sum is their shape; default 3; 0: level")
      ->check(whole_number());
  option("--amplitude", options.amplitude, "A",
         "the largest height of the folds; default a tenth of the box's height");
  option("--step", options.step, "D",
         "between points of a horizon, along x; default a 200th of the box's width");
  option("--faults", options.faults, "N", "how many; default 3")->check(whole_number());
  option("--dip", options.dip, "DEGREES",
         "of the faults, from the horizontal, to the left or right by lot; default 60");
  option("--throw", options.mean_throw, "T",
         "mean vertical offset at a fault; below 0: reverse faults; default a 20th of the box's height");
  add_model_options(*command, arguments->model, "1000,500", options.outline, options.seed);
  command->footer("\nExample: quarry generate layers --horizons 12 --faults 5 --outline -o section.geojson");
  command->callback([command, arguments] {
    if (!arguments->model.config.empty()) apply_config(*command, arguments->model.config);
    run_job(arguments->model.common, [&] { run(*arguments); });
  });
}

}  // namespace

void add_generate_command(CLI::App& program) {
  CLI::App* command =
      program.add_subcommand("generate", "seeded synthetic models, for trials and scaling tests");
  command->require_subcommand(1);
  command->footer("\nThe same options give the same bytes, on any machine and number of threads.");
  add_fractures(*command);
  add_layers(*command);
}

}  // namespace quarry::cli
