#include "pipeline/cli/progress_bar.hpp"

#include <algorithm>
#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

#include "engine/base/log.hpp"
#include "pipeline/cli/interrupt.hpp"

namespace quarry::cli {
namespace {

constexpr int kCells = 30;
// Jobs shorter than the first need no bar; drawing more often than the second only costs time.
constexpr std::chrono::milliseconds kPatience{400};
constexpr std::chrono::milliseconds kInterval{50};

void write_terminal(std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

}  // namespace

std::string bar_text(std::string_view stage, double share) {
  const double part = std::clamp(share, 0.0, 1.0);
  const int full = static_cast<int>(part * kCells);
  return fmt::format("{:<14} [{:#>{}}{:.>{}}] {:3.0f}%", stage, "", full, "", kCells - full, 100 * part);
}

ProgressBar::ProgressBar(bool wanted, std::optional<std::chrono::duration<double>> interval)
    : shown_(wanted && ::isatty(STDERR_FILENO) == 1) {
  if (wanted && !shown_) interval_ = interval;
}

ProgressBar::~ProgressBar() { clear(); }

Progress ProgressBar::progress() {
  if (interval_) return {[this](std::string_view stage, double) { tell(stage); }, &interrupt_token()};
  if (!shown_) return {{}, &interrupt_token()};
  return {[this](std::string_view stage, double share) { show(stage, share); }, &interrupt_token()};
}

void ProgressBar::show(std::string_view stage, double share) {
  const Clock::time_point now = Clock::now();
  if (now - began_ < kPatience || (drawn_ && now - last_ < kInterval)) return;
  last_ = now;
  drawn_ = true;
  // The cursor goes back to the start of the line, where a message would overwrite the bar.
  write_terminal("\x1b[K" + bar_text(stage, share) + "\r");
}

void ProgressBar::tell(std::string_view stage) {
  const Clock::time_point now = Clock::now();
  if (now - last_ < *interval_) return;
  last_ = now;
  log::info("{}", stage);
}

void ProgressBar::clear() {
  if (drawn_) write_terminal("\x1b[K");
  drawn_ = false;
}

}  // namespace quarry::cli
