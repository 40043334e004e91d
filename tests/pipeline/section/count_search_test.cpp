#include "pipeline/section/count_search.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

namespace quarry {
namespace {

struct Search {
  std::vector<double> sizes, elements;  // of each round
};

// The rounds where a mesh of a size has so many elements.
Search search(double wanted, double size, const std::function<double(double)>& elements_of) {
  CountSearch search(wanted, size);
  Search rounds;
  for (std::optional<double> next = size; next; next = search.next(rounds.elements.back())) {
    rounds.sizes.push_back(*next);
    rounds.elements.push_back(elements_of(*next));
    if (rounds.sizes.size() > 100) break;
  }
  return rounds;
}

// By how much the last round is farther off than the best.
double loss_of(const Search& rounds, double wanted) {
  double least = std::numeric_limits<double>::infinity();
  for (const double elements : rounds.elements) least = std::min(least, std::abs(elements - wanted));
  return std::abs(rounds.elements.back() - wanted) - least;
}

TEST(CountSearch, EndsAtOnceWhereTheCountIsMet) {
  EXPECT_EQ(search(1000, 2, [](double) { return 1015.0; }).sizes, std::vector<double>{2});
}

TEST(CountSearch, NeedsOneRoundMoreWhereAreaDecides) {
  const Search rounds = search(1000, 2, [](double size) { return 6000 / (size * size); });
  EXPECT_EQ(rounds.sizes.size(), 2U);
  EXPECT_NEAR(rounds.elements.back(), 1000, 1e-6);
}

TEST(CountSearch, MeetsCountsThatLinesMakeTwiceAsManyAtFirst) {
  const Search rounds = search(1000, 1, [](double size) { return 700 + 1300 / (size * size); });
  EXPECT_LE(rounds.sizes.size(), 6U);
  EXPECT_NEAR(rounds.elements.back(), 1000, 20);
}

TEST(CountSearch, KeepsTheBestWhereNumbersJump) {
  for (int seed = 1; seed <= 50; ++seed) {
    const Search rounds = search(300, 1, [&](double size) {
      return (250 + 300 / (size * size)) * (1 + 0.3 * std::sin(37 * seed * size));
    });
    EXPECT_LE(rounds.sizes.size(), 7U) << seed;
    EXPECT_EQ(loss_of(rounds, 300), 0) << seed;
  }
}

TEST(CountSearch, EndsSoonWhereSizesChangeNothing) {
  const Search rounds = search(300, 1, [](double) { return 900.0; });
  EXPECT_LE(rounds.sizes.size(), 4U);
  EXPECT_EQ(rounds.sizes.back(), 1) << "sizes larger than wanted are no help";
}

TEST(CountSearch, StaysWithinThriceTheFirstSize) {
  for (const double wanted : {1.0, 1e6})
    for (const double size : search(wanted, 1, [](double h) { return 1000 / h; }).sizes) {
      EXPECT_LE(size, 3);
      EXPECT_GE(size, 1.0 / 3);
    }
}

}  // namespace
}  // namespace quarry
