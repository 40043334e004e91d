#include "pipeline/batch/worker.hpp"

#include <csignal>
#include <cstring>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "io/mapped_file.hpp"
#include "pipeline/batch/records.hpp"

namespace quarry {
namespace {

RunningChild start_worker(const BatchOptions& options, const BatchJob& job, int threads,
                          const std::string& log, const std::string& scratch) {
  std::error_code failure;
  std::filesystem::create_directory(scratch, failure);
  ChildStart start;
  start.words = options.worker;
  start.words.insert(start.words.end(), job.words.begin(), job.words.end());
  start.words.insert(start.words.end(), {"--threads", fmt::format("{}", threads)});
  start.out = "/dev/null";
  start.err = log;
  start.environment = {{"TMPDIR", scratch}};
  std::optional<RunningChild> child = RunningChild::start(start);
  if (!child)
    throw Error(ErrorKind::kOutput, fmt::format("{}: there is no such program", options.worker.front()));
  return std::move(*child);
}

// The last line that a worker has written, without what all lines start with.
std::string last_line(const std::string& log) {
  constexpr std::size_t kLongest = 400;
  try {
    const MappedFile file(log);
    std::string_view text = file.text();
    const std::size_t end = text.find_last_not_of("\r\n ");
    if (end == std::string_view::npos) return {};
    text = text.substr(0, end + 1);
    text.remove_prefix(text.find_last_of('\n') + 1);
    for (const std::string_view start : {"quarry: ", "error: "})
      if (text.starts_with(start)) text.remove_prefix(start.size());
    return std::string(text.substr(0, kLongest));
  } catch (const Error&) {
    return {};
  }
}

double megabytes(std::uint64_t bytes) { return static_cast<double>(bytes) / 1e6; }

}  // namespace

Worker::Worker(const BatchOptions& options, const BatchFolder& folder, const BatchJob& job,
               std::size_t number, int threads, const std::string& scratch)
    : options_(options),
      job_(job),
      number_(number),
      threads_(threads),
      log_(folder.log(job)),
      scratch_(scratch),
      child_(start_worker(options, job, threads, log_, scratch)) {}

Worker::~Worker() {
  if (child_.process() >= 0) {
    const int process = child_.process();
    // Waits until it is gone, so that it writes no more.
    { const RunningChild ending = std::move(child_); }
    remove_partial_outputs({&job_, 1}, process);
  }
  std::error_code ignored;
  std::filesystem::remove_all(scratch_, ignored);
}

double Worker::seconds() const { return std::chrono::duration<double>(Clock::now() - began_).count(); }

void Worker::keep_to_limits() {
  bytes_ = stopped_ ? 0 : child_.resident_bytes();
  if (options_.job_seconds && seconds() > *options_.job_seconds)
    stop(Outcome::kOutOfTime, fmt::format("not done after {:g} seconds", *options_.job_seconds));
  if (options_.job_bytes && bytes_ > *options_.job_bytes)
    stop(Outcome::kOutOfMemory, fmt::format("took more than {:.0f} MB", megabytes(*options_.job_bytes)));
}

void Worker::stop(Outcome outcome, std::string message) {
  if (stopped_) return;
  stopped_ = outcome;
  why_ = std::move(message);
  bytes_ = 0;
  child_.kill();
}

std::optional<JobRecord> Worker::ended() {
  const int process = child_.process();
  const std::optional<ChildEnd> end = child_.ended();
  if (!end) return std::nullopt;
  JobRecord record;
  record.job = number_;
  record.seconds = seconds();
  record.threads = threads_;
  record.exit_code = end->exit_code;
  record.cpu_seconds = end->cpu_seconds;
  record.peak_bytes = end->peak_bytes;
  judge(*end, record);
  if (end->signal != 0) remove_partial_outputs({&job_, 1}, process);
  return record;
}

void Worker::judge(const ChildEnd& end, JobRecord& record) const {
  if (end.exit_code == 0) {
    // It may have come to its end just as it was to be stopped.
    record.outcome = Outcome::kDone;
    add_report(job_, record);
  } else if (stopped_ && end.signal == SIGKILL) {
    record.outcome = *stopped_;
    record.message = why_;
  } else if (end.signal != 0) {
    record.outcome = Outcome::kCrashed;
    record.message =
        fmt::format("signal {} ({}){}", end.signal, ::strsignal(end.signal),
                    end.signal == SIGKILL ? ", as the system sends it where memory runs out" : "");
  } else {
    record.outcome = Outcome::kFailed;
    record.message = last_line(log_);
    if (record.message.empty()) record.message = fmt::format("exit code {}", end.exit_code);
  }
}

}  // namespace quarry
