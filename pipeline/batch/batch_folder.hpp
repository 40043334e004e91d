// The folder that a batch writes to. Beside the outputs of the jobs it has a folder `batch`: what became of
// each job, what each worker said, and the lock.
#pragma once

#include <span>
#include <string>

#include "pipeline/batch/job.hpp"

namespace quarry {

class BatchFolder {
 public:
  // Makes the folders that are missing. Throws Error(kOutput).
  explicit BatchFolder(std::string path);

  [[nodiscard]] const std::string& path() const { return path_; }
  // What the worker of a job writes to its standard error stream.
  [[nodiscard]] std::string log(const BatchJob& job) const;
  // What became of a job when it was last run.
  [[nodiscard]] std::string record(const BatchJob& job) const;
  // What became of all.
  [[nodiscard]] std::string table() const;
  [[nodiscard]] std::string lock() const;

 private:
  std::string path_;
};

// Keeps other batches out of the folder while it is in scope; the system frees it when the process ends, of
// whatever cause. Throws Error(kOutput) where another one is at work.
class BatchLock {
 public:
  explicit BatchLock(const BatchFolder& folder);
  ~BatchLock();
  BatchLock(const BatchLock&) = delete;
  BatchLock& operator=(const BatchLock&) = delete;

 private:
  int descriptor_ = -1;
};

// Makes the folders that the outputs of the jobs lie in. Throws Error(kOutput).
void make_output_folders(std::span<const BatchJob> jobs);

// Removes the half-written outputs of the jobs that workers have left which were killed: those of one
// process, or of all (0). Nobody else may be writing them.
void remove_partial_outputs(std::span<const BatchJob> jobs, int process);

}  // namespace quarry
