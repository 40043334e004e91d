#include "pipeline/cli/batch_list.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "pipeline/cli/config_table.hpp"

namespace quarry::cli {
namespace {

// Keys of a job that are no options.
constexpr std::array<std::string_view, 3> kOwnKeys = {"input", "name", "output"};
// Options that are the batch's.
constexpr std::array<std::string_view, 5> kKeysOfAll = {"threads", "quiet", "verbose", "inputs", "config"};

bool is_in(const auto& keys, const toml::key& key) {
  return std::ranges::find(keys, key.str()) != keys.end();
}

std::string one_text(const std::string& path, const toml::key& key, const toml::node& node) {
  if (const auto* text = node.as_string(); text != nullptr && !text->get().empty()) return text->get();
  fail_at(path, key, "is no text");
}

ListedJob read_job(const std::string& path, const toml::table& table) {
  ListedJob job{&table, {}, "", ""};
  for (const auto& [key, node] : table) {
    if (key.str() == "input") {
      job.inputs = texts_of(path, key, node);
      if (std::ranges::count(job.inputs, "") > 0) fail_at(path, key, "has a file without a name");
    }
    if (key.str() == "name") {
      job.name = one_text(path, key, node);
      if (job.name.find('/') != std::string::npos || job.name.starts_with('.'))
        fail_at(path, key, "is part of names of files: it has no / and does not begin with a point");
    }
    if (key.str() == "output") job.output = one_text(path, key, node);
  }
  if (job.inputs.empty())
    throw Error(ErrorKind::kUsage,
                fmt::format("{}: line {}: the job has no input", path, table.source().begin.line));
  return job;
}

}  // namespace

BatchList::BatchList(std::string path) : path_(std::move(path)), table_(parse_toml(path_)) {
  for (const auto& [key, node] : table_) {
    if (key.str() == "defaults" && node.is_table()) {
      defaults_ = node.as_table();
    } else if (const auto* list = node.as_array(); key.str() == "job" && list != nullptr && !list->empty() &&
                                                   list->is_homogeneous<toml::table>()) {
      for (const toml::node& each : *list) jobs_.push_back(read_job(path_, *each.as_table()));
    } else {
      fail_at(path_, key, "a list has a table [defaults] and tables [[job]], and nothing else");
    }
  }
  if (jobs_.empty()) throw Error(ErrorKind::kUsage, fmt::format("{}: there is no table [[job]]", path_));
}

void BatchList::apply(const ListedJob& job, CLI::App& mesh) const {
  apply(*job.table, mesh);
  if (defaults_ != nullptr) apply(*defaults_, mesh);
}

void BatchList::apply(const toml::table& table, CLI::App& mesh) const {
  // A size stands against a number of elements that is wanted by default, and the other way around.
  const bool sized = mesh.count("--size") + mesh.count("--count") > 0;
  for (const auto& [key, node] : table) {
    if (is_in(kKeysOfAll, key)) fail_at(path_, key, "is no option of one job");
    if (is_in(kOwnKeys, key)) {
      if (&table == defaults_) fail_at(path_, key, "is for one job, not for all");
      continue;
    }
    if (sized && (key.str() == "size" || key.str() == "count")) continue;
    apply_entry(mesh, path_, key, node);
  }
}

}  // namespace quarry::cli
