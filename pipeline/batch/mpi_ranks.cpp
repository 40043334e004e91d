// Rank 0 has the list; others ask it for the next job when they have a thread to spare, and tell it what
// became of each. All of it is messages of a few bytes that are looked for without waiting: one-sided calls
// would need the target to look into MPI just as often, and calls that wait would keep a processor busy which
// the workers need.
#include <algorithm>
#include <cstdlib>

#include <mpi.h>

#include "pipeline/batch/ranks.hpp"
#include "pipeline/batch/records.hpp"

namespace quarry {
namespace {

// Asked with nothing, answered with a place in the order (-1: none is left); records are texts; a rank that
// has nothing left to do says so, and leaves when it is told that nobody has.
enum Tag : int { kAsk = 1, kAnswer, kRecord, kIdle, kEnd };

// In which rank 0 answers: what a rank waits between two jobs.
constexpr int kAnswerMilliseconds = 2;

void send_empty(int rank, Tag tag) { MPI_Send(nullptr, 0, MPI_BYTE, rank, tag, MPI_COMM_WORLD); }

void receive_empty(int rank, Tag tag) {
  MPI_Recv(nullptr, 0, MPI_BYTE, rank, tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
}

class GivingShare : public JobShare {
 public:
  GivingShare(std::vector<std::size_t> order, int count) : JobShare(std::move(order)), count_(count) {}

  bool finish(bool idle) override {
    MPI_Status status;
    for (int there = 1; there != 0;) {
      MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &there, &status);
      if (there != 0) hear(status);
    }
    if (!idle || idle_ranks_ < count_ - 1) return false;
    for (int rank = 1; rank < count_; ++rank) send_empty(rank, kEnd);
    return true;
  }
  [[nodiscard]] int patience() const override { return kAnswerMilliseconds; }
  [[nodiscard]] int ranks() const override { return count_; }

 private:
  void hear(const MPI_Status& status) {
    const int rank = status.MPI_SOURCE;
    if (status.MPI_TAG == kRecord) {
      int size = 0;
      MPI_Get_count(&status, MPI_CHAR, &size);
      std::string text(static_cast<std::size_t>(size), '\0');
      MPI_Recv(text.data(), size, MPI_CHAR, rank, kRecord, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
      JobShare::add(parse_record(text));
    } else if (status.MPI_TAG == kAsk) {
      receive_empty(rank, kAsk);
      const long long place = next_ < order().size() ? static_cast<long long>(next_++) : -1;
      MPI_Send(&place, 1, MPI_LONG_LONG, rank, kAnswer, MPI_COMM_WORLD);
    } else {
      receive_empty(rank, kIdle);
      ++idle_ranks_;
    }
  }

  int count_;
  int idle_ranks_ = 0;
};

class AskingShare : public JobShare {
 public:
  AskingShare(std::vector<std::size_t> order, int rank, int count)
      : JobShare(std::move(order)), rank_(rank), count_(count) {}

  std::optional<std::size_t> take() override {
    if (over_) return std::nullopt;
    if (!asked_) {
      send_empty(0, kAsk);
      MPI_Irecv(&place_, 1, MPI_LONG_LONG, 0, kAnswer, MPI_COMM_WORLD, &answer_);
      asked_ = true;
    }
    int there = 0;
    MPI_Test(&answer_, &there, MPI_STATUS_IGNORE);
    if (there == 0) return std::nullopt;
    asked_ = false;
    over_ = place_ < 0;
    if (over_) return std::nullopt;
    next_ = static_cast<std::size_t>(place_) + 1;
    return order()[static_cast<std::size_t>(place_)];
  }
  [[nodiscard]] bool over() const override { return over_; }
  void add(const JobRecord& record) override {
    JobRecord told = record;
    told.rank = rank_;
    const std::string text = record_text(told);
    MPI_Send(text.data(), static_cast<int>(text.size()), MPI_CHAR, 0, kRecord, MPI_COMM_WORLD);
  }
  bool finish(bool idle) override {
    if (!idle) return false;
    if (!told_) {
      send_empty(0, kIdle);
      MPI_Irecv(nullptr, 0, MPI_BYTE, 0, kEnd, MPI_COMM_WORLD, &end_);
      told_ = true;
    }
    int there = 0;
    MPI_Test(&end_, &there, MPI_STATUS_IGNORE);
    return there != 0;
  }
  [[nodiscard]] int patience() const override { return asked_ ? 1 : 1000; }
  [[nodiscard]] int ranks() const override { return count_; }

 private:
  int rank_, count_;
  bool asked_ = false, over_ = false, told_ = false;
  long long place_ = -1;
  MPI_Request answer_ = MPI_REQUEST_NULL, end_ = MPI_REQUEST_NULL;
};

class MpiRanks : public Ranks {
 public:
  MpiRanks() {
    MPI_Init(nullptr, nullptr);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &count_);
    MPI_Comm machine = MPI_COMM_NULL;
    MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
    MPI_Comm_size(machine, &on_this_machine_);
    MPI_Comm_free(&machine);
  }
  ~MpiRanks() override { MPI_Finalize(); }

  [[nodiscard]] int rank() const override { return rank_; }
  [[nodiscard]] int count() const override { return count_; }
  [[nodiscard]] int on_this_machine() const override { return on_this_machine_; }
  std::string broadcast(std::string text) override {
    unsigned long long size = text.size();
    MPI_Bcast(&size, 1, MPI_UNSIGNED_LONG_LONG, 0, MPI_COMM_WORLD);
    text.resize(size);
    constexpr unsigned long long kPart = 1 << 30;  // counts are ints
    for (unsigned long long at = 0; at < size; at += kPart)
      MPI_Bcast(text.data() + at, static_cast<int>(std::min(kPart, size - at)), MPI_CHAR, 0, MPI_COMM_WORLD);
    return text;
  }
  std::unique_ptr<JobShare> share(std::vector<std::size_t> order) override {
    if (rank_ == 0) return std::make_unique<GivingShare>(std::move(order), count_);
    return std::make_unique<AskingShare>(std::move(order), rank_, count_);
  }
  void abort(int code) override {
    if (count_ > 1) MPI_Abort(MPI_COMM_WORLD, code);
  }

 private:
  int rank_ = 0, count_ = 1, on_this_machine_ = 1;
};

// Without a launcher, joining would only cost time.
bool is_launched() {
  for (const char* variable : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK"})
    if (std::getenv(variable) != nullptr) return true;
  return false;
}

}  // namespace

std::unique_ptr<Ranks> join_ranks() {
  if (is_launched()) return std::make_unique<MpiRanks>();
  return std::make_unique<Ranks>();
}

}  // namespace quarry
