// The command `quarry`: reads arguments, calls a job, prints. No algorithm lives here.
#include <csignal>
#include <exception>

#include <CLI/CLI.hpp>

#include "engine/base/error.hpp"
#include "engine/base/log.hpp"
#include "engine/base/progress.hpp"
#include "pipeline/cli/commands.hpp"

namespace {

quarry::CancellationToken& interrupted() {
  static quarry::CancellationToken token;
  return token;
}

void on_interrupt(int) { interrupted().cancel(); }

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGINT, on_interrupt);
  CLI::App program{"Quads and triangles from line work, with every line kept", "quarry"};
  program.require_subcommand(1);
  const quarry::Progress progress({}, &interrupted());
  quarry::cli::add_mesh_command(program, progress);
  try {
    program.parse(argc, argv);
    return 0;
  } catch (const CLI::ParseError& error) {
    const int code = program.exit(error);
    return code == 0 ? 0 : static_cast<int>(quarry::ErrorKind::kUsage);
  } catch (const quarry::Error& error) {
    quarry::log::write_error(error.message());
    return error.exit_code();
  } catch (const std::exception& error) {
    quarry::log::write_error(error.what());
    return static_cast<int>(quarry::ErrorKind::kBug);
  }
}
