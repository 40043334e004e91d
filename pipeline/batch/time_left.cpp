#include "pipeline/batch/time_left.hpp"

#include <fmt/format.h>

namespace quarry {

TimeLeft::TimeLeft(std::span<const BatchJob> jobs, std::span<const std::size_t> order)
    : jobs_(jobs), count_(order.size()) {
  for (const std::size_t job : order) weight_ += jobs[job].weight;
}

void TimeLeft::add(const JobRecord& record) {
  ++ended_;
  ended_weight_ += jobs_[record.job].weight;
}

double TimeLeft::share() const { return weight_ > 0 ? ended_weight_ / weight_ : 1; }

std::string TimeLeft::text(double elapsed) const {
  std::string text = fmt::format("{}/{}", ended_, count_);
  if (ended_weight_ > 0 && ended_ < count_)
    text += ", " + duration_text(elapsed * (weight_ - ended_weight_) / ended_weight_);
  return text;
}

std::string duration_text(double seconds) {
  constexpr double kMinute = 60, kHour = 3600;
  if (seconds < 10) return fmt::format("{:.1f} s", seconds);
  if (seconds < 2 * kMinute) return fmt::format("{:.0f} s", seconds);
  if (seconds < 2 * kHour) return fmt::format("{:.0f} min", seconds / kMinute);
  return fmt::format("{:.1f} h", seconds / kHour);
}

}  // namespace quarry
