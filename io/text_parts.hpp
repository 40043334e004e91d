// Long texts in parts that are read at the same time. Where a text is cut depends on the text alone, and of
// several errors the first in the text is the one that is told: results and messages are the same on any
// number of threads.
#pragma once

#include <atomic>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "engine/base/error.hpp"
#include "engine/parallel/parallel.hpp"

namespace quarry {

// The bytes [begin, end) of a text.
struct TextPart {
  std::size_t begin = 0;
  std::size_t end = 0;
};

// Parts of whole lines, in order, that cover the text from `begin` on. Each but the first starts with a line
// whose first word begins with one of the letters `starts` (any line, if that is empty): for formats whose
// records take several lines.
[[nodiscard]] std::vector<TextPart> split_lines(std::string_view text, std::size_t begin,
                                                std::string_view starts = {});

// Calls read(index) for each index of [0, count), in any order and at the same time. Where some throw an
// Error, the one of lowest index is thrown, and those above it may not be called: a file that is wrong in
// every part would take long to tell so of each.
template <class Read>
void read_parts(std::size_t count, Read&& read) {
  std::vector<std::optional<Error>> errors(count);
  std::atomic<std::size_t> lowest = count;
  parallel::for_each(
      count,
      [&](std::size_t i) {
        std::size_t seen = lowest.load(std::memory_order_relaxed);
        if (i > seen) return;
        try {
          read(i);
        } catch (const Error& error) {
          errors[i] = error;
          while (i < seen && !lowest.compare_exchange_weak(seen, i, std::memory_order_relaxed)) {
          }
        }
      },
      1);
  if (lowest < count) throw Error(*errors[lowest]);
}

}  // namespace quarry
