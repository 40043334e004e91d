#include <memory>
#include <string>
#include <utility>

#include "engine/base/log.hpp"
#include "engine/base/progress.hpp"
#include "io/mesh/mesh_format.hpp"
#include "kernels/quality/face.hpp"
#include "pipeline/cli/commands.hpp"
#include "pipeline/cli/common_arguments.hpp"
#include "pipeline/cli/interrupt.hpp"
#include "pipeline/cli/mesh_output.hpp"
#include "pipeline/cli/outputs.hpp"

namespace quarry::cli {
namespace {

struct ConvertArguments {
  CommonArguments common;
  std::string input, output;
  MeshOutput written;
};

void run(const ConvertArguments& arguments) {
  check_readable_extension(arguments.input);
  arguments.written.check(arguments.output);
  check_outputs({arguments.output}, {arguments.input});
  const Progress progress({}, &interrupt_token());
  ReadCells cells = read_cells(arguments.input);
  progress.throw_if_cancelled();
  const GroupNames names = cells.names;
  const std::vector<Grouping> groups = groupings_of(cells);
  Mesh mesh = make_mesh(arguments.input, std::move(cells));
  progress.throw_if_cancelled();
  arguments.written.prepare(mesh);
  const std::vector<double> jacobians = scaled_jacobians(mesh);
  MeshWriteOptions options = arguments.written.write_options();
  options.fields = {{"quarry_version", QUARRY_VERSION}};
  options.names = names;
  options.groups = groups;
  options.scaled_jacobian = jacobians;
  progress.throw_if_cancelled();
  write_mesh(arguments.output, mesh, options);
  log::info("wrote {}", arguments.output);
}

}  // namespace

void add_convert_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand("convert", "a mesh file in another format");
  const auto arguments = std::make_shared<ConvertArguments>();
  command->add_option("input", arguments->input, "the mesh to read: " + readable_mesh_formats())
      ->required()
      ->type_name("IN");
  command->add_option("output", arguments->output, "the mesh to write: " + writable_mesh_formats())
      ->required()
      ->type_name("OUT");
  add_mesh_output_options(*command, arguments->written, "Output");
  add_common_options(*command, arguments->common);
  command->callback([arguments] { run_job(arguments->common, [&] { run(*arguments); }); });
}

}  // namespace quarry::cli
