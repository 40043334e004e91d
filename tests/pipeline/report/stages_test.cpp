#include "pipeline/report/stages.hpp"

#include <chrono>
#include <thread>

#include <ctime>
#include <gtest/gtest.h>

namespace quarry {
namespace {

constexpr int kMilliseconds = 60;

void work() {
  const std::clock_t until = std::clock() + kMilliseconds * (CLOCKS_PER_SEC / 1000);
  while (std::clock() < until) {
  }
}

TEST(StageClock, TellsWorkFromWaiting) {
  const Progress progress;
  StageClock clock(progress);
  clock.start("waiting");
  std::this_thread::sleep_for(std::chrono::milliseconds(kMilliseconds));
  clock.start("working");
  work();
  clock.stop();
  ASSERT_EQ(clock.times().size(), 2U);
  const StageTime& waiting = clock.times()[0];
  const StageTime& working = clock.times()[1];
  EXPECT_GE(waiting.seconds, 1e-3 * kMilliseconds);
  EXPECT_LT(waiting.busy_share(1), 0.5);
  EXPECT_GE(working.processor_seconds, 0.99e-3 * kMilliseconds);
}

TEST(StageClock, AddsUpTheTimesOfAStageThatIsStartedAgain) {
  const Progress progress;
  StageClock clock(progress);
  for (const char* name : {"cleaning", "insertion", "cleaning"}) {
    clock.start(name);
    work();
  }
  clock.stop();
  ASSERT_EQ(clock.times().size(), 2U);
  EXPECT_GT(clock.times()[0].processor_seconds, 1.5e-3 * kMilliseconds);
}

TEST(StageTime, OfNoLengthKeepsNoThreadBusy) { EXPECT_EQ(StageTime().busy_share(4), 0); }

}  // namespace
}  // namespace quarry
