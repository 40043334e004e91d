// Lists of jobs in TOML: a table [defaults] and tables [[job]]. Their keys are the long names of the options
// of `quarry mesh` without dashes; a job also has `input` (a file, or a list of files that are meshed
// together), `name` and `output`.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <toml++/toml.h>

namespace quarry::cli {

struct ListedJob {
  const toml::table* table = nullptr;
  std::vector<std::string> inputs;
  std::string name, output;  // "": not given
};

class BatchList {
 public:
  // Throws Error(kInput) for a file that cannot be read or is no TOML, and Error(kUsage) with the line for
  // what such a list does not have and for a job without input.
  explicit BatchList(std::string path);
  // Jobs point into it.
  BatchList(BatchList&&) = delete;
  BatchList& operator=(BatchList&&) = delete;

  [[nodiscard]] const std::vector<ListedJob>& jobs() const { return jobs_; }
  // Gives options of `quarry mesh` that were not given before the values that the job has for them, then
  // those of the defaults. Throws Error(kUsage) with the line for a key that is no option of a job.
  void apply(const ListedJob& job, CLI::App& mesh) const;

 private:
  void apply(const toml::table& table, CLI::App& mesh) const;

  std::string path_;
  toml::table table_;
  const toml::table* defaults_ = nullptr;
  std::vector<ListedJob> jobs_;
};

}  // namespace quarry::cli
