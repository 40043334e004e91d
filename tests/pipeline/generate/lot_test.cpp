// What is drawn follows its law.
#include "pipeline/generate/lot.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace quarry {
namespace {

constexpr std::size_t kDraws = 40000;
// The largest distance to the distribution (Kolmogorov's) that one set of draws in ten thousand exceeds.
const double kFar = 2.23 / std::sqrt(static_cast<double>(kDraws));

template <class Distribution>
double distance_to(std::vector<double> values, Distribution&& below) {
  std::sort(values.begin(), values.end());
  double farthest = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    farthest = std::fmax(farthest, std::abs(below(values[i]) - (static_cast<double>(i) + 0.5) /
                                                                   static_cast<double>(values.size())));
  return farthest;
}

TEST(PowerLaw, DrawsLengthsOfItsDistribution) {
  for (const double exponent : {0.0, 1.0, 2.0, 2.5, 4.0}) {
    const PowerLaw law(exponent, 3, 200);
    std::vector<double> lengths;
    for (std::size_t i = 0; i < kDraws; ++i) {
      Lot lot(7, i);
      lengths.push_back(law.draw(lot));
    }
    EXPECT_GE(*std::min_element(lengths.begin(), lengths.end()), 3);
    EXPECT_LE(*std::max_element(lengths.begin(), lengths.end()), 200);
    const auto below = [&](double l) {
      if (exponent == 1) return std::log(l / 3) / std::log(200.0 / 3);
      return (std::pow(l, 1 - exponent) - std::pow(3, 1 - exponent)) /
             (std::pow(200, 1 - exponent) - std::pow(3, 1 - exponent));
    };
    EXPECT_LT(distance_to(lengths, below), kFar) << exponent;
  }
}

TEST(VonMises, DrawsAnglesOfItsDistribution) {
  for (const double kappa : {0.0, 0.5, 4.0, 30.0, 1e5}) {
    const VonMises law(kappa);
    std::vector<double> angles;
    for (std::size_t i = 0; i < kDraws; ++i) {
      Lot lot(8, i);
      const Vec2 direction = law.draw(lot);
      EXPECT_NEAR(length(direction), 1, 1e-12);
      angles.push_back(std::atan2(direction.y, direction.x));
    }
    // The integral of the density by the trapezoidal rule, which converges fast for what is periodic.
    constexpr std::size_t kSteps = 400000;
    std::vector<double> sums{0};
    const auto density = [&](double angle) { return std::exp(kappa * (std::cos(angle) - 1)); };
    const double step = 2 * std::numbers::pi / kSteps;
    for (std::size_t i = 0; i < kSteps; ++i)
      sums.push_back(sums.back() + 0.5 * step *
                                       (density(-std::numbers::pi + static_cast<double>(i) * step) +
                                        density(-std::numbers::pi + static_cast<double>(i + 1) * step)));
    const auto below = [&](double angle) {
      const double at = std::clamp((angle + std::numbers::pi) / step, 0.0, kSteps - 1.0);
      const auto i = static_cast<std::size_t>(at);
      return (sums[i] + (at - static_cast<double>(i)) * (sums[i + 1] - sums[i])) / sums.back();
    };
    EXPECT_LT(distance_to(angles, below), kFar) << kappa;
  }
}

TEST(Lot, DrawsNormalDeviates) {
  std::vector<double> values;
  for (std::size_t i = 0; i < kDraws; ++i) values.push_back(Lot(9, i).normal());
  EXPECT_LT(distance_to(values, [](double x) { return 0.5 * std::erfc(-x / std::numbers::sqrt2); }), kFar);
}

}  // namespace
}  // namespace quarry
