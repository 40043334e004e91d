#include "pipeline/section/count_search.hpp"

#include <algorithm>
#include <cmath>

namespace quarry {
namespace {

// Beyond it, from the first size, the lines alone decide, and larger elements elsewhere are no help.
constexpr double kMostScale = 3;
// A round whose miss is not below this share of the least before was in vain. Numbers jump a little from size
// to size: one such round says nothing yet.
constexpr double kGain = 0.9;
constexpr int kMostInVain = 2;
// The number of elements falls with this power of their size where area decides it, and hardly where lines
// do.
constexpr double kPowerOfAreas = 2, kLeastPower = 0.5;

// By how fast the number falls from one round to the other.
template <class Round>
double power_between(const Round& a, const Round& b) {
  const double power = -std::log(a.elements / b.elements) / std::log(a.size / b.size);
  return std::clamp(std::isfinite(power) ? power : kPowerOfAreas, kLeastPower, kPowerOfAreas);
}

}  // namespace

std::optional<double> CountSearch::next(double elements) {
  if (ended_) return std::nullopt;
  const Round last{size_, elements};
  if (rounds_ > 0 && !(miss(last) < kGain * miss(best_))) ++in_vain_;
  if (rounds_ == 0 || miss(last) < miss(best_)) best_ = last;
  std::optional<Round>& side = elements > wanted_ ? above_ : below_;
  if (!side || miss(last) < miss(*side)) side = last;
  ++rounds_;
  if (miss(last) <= kCountTolerance) return std::nullopt;
  if (rounds_ == kMostRounds || in_vain_ == kMostInVain) return end(last);
  size_ = mended_size(last);
  if (std::abs(size_ / last.size - 1) <= kCountTolerance) return end(last);
  before_ = last;
  return size_;
}

double CountSearch::miss(const Round& round) const { return std::abs(round.elements / wanted_ - 1); }

double CountSearch::mended_size(const Round& last) const {
  if (above_ && below_) {
    // Between them, by the logarithms, and not too near to either.
    const double share = std::log(above_->elements / wanted_) / std::log(above_->elements / below_->elements);
    return above_->size * std::pow(below_->size / above_->size, std::clamp(share, 0.1, 0.9));
  }
  const double power = rounds_ > 1 ? power_between(last, before_) : kPowerOfAreas;
  return std::clamp(last.size * std::pow(last.elements / wanted_, 1 / power), first_size_ / kMostScale,
                    first_size_ * kMostScale);
}

std::optional<double> CountSearch::end(const Round& last) {
  ended_ = true;
  size_ = best_.size;
  if (size_ == last.size) return std::nullopt;
  return size_;
}

}  // namespace quarry
