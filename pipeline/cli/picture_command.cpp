#include "pipeline/cli/commands.hpp"
#include "pipeline/cli/not_built.hpp"

namespace quarry::cli {

void add_picture_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand("picture", "draw a mesh");
  command->allow_extras();
  command->callback([] { fail_not_built("quarry picture"); });
}

}  // namespace quarry::cli
