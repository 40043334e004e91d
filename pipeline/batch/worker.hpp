// A process that does one job: watched, ended where it goes beyond a limit, and cleaned up after.
//
// Each job has a process of its own rather than one of a pool: what a crash takes along is then one job, and
// memory that a job has left in pieces is not the next one's. The price is the start of the command, 20 ms of
// processor time (most of it the loading of libraries), where a small job of 2,000 quads takes 150.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "io/running_child.hpp"
#include "pipeline/batch/batch_folder.hpp"
#include "pipeline/batch/options.hpp"

namespace quarry {

class Worker {
 public:
  // scratch: a folder that does not exist yet, for the files that go when the job is done. Throws
  // Error(kOutput) where the worker cannot be started.
  Worker(const BatchOptions& options, const BatchFolder& folder, const BatchJob& job, std::size_t number,
         int threads, const std::string& scratch);
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  [[nodiscard]] std::size_t job() const { return number_; }
  [[nodiscard]] int threads() const { return threads_; }
  // Becomes readable when it has ended.
  [[nodiscard]] int descriptor() const { return child_.descriptor(); }
  // Memory as it was at the last look.
  [[nodiscard]] std::uint64_t bytes() const { return bytes_; }

  // Ends it where it is beyond a limit of its own.
  void keep_to_limits();
  // Ends it, as if this had come of it.
  void stop(Outcome outcome, std::string message);
  // What became of the job; none while it runs. To be asked no more once it has told.
  [[nodiscard]] std::optional<JobRecord> ended();

 private:
  using Clock = std::chrono::steady_clock;

  [[nodiscard]] double seconds() const;
  void judge(const ChildEnd& end, JobRecord& record) const;

  const BatchOptions& options_;
  const BatchJob& job_;
  std::size_t number_;
  int threads_;
  std::string log_, scratch_;
  RunningChild child_;
  Clock::time_point began_ = Clock::now();
  std::uint64_t bytes_ = 0;
  std::optional<Outcome> stopped_;
  std::string why_;
};

}  // namespace quarry
