#include "pipeline/section/stages.hpp"

#include <algorithm>

namespace quarry {

void StageClock::start(const std::string& name) {
  stop();
  progress_->report(name, 0);
  const auto same = [&](const StageTime& time) { return time.name == name; };
  current_ = static_cast<std::size_t>(std::find_if(times_.begin(), times_.end(), same) - times_.begin());
  if (current_ == times_.size()) times_.push_back({name, 0});
  began_ = std::chrono::steady_clock::now();
  running_ = true;
}

void StageClock::stop() {
  if (!running_) return;
  times_[current_].seconds +=
      std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
  running_ = false;
}

}  // namespace quarry
