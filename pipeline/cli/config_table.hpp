// Tables of TOML whose keys are options of a command: what files of options and lists of jobs have in common.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>
#include <toml++/toml.h>

namespace quarry::cli {

// Throws Error(kInput) for a file that cannot be read or is no TOML, with the line.
[[nodiscard]] toml::table parse_toml(const std::string& path);

// Throws Error(kUsage) with the file, the line and the key.
[[noreturn]] void fail_at(const std::string& path, const toml::key& key, std::string_view what);

// A value, or the values of a list, as one would write them on the command line. Throws as fail_at for
// tables.
[[nodiscard]] std::vector<std::string> texts_of(const std::string& path, const toml::key& key,
                                                const toml::node& node);

// Gives the option that the key names its value, unless it has one. Throws as fail_at for a key that no
// option has and for values of the wrong kind.
void apply_entry(CLI::App& command, const std::string& path, const toml::key& key, const toml::node& node);

}  // namespace quarry::cli
