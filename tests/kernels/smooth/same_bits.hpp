// The promise that every smoother keeps: places do not depend on the number of threads.
#pragma once

#include <vector>

#include <gtest/gtest.h>

#include "engine/parallel/parallel.hpp"
#include "tests/kernels/smooth/quads_with_lines.hpp"

namespace quarry::test {

// Calls smooth(QuadsWithLines&) on equal quads with 1, 2, 4 and 7 threads, of which others than the caller's
// have to take part, and expects the same bits.
template <class Smooth>
void expect_same_bits_on_threads(const Smooth& smooth) {
  std::vector<double> x, y;
  for (const int threads : {1, 2, 4, 7}) {
    parallel::with_threads(threads, [&] {
      QuadsWithLines quads = make_quads({.columns = 60, .rows = 40, .seed = 3});
      const parallel::ParticipationProbe probe;
      smooth(quads);
      if (threads == 1) {
        x = quads.mesh.xs();
        y = quads.mesh.ys();
        return;
      }
      EXPECT_GT(probe.chunks_of_other_threads(), 0U);
      EXPECT_EQ(quads.mesh.xs(), x);
      EXPECT_EQ(quads.mesh.ys(), y);
    });
  }
}

}  // namespace quarry::test
