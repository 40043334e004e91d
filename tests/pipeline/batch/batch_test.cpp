// A batch with a script as its worker, which crashes, hangs and takes memory as the job asks.
#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "engine/base/error.hpp"
#include "io/scratch_folder.hpp"
#include "pipeline/batch/records.hpp"
#include "pipeline/batch/supervisor.hpp"
#include "pipeline/report/input_hash.hpp"

namespace quarry {
namespace {

// WHAT OUT REPORT ... --threads N: does what the first word says and writes the two files.
constexpr const char* kWorker = R"(
mesh() {
  echo mesh > "$2"
  echo "{\"input\": {\"files\": [1], \"hash\": \"$(cat "$2.hash")\"}, \"counts\": {\"quads\": 7, \"list\": [1, 2]}}" > "$3"
  echo "$1" >> "$2.runs"
}
case $1 in
  well) mesh "$@" ;;
  threads) while [ "$1" != --threads ]; do shift; done; echo "quarry: error: threads $2" >&2; exit 4 ;;
  fails) echo first >&2; echo "quarry: error: no good" >&2; exit 3 ;;
  crashes) echo half > "$2.$$.0.partial"; kill -SEGV $$ ;;
  hangs) echo half > "$2.$$.0.partial"; sleep 600 ;;
  hog) exec python3 -c 'import time
data = bytearray(300_000_000)
data[::4096] = b"1" * len(data[::4096])
time.sleep(600)' ;;
  once)
    echo "$1" >> "$2.runs"
    python3 -c 'import time
data = bytearray(150_000_000)
data[::4096] = b"1" * len(data[::4096])
time.sleep(2)' && mesh "$@" ;;
esac
)";

class Batch : public testing::Test {
 protected:
  Batch() {
    std::ofstream(scratch_.file("worker.sh")) << kWorker;
    options_.worker = {"sh", scratch_.file("worker.sh")};
    options_.version = "1";
    options_.threads = 2;
  }

  void add(const std::string& name, const std::string& what, double weight = 1) {
    BatchJob job;
    job.name = name;
    job.outputs = {scratch_.file(name + ".vtu"), scratch_.file(name + ".json")};
    job.report = job.outputs[1];
    job.words = {what, job.outputs[0], job.outputs[1]};
    job.inputs = {scratch_.file(name + ".in")};
    job.weight = weight;
    change_input(name, "abc");
    jobs_.push_back(job);
  }

  // The worker's idea of the hash of the input is the text that stands beside the output.
  void change_input(const std::string& name, const std::string& text) {
    std::ofstream(scratch_.file(name + ".in")) << text;
    std::ofstream(scratch_.file(name + ".vtu.hash")) << hash_files({scratch_.file(name + ".in")});
  }

  std::map<std::string, JobRecord> run(const Progress& progress = Progress()) {
    const BatchFolder folder(scratch_.file("out"));
    BatchPlan plan = plan_batch(jobs_, folder, options_.version, progress);
    JobShare share(plan.order);
    std::map<std::string, JobRecord> records;
    for (const JobRecord& record : plan.done) records[jobs_[record.job].name] = record;
    for (const JobRecord& record : run_batch(options_, folder, jobs_, share, progress)) {
      EXPECT_FALSE(records.contains(jobs_[record.job].name)) << "twice";
      records[jobs_[record.job].name] = record;
    }
    return records;
  }
  [[nodiscard]] std::string text(const std::string& name) const {
    std::ifstream file(scratch_.file(name));
    return {std::istreambuf_iterator<char>(file), {}};
  }
  [[nodiscard]] bool has_partial_files() const {
    for (const auto& entry : std::filesystem::directory_iterator(scratch_.file("")))
      if (entry.path().extension() == ".partial") return true;
    return false;
  }

  ScratchFolder scratch_;
  BatchOptions options_;
  std::vector<BatchJob> jobs_;
};

TEST_F(Batch, GoesOnAfterEveryWayToFail) {
  options_.job_seconds = 2;
  options_.job_bytes = 200'000'000;
  for (const char* what : {"crashes", "hangs", "hog", "fails"}) add(what, what);
  for (int i = 0; i < 12; ++i) add("well" + std::to_string(i), "well");
  auto records = run();
  ASSERT_EQ(records.size(), 16U);
  EXPECT_EQ(records["crashes"].outcome, Outcome::kCrashed);
  EXPECT_EQ(records["crashes"].exit_code, 128 + SIGSEGV);
  EXPECT_NE(records["crashes"].message.find("Segmentation"), std::string::npos) << records["crashes"].message;
  EXPECT_EQ(records["hangs"].outcome, Outcome::kOutOfTime);
  EXPECT_EQ(records["hog"].outcome, Outcome::kOutOfMemory);
  EXPECT_EQ(records["fails"].outcome, Outcome::kFailed);
  EXPECT_EQ(records["fails"].exit_code, 3);
  EXPECT_EQ(records["fails"].message, "no good");
  for (int i = 0; i < 12; ++i) {
    const JobRecord& record = records["well" + std::to_string(i)];
    EXPECT_EQ(record.outcome, Outcome::kDone) << record.message;
    EXPECT_EQ(record.elements, 7);
  }
  EXPECT_FALSE(has_partial_files());
}

TEST_F(Batch, SaysHowFarItIsAndHowLongTheRestTakes) {
  options_.threads = 1;
  for (const char* name : {"first", "second", "third"}) add(name, "well");
  std::vector<std::string> stages;
  std::vector<double> shares;
  (void)run(Progress(
      [&](std::string_view stage, double share) {
        stages.emplace_back(stage);
        shares.push_back(share);
      },
      nullptr));
  ASSERT_FALSE(stages.empty());
  EXPECT_EQ(stages.back(), "3/3");
  EXPECT_EQ(shares.back(), 1);
  const auto told = [&](const std::string& start) {
    return std::any_of(stages.begin(), stages.end(),
                       [&](const std::string& stage) { return stage.starts_with(start); });
  };
  EXPECT_TRUE(told("1/3, "));
  EXPECT_TRUE(told("2/3, "));
}

TEST_F(Batch, PassesOverWhatIsDoneUnlessSomethingChanged) {
  for (const char* name : {"same", "input", "option", "output", "bad"}) add(name, "well");
  jobs_[4].words[0] = "fails";
  (void)run();
  change_input("input", "abd");
  jobs_[2].words.push_back("--size=2");
  std::ofstream(scratch_.file("output.vtu")) << "touched";
  jobs_[4].words[0] = "well";
  auto records = run();
  EXPECT_EQ(records["same"].outcome, Outcome::kSkipped);
  EXPECT_EQ(records["same"].elements, 7);
  EXPECT_EQ(text("same.vtu.runs"), "well\n");
  for (const char* name : {"input", "option", "output", "bad"})
    EXPECT_EQ(records[name].outcome, Outcome::kDone) << name;
  for (auto& [name, record] : run()) EXPECT_EQ(record.outcome, Outcome::kSkipped) << name;
  options_.version = "2";
  for (auto& [name, record] : run()) EXPECT_EQ(record.outcome, Outcome::kDone) << name;
}

TEST_F(Batch, TakesABrokenRecordForNone) {
  add("job", "well");
  (void)run();
  for (const char* broken : {"", "{", "[]", "{\"outcome\": 3}", "{\"outcome\": \"done\"}"}) {
    std::ofstream(scratch_.file("out/batch/records/job.json")) << broken;
    EXPECT_EQ(run()["job"].outcome, Outcome::kDone) << broken;
  }
}

TEST_F(Batch, DoesAJobAgainAloneWhenAllTogetherTakeTooMuchMemory) {
  options_.memory_bytes = 250'000'000;
  for (const char* name : {"a", "b", "c"}) add(name, "once");
  auto records = run();
  ASSERT_EQ(records.size(), 3U);
  for (const char* name : {"a", "b", "c"})
    EXPECT_EQ(records[name].outcome, Outcome::kDone) << records[name].message;
  EXPECT_GT((text("a.vtu.runs") + text("b.vtu.runs") + text("c.vtu.runs")).size(),
            3 * std::string("once\nonce\n").size());
}

TEST_F(Batch, TellsAJobThatAloneTakesTooMuchMemory) {
  options_.memory_bytes = 200'000'000;
  add("hog", "hog");
  add("well", "well");
  auto records = run();
  EXPECT_EQ(records["hog"].outcome, Outcome::kOutOfMemory);
  EXPECT_EQ(records["well"].outcome, Outcome::kDone);
}

TEST_F(Batch, GivesALargeJobSeveralThreads) {
  options_.threads = 4;
  add("large", "threads", 50);
  for (int i = 0; i < 20; ++i) add("small" + std::to_string(i), "threads", 2);
  auto records = run();
  EXPECT_EQ(records["large"].message, "threads 2");
  EXPECT_EQ(records["small3"].message, "threads 1");
  jobs_.resize(1);
  EXPECT_EQ(run()["large"].message, "threads 4");
}

TEST_F(Batch, EndsItsWorkersWhenItIsInterrupted) {
  for (int i = 0; i < 4; ++i) add("hangs" + std::to_string(i), "hangs");
  add("well", "well", 10);
  CancellationToken token;
  options_.on_record = [&](const JobRecord&) { token.cancel(); };
  auto records = run(Progress({}, &token));
  EXPECT_EQ(records.size(), 1U);
  EXPECT_FALSE(has_partial_files());
}

TEST_F(Batch, TellsOfEachJobThatThereIsNoSuchWorker) {
  options_.worker = {"no_such_program_at_all"};
  add("a", "well");
  add("b", "well");
  auto records = run();
  for (const char* name : {"a", "b"}) {
    EXPECT_EQ(records[name].outcome, Outcome::kFailed);
    EXPECT_NE(records[name].message.find("no_such_program"), std::string::npos);
  }
}

TEST_F(Batch, SweepsUpAfterABatchThatWasKilled) {
  add("job", "well");
  std::ofstream(scratch_.file("job.vtu.123.0.partial")) << "half";
  std::ofstream(scratch_.file("other.vtu.123.0.partial")) << "not ours";
  remove_partial_outputs(jobs_, 0);
  EXPECT_FALSE(std::filesystem::exists(scratch_.file("job.vtu.123.0.partial")));
  EXPECT_TRUE(std::filesystem::exists(scratch_.file("other.vtu.123.0.partial")));
}

TEST_F(Batch, KeepsAnotherOneOutOfItsFolder) {
  const BatchFolder folder(scratch_.file("out"));
  {
    const BatchLock lock(folder);
    EXPECT_THROW(const BatchLock second(folder), Error);
  }
  const BatchLock free(folder);
}

TEST_F(Batch, HasATableOfAllJobs) {
  add("first", "fails");
  add("second", "well");
  std::vector<JobRecord> records;
  for (auto& [name, record] : run()) records.push_back(record);
  const std::string table = table_text(jobs_, records);
  EXPECT_NE(table.find("\nfirst   failed "), std::string::npos) << table;
  EXPECT_NE(table.find("  no good\nsecond  done "), std::string::npos) << table;
  const auto json = nlohmann::json::parse(table_json(jobs_, records));
  EXPECT_EQ(json["jobs"][0]["message"], "no good");
  EXPECT_EQ(json["counts"]["done"], 1);
  EXPECT_EQ(count_text(records), "1 done, 1 failed");
  for (const JobRecord& record : records)
    EXPECT_EQ(record_text(parse_record(record_text(record))), record_text(record));
}

}  // namespace
}  // namespace quarry
