// Fails the day -ffp-contract=off gets lost: compilers fuse products by default where the target can.
#include <gtest/gtest.h>

#include "engine/base/random.hpp"
#include "tests/engine/geometry/contraction_probe.hpp"

namespace quarry {
namespace {

class Contraction : public testing::Test {
 protected:
  void SetUp() override {
#if defined(QUARRY_PROBE_HAS_FMA)
    if (!__builtin_cpu_supports("fma")) GTEST_SKIP() << "this processor has no fused multiply-add";
#else
    GTEST_SKIP() << "this compiler has no -mfma for its target";
#endif
  }
};

TEST_F(Contraction, LeavesTheCrossProductOfAVectorWithItselfZero) {
  const Vec2 known{0.8833108082136426, 0.5665615751722809};
  EXPECT_EQ(probe_cross(known, known), 0) << "contracted, this is 1.5e-17";
  for (std::uint64_t i = 0; i < 100'000; ++i) {
    const Vec2 u{uniform01(1, 2 * i), uniform01(1, 2 * i + 1)};
    ASSERT_EQ(probe_cross(u, u), 0) << u.x << ' ' << u.y;
  }
}

TEST_F(Contraction, LetsACrossProductChangeItsSignWithTheOrderOfItsVectors) {
  for (std::uint64_t i = 0; i < 100'000; ++i) {
    const Vec2 u{uniform01(2, 4 * i), uniform01(2, 4 * i + 1)};
    const Vec2 v{uniform01(2, 4 * i + 2), uniform01(2, 4 * i + 3)};
    ASSERT_EQ(probe_cross(u, v), -probe_cross(v, u));
  }
}

TEST_F(Contraction, CallsNoTriangleLeftFromBothOrders) {
  const Vec2 twice{0.5, 0.5};
  const Vec2 other{0.6000000000000001, 0.4};
  EXPECT_EQ(probe_naive_orientation(twice, twice, other), 0);
  const auto grid_value = [](std::uint64_t counter) {
    return 0.1 * static_cast<double>(static_cast<int>(8 * uniform01(3, counter)));
  };
  for (std::uint64_t i = 0; i < 100'000; ++i) {
    const Vec2 a{grid_value(6 * i), grid_value(6 * i + 1)};
    const Vec2 b{grid_value(6 * i + 2), grid_value(6 * i + 3)};
    const Vec2 c{grid_value(6 * i + 4), grid_value(6 * i + 5)};
    ASSERT_EQ(probe_naive_orientation(a, b, c), -probe_naive_orientation(b, a, c));
  }
}

}  // namespace
}  // namespace quarry
