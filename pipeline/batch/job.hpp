// A job of a batch, and what became of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace quarry {

struct BatchJob {
  std::string name;                  // no other job of the batch has it
  std::vector<std::string> words;    // what the worker is given, but for the number of threads
  std::vector<std::string> inputs;   // all files that it reads, in the order of their hash
  std::vector<std::string> outputs;  // all files that it writes
  std::string report;                // the one of them that is its report (pipeline/report)
  double weight = 1;                 // about how much work it is, in terms of the others
};

enum class Outcome {
  kDone,
  kSkipped,  // was done before: same input, options and version, and the outputs are as they were left
  kFailed,   // ended by itself with an error
  kCrashed,  // ended by a signal
  kOutOfTime,
  kOutOfMemory,
  kNotRun,  // the batch was interrupted before its end
};

// "done", "out of memory": as the table has it.
[[nodiscard]] std::string_view outcome_text(Outcome outcome);

[[nodiscard]] constexpr bool is_good(Outcome outcome) {
  return outcome == Outcome::kDone || outcome == Outcome::kSkipped;
}

struct JobRecord {
  std::size_t job = 0;  // its place in the list of jobs
  Outcome outcome = Outcome::kNotRun;
  int exit_code = 0;                     // of the worker; 128 + n where signal n ended it
  std::string message;                   // one line: why it did not end well
  double seconds = 0;                    // from its start to its end
  double cpu_seconds = 0;                // user and system, of all of its threads
  std::uint64_t peak_bytes = 0;          // of resident memory
  int threads = 0;                       // that it was given
  int rank = 0;                          // that it ran on
  std::optional<std::int64_t> elements;  // of its mesh
  std::string input_hash;                // of what it read
};

}  // namespace quarry
