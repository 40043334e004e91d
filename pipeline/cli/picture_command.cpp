#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/error.hpp"
#include "engine/base/log.hpp"
#include "engine/base/progress.hpp"
#include "io/mesh/mesh_format.hpp"
#include "io/page/page.hpp"
#include "io/picture/picture.hpp"
#include "kernels/quality/face.hpp"
#include "kernels/quality/summary.hpp"
#include "pipeline/cli/commands.hpp"
#include "pipeline/cli/common_arguments.hpp"
#include "pipeline/cli/interrupt.hpp"
#include "pipeline/cli/outputs.hpp"
#include "pipeline/cli/page_output.hpp"

namespace quarry::cli {
namespace {

struct PictureArguments {
  CommonArguments common;
  std::string input, output;
  std::string by = "region";
  int width = PictureOptions().width;
  std::vector<double> window, view, around;
  std::string up = "z";
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
    throw Error(ErrorKind::kUsage, "no output is given: name it with -o OUT.svg, OUT.png or OUT.html");
  check_readable_extension(arguments.input);
  if (!is_page(arguments.output)) check_picture_extension(arguments.output);
  check_outputs({arguments.output}, {arguments.input});
  const Progress progress({}, &interrupt_token());
  const Mesh mesh = read_mesh(arguments.input);
  progress.throw_if_cancelled();
  if (is_page(arguments.output)) {
    const QualitySummary quality = summarize_quality(mesh);
    progress.throw_if_cancelled();
    write_mesh_page(arguments.output, mesh, quality, arguments.input);
    log::info("wrote {}", arguments.output);
    return;
  }
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
  if (!arguments.view.empty()) {
    options.view.azimuth = arguments.view[0];
    options.view.elevation = arguments.view[1];
  }
  if (arguments.up == "y") options.view.up = UpAxis::kY;
  if (const auto& a = arguments.around; !a.empty()) options.around = Ball{{a[0], a[1], a[2]}, a[3]};
  progress.throw_if_cancelled();
  write_picture(arguments.output, mesh, options, progress);
  log::info("wrote {}", arguments.output);
}

}  // namespace

void add_picture_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand("picture", "draw a mesh, its lines on top");
  const auto arguments = std::make_shared<PictureArguments>();
  command->add_option("mesh", arguments->input, "the mesh to draw: " + readable_mesh_formats())
      ->required()
      ->type_name("MESH");
  command
      ->add_option("-o,--output", arguments->output,
                   "the drawing: .svg or .png; or .html, a page with a view that turns")
      ->type_name("OUT");
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
  command
      ->add_option(
          "--view", arguments->view,
          "from where a mesh in space is seen, in degrees: around the axis that points up, and above "
          "the level; default 35 25")
      ->expected(2)
      ->type_name("AZIMUTH ELEVATION");
  command->add_option("--up", arguments->up, "the axis that points up in space; default z")
      ->check(CLI::IsMember({"y", "z"}).description(""))
      ->type_name("y|z");
  command->add_option("--around", arguments->around, "draws only what lies within R of a place in space")
      ->expected(4)
      ->type_name("X Y Z R");
  add_common_options(*command, arguments->common);
  command->footer("\nExample: quarry picture traces.vtu -o traces.png --by quality");
  command->callback([arguments] { run_job(arguments->common, [&] { run(*arguments); }); });
}

}  // namespace quarry::cli
