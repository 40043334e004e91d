// The subcommands of `quarry`. Each adds itself to the program; what it does runs as a callback after
// parsing, and fails by throwing Error.
#pragma once

#include <CLI/CLI.hpp>

namespace quarry::cli {

void add_mesh_command(CLI::App& program);
void add_clean_command(CLI::App& program);
void add_quality_command(CLI::App& program);
void add_convert_command(CLI::App& program);
void add_picture_command(CLI::App& program);
void add_improve_command(CLI::App& program);
void add_generate_command(CLI::App& program);
void add_batch_command(CLI::App& program);
// Commands whose place is kept: adapt.
void add_planned_commands(CLI::App& program);

}  // namespace quarry::cli
