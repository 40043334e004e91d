#include "io/lines/segment_chains.hpp"

#include <algorithm>
#include <cstddef>

namespace quarry {
namespace {

constexpr std::uint32_t kNone = 0xffffffff;

class Chains {
 public:
  Chains(const std::vector<MarkedSegment>& segments, std::size_t points)
      : segments_(segments), around_(points), used_(segments.size(), false) {
    for (std::uint32_t i = 0; i < segments.size(); ++i) {
      for (const std::uint32_t point : {segments[i].from, segments[i].to}) {
        Around& around = around_[point];
        if (around.count < 2) around.segments[around.count] = i;
        ++around.count;
      }
    }
  }

  std::vector<SegmentChain> all() {
    std::vector<SegmentChain> chains;
    for (std::uint32_t i = 0; i < segments_.size(); ++i) {
      if (used_[i]) continue;
      used_[i] = true;
      // A closed chain is all ahead.
      const std::vector<std::uint32_t> ahead = walk(i, segments_[i].to);
      std::vector<std::uint32_t> points = walk(i, segments_[i].from);
      std::ranges::reverse(points);
      points.insert(points.end(), ahead.begin(), ahead.end());
      chains.push_back({std::move(points), segments_[i].marker});
    }
    return chains;
  }

 private:
  struct Around {
    std::uint32_t count = 0;
    std::uint32_t segments[2] = {kNone, kNone};
  };

  // The points from one end of a segment on.
  std::vector<std::uint32_t> walk(std::uint32_t segment, std::uint32_t point) {
    std::vector<std::uint32_t> points{point};
    for (;;) {
      const Around& around = around_[point];
      if (around.count != 2) return points;
      const std::uint32_t next = around.segments[0] == segment ? around.segments[1] : around.segments[0];
      if (used_[next] || segments_[next].marker != segments_[segment].marker) return points;
      used_[next] = true;
      point = segments_[next].from == point ? segments_[next].to : segments_[next].from;
      points.push_back(point);
      segment = next;
    }
  }

  const std::vector<MarkedSegment>& segments_;
  std::vector<Around> around_;
  std::vector<bool> used_;
};

}  // namespace

std::vector<SegmentChain> chain_segments(const std::vector<MarkedSegment>& segments, std::size_t points) {
  return Chains(segments, points).all();
}

}  // namespace quarry
