// Parallel loops, ordered reductions and scans: the only folder that names oneTBB. Chunk borders are a
// function of the work alone, so every result is the same on any number of threads, doubles included.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace quarry::parallel {

// Items a chunk for bodies of a few nanoseconds. Part of the output wherever doubles are folded by chunk.
inline constexpr std::size_t kChunk = 4096;

namespace detail {

// A reference to a callable; the callable must outlive the call that it is passed to.
class ChunkBody {
 public:
  template <class Body>
    requires(!std::is_same_v<std::remove_cvref_t<Body>, ChunkBody>)
  explicit ChunkBody(Body& body)
      : object_(const_cast<void*>(static_cast<const void*>(std::addressof(body)))),
        call_([](void* object, std::size_t chunk) { (*static_cast<Body*>(object))(chunk); }) {}
  void operator()(std::size_t chunk) const { call_(object_, chunk); }

 private:
  void* object_;
  void (*call_)(void*, std::size_t);
};

void run_chunks(std::size_t chunk_count, ChunkBody body);
void run_with_threads(int threads, ChunkBody body);
void run_isolated(ChunkBody body);

}  // namespace detail

// Calls body(begin, end) for each chunk of [0, size). Chunks run in any order and at the same time.
template <class Body>
void for_each_chunk(std::size_t size, std::size_t chunk, Body&& body) {
  if (size == 0) return;
  auto run = [&](std::size_t index) {
    const std::size_t begin = index * chunk;
    body(begin, std::min(size, begin + chunk));
  };
  detail::run_chunks((size + chunk - 1) / chunk, detail::ChunkBody(run));
}

// Calls body(index) for each index of [0, size).
template <class Body>
void for_each(std::size_t size, Body&& body, std::size_t chunk = kChunk) {
  for_each_chunk(size, chunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) body(i);
  });
}

// Folds map(begin, end) of all chunks in index order: fold(fold(identity, chunk 0), chunk 1), ...
template <class T, class Map, class Fold>
T reduce_ordered(std::size_t size, T identity, Map&& map, Fold&& fold, std::size_t chunk = kChunk) {
  std::vector<T> parts((size + chunk - 1) / chunk, identity);
  for_each_chunk(size, chunk,
                 [&](std::size_t begin, std::size_t end) { parts[begin / chunk] = map(begin, end); });
  T total = std::move(identity);
  for (T& part : parts) total = fold(std::move(total), std::move(part));
  return total;
}

// Replaces each value by the sum of those before it and returns the sum of all. Integers only: a scan of
// doubles would depend on where it was cut.
template <class Integer>
  requires std::is_integral_v<Integer>
Integer exclusive_scan(std::span<Integer> values) {
  if (values.empty()) return 0;
  constexpr std::size_t kScanChunk = 16 * kChunk;
  std::vector<Integer> sums((values.size() + kScanChunk - 1) / kScanChunk, 0);
  for_each_chunk(values.size(), kScanChunk, [&](std::size_t begin, std::size_t end) {
    Integer sum = 0;
    for (std::size_t i = begin; i < end; ++i) sum = static_cast<Integer>(sum + values[i]);
    sums[begin / kScanChunk] = sum;
  });
  Integer total = 0;
  for (Integer& sum : sums) total = static_cast<Integer>(total + std::exchange(sum, total));
  for_each_chunk(values.size(), kScanChunk, [&](std::size_t begin, std::size_t end) {
    Integer sum = sums[begin / kScanChunk];
    for (std::size_t i = begin; i < end; ++i) sum = static_cast<Integer>(sum + std::exchange(values[i], sum));
  });
  return total;
}

// Indices i of [0, size) with keep(i), ascending. Each is asked about once.
template <class Keep>
std::vector<std::uint32_t> filter_indices(std::size_t size, Keep&& keep) {
  constexpr std::size_t kBits = 64;
  static_assert(kChunk % kBits == 0, "no two chunks write the same word");
  std::vector<std::uint64_t> kept_bits((size + kBits - 1) / kBits);
  std::vector<std::uint32_t> counts((size + kChunk - 1) / kChunk, 0);
  for_each_chunk(size, kChunk, [&](std::size_t begin, std::size_t end) {
    std::uint32_t count = 0;
    for (std::size_t first = begin; first < end; first += kBits) {
      std::uint64_t word = 0;
      for (std::size_t i = first; i < std::min(first + kBits, end); ++i)
        word |= (keep(i) ? std::uint64_t{1} : std::uint64_t{0}) << (i - first);
      kept_bits[first / kBits] = word;
      count += static_cast<std::uint32_t>(std::popcount(word));
    }
    counts[begin / kChunk] = count;
  });
  std::vector<std::uint32_t> kept(exclusive_scan(std::span(counts)));
  for_each_chunk(size, kChunk, [&](std::size_t begin, std::size_t end) {
    std::uint32_t at = counts[begin / kChunk];
    for (std::size_t first = begin; first < end; first += kBits)
      for (std::uint64_t word = kept_bits[first / kBits]; word != 0; word &= word - 1)
        kept[at++] = static_cast<std::uint32_t>(first) + static_cast<std::uint32_t>(std::countr_zero(word));
  });
  return kept;
}

// Runs job() with at most `threads` threads in every loop below it (0: as many as the machine has). More
// threads than cores are really started, so that tests can compare 1, 2, 4 and 7.
template <class Job>
void with_threads(int threads, Job&& job) {
  auto run = [&](std::size_t) { job(); };
  detail::run_with_threads(threads, detail::ChunkBody(run));
}

// Runs job(). While the loops in it wait for their last chunks, this thread takes up no chunk of a loop
// outside it: needed around loops in a chunk that uses memory kept for each thread.
template <class Job>
void isolated(Job&& job) {
  auto run = [&](std::size_t) { job(); };
  detail::run_isolated(detail::ChunkBody(run));
}

[[nodiscard]] int hardware_threads();

// For tests that compare thread counts: while alive, each chunk of every loop sleeps, so that other threads
// take part even on a loaded machine, and the chunks run by a thread other than the caller's are counted.
class ParticipationProbe {
 public:
  explicit ParticipationProbe(int sleep_microseconds = 30);
  ~ParticipationProbe();
  ParticipationProbe(const ParticipationProbe&) = delete;
  ParticipationProbe& operator=(const ParticipationProbe&) = delete;

  [[nodiscard]] std::uint64_t chunks() const;
  [[nodiscard]] std::uint64_t chunks_of_other_threads() const;
};

}  // namespace quarry::parallel
