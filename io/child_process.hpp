// Other programs, run without a shell.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/progress.hpp"

namespace quarry {

struct ChildProcess {
  // The program, found in PATH, and what it is given.
  std::vector<std::string> words;
  // Files that take what it writes.
  std::string out, err;
  std::chrono::seconds time_limit{600};
};

// Runs a program to its end, with an empty standard input, and returns its exit status (128 + n where signal
// n ended it); none if there is no such program. Throws Error(kInterrupted) when the job is cancelled,
// Error(kBudget) where the time limit ends it, and Error(kOutput) where it cannot be started; it never
// outlives this call.
[[nodiscard]] std::optional<int> run_program(const ChildProcess& process, const Progress& progress);

}  // namespace quarry
