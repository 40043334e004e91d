// Segments between numbered points as the longest chains that they make.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace quarry {

struct MarkedSegment {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  std::int64_t marker = 0;
};

struct SegmentChain {
  std::vector<std::uint32_t> points;  // the first is the last of a closed one
  std::int64_t marker = 0;
};

// A chain goes on through points at which exactly two segments meet, of the same marker. Chains come in the
// order of their first segments, and run as those do. points: how many there are.
[[nodiscard]] std::vector<SegmentChain> chain_segments(const std::vector<MarkedSegment>& segments,
                                                       std::size_t points);

}  // namespace quarry
