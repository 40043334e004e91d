// What is found in many places, as one list.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/parallel/parallel.hpp"

namespace quarry::linework {

// Runs find(begin, end, found) over chunks of [0, size) and returns all that was found in order.
template <class Found, class Find>
std::vector<Found> gather(std::size_t size, Find&& find, std::size_t chunk = 256) {
  return parallel::reduce_ordered(
      size, std::vector<Found>(),
      [&](std::size_t begin, std::size_t end) {
        std::vector<Found> found;
        find(begin, end, found);
        return found;
      },
      [](std::vector<Found> all, std::vector<Found> part) {
        all.insert(all.end(), part.begin(), part.end());
        return all;
      },
      chunk);
}

}  // namespace quarry::linework
