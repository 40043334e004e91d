// Wall-clock seconds of the stages of a job, in order.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "engine/base/progress.hpp"

namespace quarry {

struct StageTime {
  std::string name;
  double seconds = 0;
};

class StageClock {
 public:
  explicit StageClock(const Progress& progress) : progress_(&progress) {}
  // Ends the stage that runs and starts the next; the times of one that is started again add up.
  void start(const std::string& name);
  // Ends the last stage.
  void stop();
  [[nodiscard]] const std::vector<StageTime>& times() const { return times_; }

 private:
  const Progress* progress_;
  std::vector<StageTime> times_;
  std::size_t current_ = 0;
  std::chrono::steady_clock::time_point began_;
  bool running_ = false;
};

}  // namespace quarry
