#include "pipeline/batch/supervisor.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <numeric>

#include <fmt/format.h>
#include <poll.h>

#include "engine/base/error.hpp"
#include "engine/base/stopwatch.hpp"
#include "io/scratch_folder.hpp"
#include "pipeline/batch/records.hpp"
#include "pipeline/batch/time_left.hpp"
#include "pipeline/batch/worker.hpp"

namespace quarry {
namespace {

// How often memory and time are looked at: touching fresh memory, a thread takes some 50 MB in that time.
constexpr int kLookMilliseconds = 20;

class Supervisor {
 public:
  Supervisor(const BatchOptions& options, const BatchFolder& folder, std::span<const BatchJob> jobs,
             JobShare& share)
      : options_(options), folder_(folder), jobs_(jobs), share_(share) {
    for (const std::size_t job : share.order()) weight_ += jobs[job].weight;
  }

  // One round: starts, waits a little, looks after limits, takes in what has ended. False once all is done.
  bool step() {
    start_workers();
    if (share_.finish(workers_.empty() && share_.over() && alone_.empty())) return false;
    wait();
    for (const auto& worker : workers_) worker->keep_to_limits();
    keep_to_memory();
    take_in();
    return true;
  }

 private:
  void start_workers() {
    while (free_threads() > 0 && !runs_alone_) {
      const std::optional<std::size_t> job = share_.take();
      if (!job) break;
      start(*job, std::min(threads_of(*job), free_threads()));
    }
    if (!workers_.empty()) return;
    runs_alone_ = share_.over() && !alone_.empty();
    if (!runs_alone_) return;
    const std::size_t job = alone_.back();
    alone_.pop_back();
    start(job, options_.threads);
  }

  void start(std::size_t job, int threads) {
    try {
      workers_.push_back(std::make_unique<Worker>(options_, folder_, jobs_[job], job, threads,
                                                  scratch_.file(fmt::format("{}", started_++))));
    } catch (const Error& error) {
      JobRecord record;
      record.job = job;
      record.outcome = Outcome::kFailed;
      record.exit_code = error.exit_code();
      record.message = error.message();
      record.threads = threads;
      conclude(record);
    }
  }

  // What became of a job is told even where it cannot be kept: then it will be done again.
  void conclude(JobRecord record) {
    try {
      write_record(folder_, jobs_[record.job], record, options_.version);
    } catch (const Error& error) {
      if (record.message.empty()) record.message = error.message();
    }
    share_.add(record);
  }

  [[nodiscard]] int free_threads() const {
    int free = options_.threads;
    for (const auto& worker : workers_) free -= worker->threads();
    return free;
  }

  // One, unless the job is so large that on one thread it would be the last to end, or too few jobs are left
  // for the threads that are free. No job's result depends on it.
  [[nodiscard]] int threads_of(std::size_t job) const {
    const double each = weight_ / (share_.ranks() * options_.threads);
    // Weights are guesses: a little more than its share is no reason.
    constexpr double kSlack = 0.25;
    const double wanted = std::ceil(jobs_[job].weight / each - kSlack);
    const std::size_t waiting = share_.left() / static_cast<std::size_t>(share_.ranks()) + 1;
    const int spare = free_threads() / static_cast<int>(std::min<std::size_t>(waiting, 1024));
    return std::clamp(std::max(static_cast<int>(std::min(wanted, 1024.0)), spare), 1, options_.threads);
  }

  void wait() const {
    std::vector<pollfd> descriptors;
    for (const auto& worker : workers_) descriptors.push_back({worker->descriptor(), POLLIN, 0});
    ::poll(descriptors.data(), descriptors.size(), std::min(kLookMilliseconds, share_.patience()));
  }

  void keep_to_memory() {
    const auto by_bytes = [](const auto& a, const auto& b) { return a->bytes() < b->bytes(); };
    for (;;) {
      std::uint64_t bytes = 0;
      for (const auto& worker : workers_) bytes += worker->bytes();
      if (bytes <= options_.memory_bytes) return;
      Worker& largest = **std::ranges::max_element(workers_, by_bytes);
      if (workers_.size() > 1) {
        largest.stop(Outcome::kNotRun, "");
      } else {
        largest.stop(Outcome::kOutOfMemory, fmt::format("took more than {:.0f} MB, alone",
                                                        static_cast<double>(options_.memory_bytes) / 1e6));
      }
    }
  }

  void take_in() {
    std::erase_if(workers_, [&](const auto& worker) {
      const std::optional<JobRecord> record = worker->ended();
      if (!record) return false;
      if (record->outcome == Outcome::kNotRun)
        alone_.push_back(record->job);
      else
        conclude(*record);
      return true;
    });
  }

  const BatchOptions& options_;
  const BatchFolder& folder_;
  std::span<const BatchJob> jobs_;
  JobShare& share_;
  double weight_ = 0;
  std::vector<std::unique_ptr<Worker>> workers_;
  std::vector<std::size_t> alone_;  // ended for memory; to be done again when nothing else runs
  bool runs_alone_ = false;
  std::size_t started_ = 0;
  ScratchFolder scratch_;
};

}  // namespace

BatchPlan plan_batch(std::span<const BatchJob> jobs, const BatchFolder& folder, const std::string& version,
                     const Progress& progress) {
  BatchPlan plan;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    progress.report("looking", static_cast<double>(i) / static_cast<double>(jobs.size()));
    std::optional<JobRecord> record = find_done(folder, jobs[i], version);
    if (!record) {
      plan.order.push_back(i);
      continue;
    }
    record->job = i;
    plan.done.push_back(std::move(*record));
  }
  std::ranges::stable_sort(plan.order,
                           [&](std::size_t a, std::size_t b) { return jobs[a].weight > jobs[b].weight; });
  return plan;
}

std::vector<JobRecord> run_batch(const BatchOptions& options, const BatchFolder& folder,
                                 std::span<const BatchJob> jobs, JobShare& share, const Progress& progress) {
  Supervisor supervisor(options, folder, jobs, share);
  std::vector<JobRecord> records;
  TimeLeft time(jobs, share.order());
  const Stopwatch watch;
  bool more = true;
  while (more && !progress.cancelled()) {
    more = supervisor.step();
    for (JobRecord& record : share.news()) {
      time.add(record);
      if (options.on_record) options.on_record(record);
      records.push_back(std::move(record));
    }
    if (!progress.cancelled()) progress.report(time.text(watch.seconds()), time.share());
  }
  return records;
}

}  // namespace quarry
