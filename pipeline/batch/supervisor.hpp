// Runs the jobs of a batch: small ones side by side, large ones with several threads each.
#pragma once

#include <span>
#include <vector>

#include "engine/base/progress.hpp"
#include "pipeline/batch/batch_folder.hpp"
#include "pipeline/batch/job_share.hpp"
#include "pipeline/batch/options.hpp"

namespace quarry {

// The jobs that need be run, the largest first (those of equal weight in the order of the list): then no
// long one is left to the end, when others have nothing to do. Records of the rest come with `done`.
struct BatchPlan {
  std::vector<std::size_t> order;
  std::vector<JobRecord> done;
};
[[nodiscard]] BatchPlan plan_batch(std::span<const BatchJob> jobs, const BatchFolder& folder,
                                   const std::string& version, const Progress& progress);

// Runs what the share gives, and returns what it tells became of jobs: here all that have ended, in any
// order. A job that fails, crashes or goes beyond a limit harms no other one. Where all workers together go
// beyond the limit of memory, the largest one is ended, and done again when no other job is left. Ends early,
// and ends the workers, when it is cancelled.
[[nodiscard]] std::vector<JobRecord> run_batch(const BatchOptions& options, const BatchFolder& folder,
                                               std::span<const BatchJob> jobs, JobShare& share,
                                               const Progress& progress);

}  // namespace quarry
