// Options of a batch.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/batch/job.hpp"

namespace quarry {

struct BatchOptions {
  // What runs a job: a program, and what it is given before the words of the job, "--threads" and a number.
  std::vector<std::string> worker;
  std::string version;                      // of that program: what another one has done is done again
  int threads = 1;                          // that workers have, all of them together
  std::optional<double> job_seconds;        // after which a job is ended
  std::optional<std::uint64_t> job_bytes;   // of resident memory, beyond which a job is ended
  std::uint64_t memory_bytes = UINT64_MAX;  // the same of all workers together
  // Told of each job once it has ended, or was found done.
  std::function<void(const JobRecord&)> on_record;
};

// Nine tenths of the memory that this machine, or the control group of this process, has.
[[nodiscard]] std::uint64_t usual_memory_limit();

}  // namespace quarry
