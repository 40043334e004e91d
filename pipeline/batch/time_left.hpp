// How far a batch is, and about how long it will take from there.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "pipeline/batch/job.hpp"

namespace quarry {

class TimeLeft {
 public:
  // order: the jobs that are to be run.
  TimeLeft(std::span<const BatchJob> jobs, std::span<const std::size_t> order);

  // A job has ended.
  void add(const JobRecord& record);
  // Of the work, as the weights of jobs have it; in [0, 1].
  [[nodiscard]] double share() const;
  // "37/200, 2 min": jobs that have ended, and the time that the rest takes if it goes on as it went for so
  // many seconds.
  [[nodiscard]] std::string text(double elapsed) const;

 private:
  std::span<const BatchJob> jobs_;
  std::size_t count_, ended_ = 0;
  double weight_ = 0, ended_weight_ = 0;
};

// "45 s", "2 min", "3.5 h"
[[nodiscard]] std::string duration_text(double seconds);

}  // namespace quarry
