#include "engine/base/progress.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "engine/base/error.hpp"

namespace quarry {
namespace {

TEST(Progress, HandsStagesToItsSink) {
  std::vector<std::string> stages;
  std::vector<double> shares;
  const auto sink = [&](std::string_view stage, double share) {
    stages.emplace_back(stage);
    shares.push_back(share);
  };
  const Progress progress(sink, nullptr);
  progress.report("insertion", 0.5);
  EXPECT_EQ(stages, std::vector<std::string>{"insertion"});
  EXPECT_EQ(shares, std::vector<double>{0.5});
}

TEST(Progress, WithoutSinkOrTokenIsSilent) {
  EXPECT_NO_THROW(Progress().report("insertion", 1));
  EXPECT_FALSE(Progress().cancelled());
}

TEST(CancellationToken, EndsTheJobAsInterruptedOnceSet) {
  CancellationToken token;
  const Progress progress({}, &token);
  EXPECT_NO_THROW(progress.throw_if_cancelled());
  token.cancel();
  EXPECT_TRUE(progress.cancelled());
  try {
    progress.report("insertion", 0);
    FAIL() << "the job went on";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInterrupted);
    EXPECT_EQ(error.exit_code(), 130);
  }
}

TEST(Error, CarriesItsKindAndItsLine) {
  const Error error(ErrorKind::kInput, "traces.geojson, feature 3: " + format_point(6'700'000.25, -0.5));
  EXPECT_EQ(error.exit_code(), 3);
  EXPECT_STREQ(error.what(), "traces.geojson, feature 3: (6700000.25, -0.5)");
}

}  // namespace
}  // namespace quarry
