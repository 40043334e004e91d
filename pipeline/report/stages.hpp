// How long the stages of a job took, in order: by the clock, and of the processor. Nothing that is computed
// may depend on them.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include <ctime>

#include "engine/base/progress.hpp"

namespace quarry {

struct StageTime {
  std::string name;
  double seconds = 0;            // of the clock
  double processor_seconds = 0;  // of all threads of this process together

  // The share of its threads' time that they worked, in [0, 1]; the rest they had no work, or no core. A
  // thread that ran out of work counts as working while it still looks for some, for tens of microseconds.
  [[nodiscard]] double busy_share(int threads) const;
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
  std::clock_t ticks_ = 0;  // of the processor, when it began
  bool running_ = false;
};

}  // namespace quarry
