#include <memory>
#include <string>
#include <utility>

#include "engine/base/log.hpp"
#include "io/mesh/mesh_format.hpp"
#include "kernels/quality/face.hpp"
#include "pipeline/cli/commands.hpp"
#include "pipeline/cli/common_arguments.hpp"
#include "pipeline/cli/outputs.hpp"

namespace quarry::cli {
namespace {

struct ConvertArguments {
  CommonArguments common;
  std::string input, output;
  bool compress = false;
};

void run(const ConvertArguments& arguments) {
  check_readable_extension(arguments.input);
  check_writable_extension(arguments.output);
  check_outputs({arguments.output}, {arguments.input});
  ReadCells cells = read_cells(arguments.input);
  const GroupNames names = cells.names;
  const Mesh mesh = make_mesh(arguments.input, std::move(cells));
  const std::vector<double> jacobians = scaled_jacobians(mesh);
  MeshWriteOptions options;
  options.fields = {{"quarry_version", QUARRY_VERSION}};
  options.names = names;
  options.scaled_jacobian = jacobians;
  options.compress = arguments.compress;
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
  command->add_flag("--compress", arguments->compress, "zlib in a .vtu");
  add_common_options(*command, arguments->common);
  command->callback([arguments] { run_job(arguments->common, [&] { run(*arguments); }); });
}

}  // namespace quarry::cli
