#include "pipeline/batch/time_left.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace quarry {
namespace {

std::vector<BatchJob> jobs_of_weights(const std::vector<double>& weights) {
  std::vector<BatchJob> jobs(weights.size());
  for (std::size_t i = 0; i < jobs.size(); ++i) jobs[i].weight = weights[i];
  return jobs;
}

JobRecord end_of(std::size_t job) {
  JobRecord record;
  record.job = job;
  return record;
}

TEST(TimeLeft, CountsJobsAndWeighsThem) {
  const std::vector<BatchJob> jobs = jobs_of_weights({6, 1, 3, 100});
  const std::vector<std::size_t> order = {0, 2, 1};  // the last one is not run
  TimeLeft left(jobs, order);
  EXPECT_EQ(left.share(), 0);
  EXPECT_EQ(left.text(5), "0/3");  // nothing is known of their speed yet
  left.add(end_of(0));
  EXPECT_DOUBLE_EQ(left.share(), 0.6);
  EXPECT_EQ(left.text(12), "1/3, 8.0 s");
  left.add(end_of(2));
  left.add(end_of(1));
  EXPECT_DOUBLE_EQ(left.share(), 1);
  EXPECT_EQ(left.text(20), "3/3");
}

TEST(TimeLeft, OfNoJobsIsAllDone) {
  const std::vector<BatchJob> jobs;
  EXPECT_EQ(TimeLeft(jobs, {}).share(), 1);
  EXPECT_EQ(TimeLeft(jobs, {}).text(1), "0/0");
}

TEST(DurationText, RoundsToWhatOneWantsToKnow) {
  EXPECT_EQ(duration_text(0.04), "0.0 s");
  EXPECT_EQ(duration_text(9.94), "9.9 s");
  EXPECT_EQ(duration_text(45.4), "45 s");
  EXPECT_EQ(duration_text(119), "119 s");
  EXPECT_EQ(duration_text(150), "2 min");
  EXPECT_EQ(duration_text(12600), "3.5 h");
}

}  // namespace
}  // namespace quarry
