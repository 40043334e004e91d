#include "pipeline/batch/guess_weights.hpp"

#include <chrono>
#include <csignal>
#include <limits>
#include <thread>

#include <gtest/gtest.h>

#include "engine/base/error.hpp"

namespace quarry {
namespace {

TEST(GuessedWeights, AreNoneWhereTheGuessCrashesThrowsOrTakesTooLong) {
  const auto guess = [](std::size_t i) -> double {
    if (i == 1) std::raise(SIGKILL);
    if (i == 3) throw Error(ErrorKind::kInput, "broken");
    if (i == 4) std::this_thread::sleep_for(std::chrono::minutes(10));
    if (i == 5) return std::numeric_limits<double>::quiet_NaN();
    if (i == 6) return -1;
    return static_cast<double>(10 * (i + 1));
  };
  const std::vector<std::optional<double>> weights = guess_weights(8, guess, Progress());
  const std::vector<std::optional<double>> expected = {10,           std::nullopt, 30,           std::nullopt,
                                                       std::nullopt, std::nullopt, std::nullopt, 80};
  EXPECT_EQ(weights, expected);
}

TEST(GuessedWeights, EndWithTheBatch) {
  CancellationToken token;
  token.cancel();
  EXPECT_THROW((void)guess_weights(
                   1, [](std::size_t) { return 1.0; }, Progress({}, &token)),
               Error);
  EXPECT_TRUE(guess_weights(
                  0, [](std::size_t) { return 1.0; }, Progress())
                  .empty());
}

}  // namespace
}  // namespace quarry
