// Other programs, run without a shell and waited for.
#pragma once

#include <chrono>
#include <optional>

#include "engine/base/progress.hpp"
#include "io/running_child.hpp"

namespace quarry {

struct ChildProcess {
  ChildStart start;
  std::chrono::seconds time_limit{600};
};

// Runs a program to its end and returns its exit status (128 + n where signal n ended it); none if there is
// no such program. Throws Error(kInterrupted) when the job is cancelled, Error(kBudget) where the time limit
// ends it, and Error(kOutput) where it cannot be started; it never outlives this call.
[[nodiscard]] std::optional<int> run_program(const ChildProcess& process, const Progress& progress);

}  // namespace quarry
