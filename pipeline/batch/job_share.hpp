// Who does which job of a list: one process all of them, or several that share them (ranks.hpp).
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "pipeline/batch/job.hpp"

namespace quarry {

class JobShare {
 public:
  // order: the jobs to be done, as places in the list of all jobs, the first one first.
  explicit JobShare(std::vector<std::size_t> order) : order_(std::move(order)) {}
  virtual ~JobShare() = default;
  JobShare(const JobShare&) = delete;
  JobShare& operator=(const JobShare&) = delete;

  [[nodiscard]] const std::vector<std::size_t>& order() const { return order_; }
  // A job to be done here; none where there is none now. Whether one comes later tells over().
  [[nodiscard]] virtual std::optional<std::size_t> take() {
    if (over()) return std::nullopt;
    return order_[next_++];
  }
  [[nodiscard]] virtual bool over() const { return next_ == order_.size(); }
  // About how many jobs nobody has taken.
  [[nodiscard]] virtual std::size_t left() const { return order_.size() - next_; }

  // A job has ended here.
  virtual void add(const JobRecord& record) { records_.push_back(record); }
  // Hears what other processes have to say. idle: nothing is left to do here. True once nothing is left
  // anywhere.
  [[nodiscard]] virtual bool finish(bool idle) { return idle; }
  // Milliseconds that may pass until it is called again.
  [[nodiscard]] virtual int patience() const { return 1000; }
  // How many processes share the jobs.
  [[nodiscard]] virtual int ranks() const { return 1; }

  // Of jobs that have ended here, and that others have told of, since the last call.
  [[nodiscard]] std::vector<JobRecord> news() { return std::exchange(records_, {}); }

 protected:
  std::vector<JobRecord> records_;
  std::size_t next_ = 0;

 private:
  std::vector<std::size_t> order_;
};

}  // namespace quarry
