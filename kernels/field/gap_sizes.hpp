// Sizes that let elements fit between lines that run close to each other: local feature size, after Ruppert
// (J. Algorithms 18, 1995), for pairs of lines that face each other alone.
#pragma once

#include <vector>

#include "engine/geometry/line_set.hpp"
#include "kernels/field/graded_size.hpp"

namespace quarry {

struct GapOptions {
  double elements = 2;  // wanted across a gap; > 0
  // Gaps that take elements of the largest size ask for nothing; none are asked for below the smallest. In
  // input units, positive.
  double smallest = 0.1, largest = 1;
};

// Stretches of pieces from which another piece lies across, within 30 degrees of straight across, nearer than
// elements
// * largest: each with the width of the gap by the number of elements. Wedges of less than 30 degrees count
// as gaps that end. By piece, then along it; the same on any number of threads.
[[nodiscard]] std::vector<SizeSource> gap_sizes(const NodedLines& lines, const GapOptions& options);

}  // namespace quarry
