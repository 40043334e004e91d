// The command `quarry`: reads arguments, calls a job, prints. No algorithm lives here.
#include <algorithm>
#include <exception>
#include <new>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "engine/base/heap.hpp"
#include "engine/base/log.hpp"
#include "pipeline/cli/commands.hpp"
#include "pipeline/cli/interrupt.hpp"

namespace quarry::cli {
namespace {

constexpr const char* kFooter =
    "\nquarry CMD --help tells the options of a command. Messages go to stderr, results asked for to "
    "stdout.\n"
    "Exit codes: 0 done, 1 a bug in quarry, 2 usage, 3 input cannot be read or is invalid, 4 geometry cannot "
    "be\n"
    "meshed as asked, 5 a stated budget ran out, 6 a quality demand is not met, 7 output cannot be written,\n"
    "8 jobs of a batch did not end well, 130 interrupted. Output files appear whole or not at all.";

void add_commands(CLI::App& program) {
  program.set_version_flag("--version", "quarry " QUARRY_VERSION, "the version, and nothing else");
  program.set_help_flag("-h,--help", "this text");
  program.require_subcommand(1);
  program.footer(kFooter);
  program.get_formatter()->column_width(34);
  add_mesh_command(program);
  add_clean_command(program);
  add_improve_command(program);
  add_quality_command(program);
  add_convert_command(program);
  add_picture_command(program);
  add_generate_command(program);
  add_batch_command(program);
  add_planned_commands(program);
}

// The parser's own words for a command that it does not know do not name it. words: what is to be read as the
// name of a command of `program`, and what follows; path: how one calls the program.
void require_known_command(const CLI::App& program, std::span<char* const> words, const std::string& path) {
  if (words.empty())
    throw Error(ErrorKind::kUsage, fmt::format("no command is given; {} --help lists them", path));
  const std::string name = words[0];
  if (name.starts_with("-")) {
    if (program.get_option_no_throw(name) != nullptr) return;
    throw Error(ErrorKind::kUsage,
                fmt::format("there is no option '{}' before a command; see {} --help", name, path));
  }
  const auto called = [&](const CLI::App* command) { return command->get_name() == name; };
  const std::vector<const CLI::App*> commands = program.get_subcommands(called);
  if (commands.empty())
    throw Error(ErrorKind::kUsage, fmt::format("there is no command '{}'; {} --help lists them", name, path));
  if (!commands.front()->get_subcommands(nullptr).empty())
    require_known_command(*commands.front(), words.subspan(1), path + " " + name);
}

int parse_and_run(CLI::App& program, int argc, char** argv) {
  try {
    require_known_command(program, std::span<char* const>(argv, static_cast<std::size_t>(argc)).subspan(1),
                          "quarry");
    program.parse(argc, argv);
    return 0;
  } catch (const CLI::ParseError& error) {
    // Help and version come as exceptions with code 0.
    if (error.get_exit_code() == 0) return program.exit(error);
    std::string line = error.what();
    std::replace(line.begin(), line.end(), '\n', ' ');
    throw Error(ErrorKind::kUsage, line);
  }
}

int run(int argc, char** argv) {
  CLI::App program{"Quadrilaterals and triangles from line work, with every line kept.", "quarry"};
  try {
    add_commands(program);
    return parse_and_run(program, argc, argv);
  } catch (const Error& error) {
    log::write_error(error.message());
    return error.exit_code();
  } catch (const std::bad_alloc&) {
    log::write_error("out of memory; take a larger --size, or run it where there is more");
    return static_cast<int>(ErrorKind::kBudget);
  } catch (const std::exception& error) {
    log::write_error(fmt::format("a bug in quarry: {}", error.what()));
    return static_cast<int>(ErrorKind::kBug);
  }
}

}  // namespace
}  // namespace quarry::cli

int main(int argc, char** argv) {
  quarry::keep_freed_memory();
  quarry::cli::catch_interrupts();
  return quarry::cli::run(argc, argv);
}
