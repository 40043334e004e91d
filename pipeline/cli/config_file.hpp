// Options from a TOML file: `--config FILE.toml`. Its keys are the long names of the command's options
// without the dashes; `inputs` holds the input files. What the command line gives wins. Paths are relative to
// the working folder.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace quarry::cli {

// Gives each option of the command that was not given the value of its key in the file, if it has one. Throws
// Error(kInput) for a file that cannot be read or is no TOML, Error(kUsage) for a key that no option has
// (named, with its line) and for values of the wrong kind.
void apply_config(CLI::App& command, const std::string& path);

}  // namespace quarry::cli
