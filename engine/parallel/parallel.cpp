#include "engine/parallel/parallel.hpp"

#include <atomic>
#include <chrono>
#include <thread>

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include "engine/parallel/loop_order.hpp"

#ifdef QUARRY_THREAD_SANITIZER
// What oneTBB does in its own library, such as freeing an exception, is not for the sanitizer to judge.
extern "C" const char* __tsan_default_suppressions() { return "called_from_lib:libtbb.so\n"; }
#endif

namespace quarry::parallel {
namespace {

struct Probe {
  std::atomic<int> sleep_microseconds{0};
  std::atomic<std::uint64_t> chunks{0};
  std::atomic<std::uint64_t> chunks_of_others{0};
  std::atomic<bool> waited{false};
};

Probe& probe() {
  static Probe instance;
  return instance;
}

// On a busy machine a worker may take long to wake up, and all chunks may be gone by then: the caller gives
// the first one some time, once a probe.
void wait_for_a_worker() {
  constexpr int kMostWaits = 2000;
  if (probe().waited.exchange(true) || tbb::this_task_arena::max_concurrency() < 2) return;
  for (int i = 0; i < kMostWaits && probe().chunks_of_others.load(std::memory_order_relaxed) == 0; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

void run_probed(std::size_t chunk, detail::ChunkBody body, std::thread::id caller) {
  const int sleep = probe().sleep_microseconds.load(std::memory_order_relaxed);
  if (sleep > 0) {
    probe().chunks.fetch_add(1, std::memory_order_relaxed);
    if (std::this_thread::get_id() == caller)
      wait_for_a_worker();
    else
      probe().chunks_of_others.fetch_add(1, std::memory_order_relaxed);
    std::this_thread::sleep_for(std::chrono::microseconds(sleep));
  }
  body(chunk);
}

}  // namespace

namespace detail {

void run_chunks(std::size_t chunk_count, ChunkBody body) {
  if (chunk_count == 1) {
    body(0);
    return;
  }
  const std::thread::id caller = std::this_thread::get_id();
  LoopOrder order;
  tbb::parallel_for(
      std::size_t{0}, chunk_count,
      [&](std::size_t chunk) {
        const LoopOrder::Chunk inside(order);
        run_probed(chunk, body, caller);
      },
      tbb::simple_partitioner());
}

void run_with_threads(int threads, ChunkBody body) {
  const int count = threads > 0 ? threads : hardware_threads();
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(count));
  tbb::task_arena arena(count);
  LoopOrder order;
  arena.execute([&] {
    const LoopOrder::Chunk inside(order);
    body(0);
  });
}

void run_isolated(ChunkBody body) {
  tbb::this_task_arena::isolate([&] { body(0); });
}

}  // namespace detail

int hardware_threads() { return tbb::info::default_concurrency(); }

ParticipationProbe::ParticipationProbe(int sleep_microseconds) {
  probe().chunks = 0;
  probe().chunks_of_others = 0;
  probe().waited = false;
  probe().sleep_microseconds = sleep_microseconds;
}

ParticipationProbe::~ParticipationProbe() { probe().sleep_microseconds = 0; }

std::uint64_t ParticipationProbe::chunks() const { return probe().chunks; }
std::uint64_t ParticipationProbe::chunks_of_other_threads() const { return probe().chunks_of_others; }

}  // namespace quarry::parallel
