#include "pipeline/report/stages.hpp"

#include <algorithm>

namespace quarry {

double StageTime::busy_share(int threads) const {
  const double room = seconds * threads;
  // The two clocks do not tick together.
  return room > 0 ? std::clamp(processor_seconds / room, 0.0, 1.0) : 0;
}

void StageClock::start(const std::string& name) {
  stop();
  progress_->report(name, 0);
  const auto same = [&](const StageTime& time) { return time.name == name; };
  current_ = static_cast<std::size_t>(std::find_if(times_.begin(), times_.end(), same) - times_.begin());
  if (current_ == times_.size()) times_.push_back({name, 0, 0});
  began_ = std::chrono::steady_clock::now();
  ticks_ = std::clock();
  running_ = true;
}

void StageClock::stop() {
  if (!running_) return;
  StageTime& time = times_[current_];
  time.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
  time.processor_seconds += static_cast<double>(std::clock() - ticks_) / CLOCKS_PER_SEC;
  running_ = false;
}

}  // namespace quarry
