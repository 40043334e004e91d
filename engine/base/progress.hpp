// Progress and cancellation of long jobs. A job reports a stage and a share done; whoever asked for the job
// may cancel it from any thread (or from a signal handler), and the job ends with ErrorKind::kInterrupted.
#pragma once

#include <atomic>
#include <functional>
#include <string_view>

namespace quarry {

// Set from a signal handler or another thread; polled by jobs between bounded pieces of work.
class CancellationToken {
 public:
  void cancel() noexcept { cancelled_.store(true, std::memory_order_relaxed); }
  [[nodiscard]] bool cancelled() const noexcept { return cancelled_.load(std::memory_order_relaxed); }

 private:
  std::atomic<bool> cancelled_{false};
};

class Progress {
 public:
  using Sink = std::function<void(std::string_view stage, double share)>;

  Progress() = default;
  Progress(Sink sink, const CancellationToken* token) : sink_(std::move(sink)), token_(token) {}

  // Called by the thread that runs the job, never from inside a parallel loop. share in [0, 1].
  void report(std::string_view stage, double share) const;
  [[nodiscard]] bool cancelled() const { return token_ != nullptr && token_->cancelled(); }
  // Throws Error(kInterrupted) once cancelled.
  void throw_if_cancelled() const;

 private:
  Sink sink_;
  const CancellationToken* token_ = nullptr;
};

}  // namespace quarry
