// The functions agree with the C library's to a few units in the last place, and their bits are written down
// here.
#include "pipeline/generate/portable_math.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "engine/base/random.hpp"

namespace quarry {
namespace {

constexpr double kUlp = 0x1p-52;

TEST(PortableMath, LogarithmsAgreeWithTheLibrary) {
  for (std::uint64_t i = 0; i < 20000; ++i) {
    const double x = std::ldexp(0.5 + uniform01(1, i), static_cast<int>(mix64(i) % 200) - 100);
    const double expected = std::log(x);
    EXPECT_NEAR(portable::log(x), expected, 4 * kUlp * std::fmax(std::abs(expected), 1e-3)) << x;
  }
  EXPECT_EQ(portable::log(1), 0);
}

TEST(PortableMath, ExponentialsAgreeWithTheLibrary) {
  for (std::uint64_t i = 0; i < 20000; ++i) {
    const double x = 600 * (2 * uniform01(2, i) - 1);
    EXPECT_NEAR(portable::exp(x) / std::exp(x), 1, 8 * kUlp) << x;
  }
  EXPECT_EQ(portable::exp(0), 1);
}

TEST(PortableMath, DirectionsAgreeWithTheLibrary) {
  for (std::uint64_t i = 0; i < 20000; ++i) {
    const double angle = (i % 2 == 0 ? 10 : 1000) * (2 * uniform01(3, i) - 1);
    const Vec2 direction = portable::direction(angle);
    EXPECT_NEAR(direction.x, std::cos(angle), 4 * kUlp) << angle;
    EXPECT_NEAR(direction.y, std::sin(angle), 4 * kUlp) << angle;
  }
  EXPECT_EQ(portable::direction(0), (Vec2{1, 0}));
}

TEST(PortableMath, HasTheSameBitsEverywhere) {
  EXPECT_EQ(portable::log(10), 0x1.26bb1bbb55516p+1);
  EXPECT_EQ(portable::exp(1), 0x1.5bf0a8b14576ap+1);
  EXPECT_EQ(portable::power(3, -1.5), 0x1.8a2345cc04426p-3);
  EXPECT_EQ(portable::direction(2).x, -0x1.aa22657537205p-2);
  EXPECT_EQ(portable::direction(2).y, 0x1.d18f6ead1b446p-1);
}

}  // namespace
}  // namespace quarry
