// The subcommands of `quarry`. Each adds itself to the program; what it does runs as a callback after parsing.
#pragma once

#include <CLI/CLI.hpp>

#include "engine/base/progress.hpp"

namespace quarry::cli {

void add_mesh_command(CLI::App& program, const Progress& progress);

}  // namespace quarry::cli
