// The jobs of `quarry batch`: from folders, from lists in TOML, and from files one by one.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "engine/base/progress.hpp"
#include "pipeline/batch/job.hpp"
#include "pipeline/cli/mesh_arguments.hpp"

namespace quarry::cli {

struct BatchArguments {
  // Options of all jobs; its inputs are folders, lists and files, its output is the folder to write to.
  MeshArguments mesh;
  std::string format = "vtu", pictures;
  bool pages = false, json = false;
  std::optional<double> job_seconds;
  double tell_seconds = 60;  // off a terminal, between lines that tell how far the batch is
  std::optional<std::uint64_t> job_bytes, bytes;
};

struct BatchJobs {
  std::vector<BatchJob> jobs;
  std::vector<std::string> notes;  // one line each: what the user should know
};

// command: parsed into the arguments; what it was given goes before what a list says, and that before the
// defaults of the list. Throws Error(kInput) for a folder or a list that cannot be read and where there is no
// job at all, and Error(kUsage) for a list that makes no sense, jobs of the same name, and an output that is
// an input or another output as well. What is wrong with the options of one job is told when it is run.
[[nodiscard]] BatchJobs make_batch_jobs(const CLI::App& command, const BatchArguments& arguments,
                                        const Progress& progress);

}  // namespace quarry::cli
