#include <array>
#include <string>
#include <utility>

#include "pipeline/cli/commands.hpp"
#include "pipeline/cli/not_built.hpp"

namespace quarry::cli {

void add_planned_commands(CLI::App& program) {
  constexpr std::array<std::pair<const char*, const char*>, 1> kPlanned = {{
      {"adapt", "remesh to an error estimate (not built yet)"},
  }};
  for (const auto& [name, help] : kPlanned) {
    CLI::App* command = program.add_subcommand(name, help);
    // Whatever its arguments will be, the answer is the same.
    command->allow_extras();
    command->callback([text = std::string("quarry ") + name] { fail_not_built(text); });
  }
}

}  // namespace quarry::cli
