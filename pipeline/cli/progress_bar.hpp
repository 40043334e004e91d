// One line that shows how far a job is on a terminal; elsewhere, if that is wanted, a line every so often.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

#include "engine/base/progress.hpp"

namespace quarry::cli {

// Draws to the standard error stream if that is a terminal and the bar is wanted; gone when it goes out of
// scope. Where it is none, in log files and under mpirun, the stage is told after each interval, if one is
// given.
class ProgressBar {
 public:
  explicit ProgressBar(bool wanted, std::optional<std::chrono::duration<double>> interval = std::nullopt);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  // Reports to this bar, and is cancelled by an interrupt. The bar must outlive it.
  [[nodiscard]] Progress progress();
  // Wipes the line, so that a message can take its place.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  void show(std::string_view stage, double share);
  void tell(std::string_view stage);

  bool shown_;
  std::optional<std::chrono::duration<double>> interval_;
  bool drawn_ = false;
  Clock::time_point began_ = Clock::now();
  Clock::time_point last_ = began_;
};

// "insertion  [######..............]  30%"
[[nodiscard]] std::string bar_text(std::string_view stage, double share);

}  // namespace quarry::cli
