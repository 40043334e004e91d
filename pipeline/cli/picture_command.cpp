#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/error.hpp"
#include "engine/base/log.hpp"
#include "io/mesh/mesh_format.hpp"
#include "io/picture/picture.hpp"
#include "kernels/quality/face.hpp"
#include "pipeline/cli/commands.hpp"
#include "pipeline/cli/common_arguments.hpp"
#include "pipeline/cli/outputs.hpp"

namespace quarry::cli {
namespace {

struct PictureArguments {
  CommonArguments common;
  std::string input, output;
  std::string by = "region";
  int width = PictureOptions().width;
  std::vector<double> window;
};

std::optional<Box2> window_of(const std::vector<double>& window) {
  if (window.empty()) return std::nullopt;
  Box2 box;
  box.extend({window[0], window[1]});
  box.extend({window[2], window[3]});
  return box;
}

void run(const PictureArguments& arguments) {
  if (arguments.output.empty())
    throw Error(ErrorKind::kUsage, "no output is given: name it with -o OUT.svg or OUT.png");
  check_readable_extension(arguments.input);
  check_picture_extension(arguments.output);
  check_outputs({arguments.output}, {arguments.input});
  const Mesh mesh = read_mesh(arguments.input);
  PictureOptions options;
  std::vector<double> quality;
  if (arguments.by == "constraint") options.colours = PictureColours::kConstraint;
  if (arguments.by == "quality") {
    options.colours = PictureColours::kQuality;
    quality = scaled_jacobians(mesh);
    options.quality = quality;
  }
  options.width = arguments.width;
  options.window = window_of(arguments.window);
  write_picture(arguments.output, mesh, options);
  log::info("wrote {}", arguments.output);
}

}  // namespace

void add_picture_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand("picture", "draw a mesh, its lines on top");
  const auto arguments = std::make_shared<PictureArguments>();
  command->add_option("mesh", arguments->input, "the mesh to draw: " + readable_mesh_formats())
      ->required()
      ->type_name("MESH");
  command->add_option("-o,--output", arguments->output, "the drawing: .svg or .png")->type_name("OUT");
  command
      ->add_option("--by", arguments->by,
                   "what colours the faces: their region (default), their scaled Jacobian, or only the lines "
                   "are coloured")
      ->check(CLI::IsMember({"region", "quality", "constraint"}).description(""))
      ->type_name("region|quality|constraint");
  command->add_option("--width", arguments->width, "pixels of a .png; default 1600")->type_name("N");
  command->add_option("--window", arguments->window, "draws this part only, in the units of the coordinates")
      ->expected(4)
      ->type_name("X Y X Y");
  add_common_options(*command, arguments->common);
  command->footer("\nExample: quarry picture traces.vtu -o traces.png --by quality");
  command->callback([arguments] { run_job(arguments->common, [&] { run(*arguments); }); });
}

}  // namespace quarry::cli
