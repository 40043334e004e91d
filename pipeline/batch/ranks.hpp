// The processes that share the jobs of a batch: this one alone, or those that mpirun has started, on one
// machine or several that see the same files.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "pipeline/batch/job_share.hpp"

namespace quarry {

class Ranks {
 public:
  Ranks() = default;
  virtual ~Ranks() = default;
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  [[nodiscard]] virtual int rank() const { return 0; }
  [[nodiscard]] virtual int count() const { return 1; }
  [[nodiscard]] virtual int on_this_machine() const { return 1; }
  // What rank 0 says, to all; each calls it.
  [[nodiscard]] virtual std::string broadcast(std::string text) { return text; }
  // order: as in JobShare, the same on all ranks.
  [[nodiscard]] virtual std::unique_ptr<JobShare> share(std::vector<std::size_t> order) {
    return std::make_unique<JobShare>(std::move(order));
  }
  // Ends the other ranks, and this one with the exit code; does nothing where it is alone.
  virtual void abort(int /*code*/) {}
};

// Joins the others where a launcher of MPI has started this process and it was built with QUARRY_MPI; alone
// otherwise. To be called once.
[[nodiscard]] std::unique_ptr<Ranks> join_ranks();

}  // namespace quarry
