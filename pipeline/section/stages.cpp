#include "pipeline/section/stages.hpp"

#include <utility>

namespace quarry {

void StageClock::start(std::string name) {
  stop();
  progress_->report(name, 0);
  times_.push_back({std::move(name), 0});
  began_ = std::chrono::steady_clock::now();
  running_ = true;
}

void StageClock::stop() {
  if (!running_) return;
  times_.back().seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
  running_ = false;
}

}  // namespace quarry
