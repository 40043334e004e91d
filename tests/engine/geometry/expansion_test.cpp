#include "engine/geometry/expansion.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "engine/base/random.hpp"

namespace quarry {
namespace {

// Integers of up to 26 bits with any exponent in a small range: sums and products are checked in 128-bit
// integers.
using Wide = __int128;

double draw(std::uint64_t counter) {
  return std::floor((uniform01(11, 2 * counter) - 0.5) * 0x1p26) *
         std::ldexp(1, static_cast<int>(uniform01(11, 2 * counter + 1) * 30));
}

template <std::size_t N>
Wide value_of(const Expansion<N>& expansion) {
  Wide sum = 0;
  for (std::size_t i = 0; i < expansion.size; ++i) sum += static_cast<Wide>(expansion.terms[i]);
  return sum;
}

template <std::size_t N>
void expect_in_order(const Expansion<N>& expansion) {
  for (std::size_t i = 0; i < expansion.size; ++i) {
    ASSERT_NE(expansion.terms[i], 0);
    if (i > 0) {
      ASSERT_LT(std::abs(expansion.terms[i - 1]), std::abs(expansion.terms[i]));
    }
  }
}

TEST(DoubleWord, HoldsSumsAndProductsExactly) {
  for (std::uint64_t i = 0; i < 10'000; ++i) {
    const double a = draw(2 * i);
    const double b = draw(2 * i + 1);
    const DoubleWord sum = two_sum(a, b);
    const DoubleWord product = two_product(a, b);
    ASSERT_EQ(static_cast<Wide>(sum.high) + static_cast<Wide>(sum.low),
              static_cast<Wide>(a) + static_cast<Wide>(b));
    ASSERT_EQ(static_cast<Wide>(product.high) + static_cast<Wide>(product.low),
              static_cast<Wide>(a) * static_cast<Wide>(b));
    ASSERT_EQ(sum.high, a + b);
    ASSERT_EQ(product.high, a * b);
  }
}

TEST(Expansion, MultipliesAndSubtractsExactly) {
  for (std::uint64_t i = 0; i < 10'000; ++i) {
    const double a = draw(4 * i);
    const double b = std::floor(uniform01(12, i) * 0x1p40);
    const double c = draw(4 * i + 2);
    const double d = std::floor(uniform01(13, i) * 0x1p40);
    const Expansion<2> first(two_sum(a, b));
    const Expansion<2> second(two_sum(c, d));
    const auto result = first * second - second * d;
    const Wide one = static_cast<Wide>(a) + static_cast<Wide>(b);
    const Wide two = static_cast<Wide>(c) + static_cast<Wide>(d);
    ASSERT_EQ(value_of(result), one * two - two * static_cast<Wide>(d));
    expect_in_order(result);
  }
}

TEST(Expansion, HasNoTermsWhenItIsZero) {
  const Expansion<2> number(two_sum(1, 0x1p-80));
  const auto nothing = number * number - number * number;
  EXPECT_EQ(nothing.size, 0U);
  EXPECT_EQ(nothing.leading(), 0);
}

}  // namespace
}  // namespace quarry
