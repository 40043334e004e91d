#include "pipeline/cli/config_file.hpp"

#include <vector>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "pipeline/cli/config_table.hpp"

namespace quarry::cli {
namespace {

// A value as one would write it on the command line; shortest digits that read as the same number.
void append_texts(const std::string& path, const toml::key& key, const toml::node& node,
                  std::vector<std::string>& texts) {
  if (const auto* text = node.as_string()) {
    texts.push_back(text->get());
  } else if (const auto* whole = node.as_integer()) {
    texts.push_back(fmt::format("{}", whole->get()));
  } else if (const auto* number = node.as_floating_point()) {
    texts.push_back(fmt::format("{}", number->get()));
  } else if (const auto* flag = node.as_boolean()) {
    texts.emplace_back(flag->get() ? "true" : "false");
  } else if (const auto* list = node.as_array()) {
    for (const toml::node& item : *list) append_texts(path, key, item, texts);
  } else {
    fail_at(path, key, "is neither a text, a number, true or false, nor a list of them");
  }
}

CLI::Option* find_option(CLI::App& command, const std::string& key) {
  // The positional files have no dashes; these two options make no sense in a file.
  if (key == "help" || key == "config" || key.starts_with("-")) return nullptr;
  CLI::Option* option = command.get_option_no_throw("--" + key);
  return option != nullptr || key != "inputs" ? option : command.get_option_no_throw(key);
}

}  // namespace

toml::table parse_toml(const std::string& path) {
  try {
    return toml::parse_file(path);
  } catch (const toml::parse_error& error) {
    throw Error(ErrorKind::kInput, fmt::format("{}: line {}: {}", path, error.source().begin.line,
                                               std::string_view(error.description())));
  }
}

void fail_at(const std::string& path, const toml::key& key, std::string_view what) {
  throw Error(ErrorKind::kUsage,
              fmt::format("{}: line {}: key {}: {}", path, key.source().begin.line, key.str(), what));
}

std::vector<std::string> texts_of(const std::string& path, const toml::key& key, const toml::node& node) {
  std::vector<std::string> texts;
  append_texts(path, key, node, texts);
  return texts;
}

void apply_entry(CLI::App& command, const std::string& path, const toml::key& key, const toml::node& node) {
  CLI::Option* option = find_option(command, std::string(key.str()));
  if (option == nullptr)
    fail_at(path, key, fmt::format("`quarry {}` has no such option", command.get_name()));
  if (option->count() > 0) return;
  const std::vector<std::string> texts = texts_of(path, key, node);
  try {
    for (const std::string& text : texts) option->add_result(text);
    if (!texts.empty()) option->run_callback();
  } catch (const CLI::ParseError& error) {
    fail_at(path, key, error.what());
  }
}

void apply_config(CLI::App& command, const std::string& path) {
  const toml::table table = parse_toml(path);
  for (const auto& [key, node] : table) apply_entry(command, path, key, node);
}

}  // namespace quarry::cli
