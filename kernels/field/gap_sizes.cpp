#include "kernels/field/gap_sizes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "engine/geometry/grid.hpp"
#include "engine/geometry/segment.hpp"
#include "engine/parallel/parallel.hpp"

namespace quarry {
namespace {

// The sine of the angle from straight across up to which a piece faces a place.
constexpr double kFacing = 0.5;

std::vector<Segment> segments_of(const NodedLines& lines) {
  std::vector<Segment> segments;
  segments.reserve(lines.pieces.size());
  for (const Piece& piece : lines.pieces)
    segments.push_back({lines.nodes[piece.from], lines.nodes[piece.to]});
  return segments;
}

class GapSearch {
 public:
  GapSearch(const std::vector<Segment>& segments, const SegmentGrid& grid, const GapOptions& options)
      : segments_(segments), grid_(grid), options_(options) {}

  void run(std::uint32_t piece, std::vector<SizeSource>& found) {
    const double total = distance(segments_[piece].from, segments_[piece].to);
    // Half of the largest size: nothing wide enough to matter hides between the middles of two stretches.
    const auto parts = std::max(1.0, std::ceil(2 * total / options_.largest));
    for (double i = 0; i < parts; ++i) look(piece, total, i / parts, (i + 1) / parts, found);
  }

 private:
  // The width changes no faster than the place: it is known well enough once a stretch is short beside the
  // size.
  void look(std::uint32_t piece, double total, double begin, double end, std::vector<SizeSource>& found) {
    const Segment& segment = segments_[piece];
    const auto point = [&](double share) { return segment.from + share * (segment.to - segment.from); };
    const double middle = 0.5 * (begin + end);
    const double size = width_at(piece, point(middle)) / options_.elements;
    const double half = 0.5 * (end - begin) * total;
    if (size - half / options_.elements >= options_.largest) return;
    if (half > std::max(size, options_.smallest)) {
      look(piece, total, begin, middle, found);
      look(piece, total, middle, end, found);
    } else if (size < options_.largest) {
      found.push_back({{point(begin), point(end)}, std::max(size, options_.smallest)});
    }
  }

  // The distance to the nearest piece that faces the place on a piece; more than matters if there is none.
  double width_at(std::uint32_t piece, Vec2 p) {
    const double most = options_.elements * options_.largest;
    for (double reach = options_.elements * options_.smallest;; reach = std::min(2 * reach, most)) {
      grid_.find(Box2{p, p}.grown(reach), ids_);
      double width = 2 * most;
      for (const std::uint32_t other : ids_)
        if (other != piece) width = std::min(width, width_between(piece, p, other));
      // Whatever is nearer than the reach was looked at.
      if (width <= reach || reach >= most) return width;
    }
  }

  // Infinite if the other piece does not face the place.
  [[nodiscard]] double width_between(std::uint32_t piece, Vec2 p, std::uint32_t other) const {
    const Segment& across = segments_[other];
    const Vec2 to = closest_point(p, across.from, across.to) - p;
    const double away = length(to);
    const auto faces = [&](const Segment& segment) {
      const Vec2 along = segment.to - segment.from;
      return std::abs(dot(to, along)) <= kFacing * away * length(along);
    };
    const bool facing = away > 0 && faces(segments_[piece]) && faces(across);
    return facing ? away : std::numeric_limits<double>::infinity();
  }

  const std::vector<Segment>& segments_;
  const SegmentGrid& grid_;
  const GapOptions& options_;
  std::vector<std::uint32_t> ids_;
};

}  // namespace

std::vector<SizeSource> gap_sizes(const NodedLines& lines, const GapOptions& options) {
  constexpr std::size_t kChunk = 64;
  const std::vector<Segment> segments = segments_of(lines);
  const SegmentGrid grid(segments, options.elements * options.largest);
  using Sources = std::vector<SizeSource>;
  return parallel::reduce_ordered(
      segments.size(), Sources(),
      [&](std::size_t begin, std::size_t end) {
        Sources found;
        GapSearch search(segments, grid, options);
        for (std::size_t i = begin; i < end; ++i) search.run(static_cast<std::uint32_t>(i), found);
        return found;
      },
      [](Sources a, Sources b) {
        a.insert(a.end(), b.begin(), b.end());
        return a;
      },
      kChunk);
}

}  // namespace quarry
