// On how many threads the benchmarks run.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

namespace quarry::bench {

// Numbers above 0 in a text with commas between them, as in "1,2,4"; others are left out.
[[nodiscard]] inline std::vector<std::int64_t> thread_counts_of(const std::string& text) {
  std::vector<std::int64_t> counts;
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, ',');)
    if (const std::int64_t count = std::atoll(word.c_str()); count > 0) counts.push_back(count);
  return counts;
}

// Those of the environment variable QUARRY_BENCH_THREADS, since benchmarks are registered before main() sees
// its arguments; 1 and 2 without it.
[[nodiscard]] inline std::vector<std::int64_t> thread_counts() {
  const char* text = std::getenv("QUARRY_BENCH_THREADS");
  return thread_counts_of(text != nullptr ? text : "1,2");
}

}  // namespace quarry::bench
