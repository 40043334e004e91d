#include "kernels/linework/conflicts.hpp"

#include <algorithm>

#include "engine/geometry/segment.hpp"
#include "engine/parallel/parallel.hpp"

namespace quarry::linework {
namespace {

constexpr std::size_t kQueriesPerChunk = 256;

// Runs find(begin, end, found) over chunks of [0, size) and returns all that was found in order.
template <class Found, class Find>
std::vector<Found> gather(std::size_t size, Find&& find) {
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
      kQueriesPerChunk);
}

// The edges near a segment, ascending: along a long one in short boxes, for the box of the whole would hold
// far too much. part: scratch.
void find_along(const Segment& segment, const SegmentGrid& grid, std::vector<std::uint32_t>& near,
                std::vector<std::uint32_t>& part, double snap) {
  const auto [a, b] = segment;
  const auto parts = static_cast<std::size_t>(std::clamp(distance(a, b) / (64 * snap), 1.0, 256.0));
  near.clear();
  for (std::size_t k = 0; k < parts; ++k) {
    Box2 box;
    box.extend(point_at(static_cast<double>(k) / static_cast<double>(parts), a, b));
    box.extend(point_at(static_cast<double>(k + 1) / static_cast<double>(parts), a, b));
    if (parts == 1) return grid.find(box, near);
    // Grown, as the points between the parts are rounded.
    grid.find(box.grown(snap), part);
    near.insert(near.end(), part.begin(), part.end());
  }
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
}

}  // namespace

std::vector<Hit> find_hits(const PathNetwork& network, const std::vector<Segment>& segments,
                           const SegmentGrid& grid, double snap) {
  return gather<Hit>(network.nodes.size(), [&](std::size_t begin, std::size_t end, std::vector<Hit>& hits) {
    std::vector<std::uint32_t> near;
    for (std::size_t n = begin; n < end; ++n) {
      const NodeId node(n);
      if (!network.used(node)) continue;
      const Vec2 p = network.nodes[node];
      grid.find(Box2{p, p}.grown(snap), near);
      for (const std::uint32_t e : near) {
        const Edge& edge = network.edges[e];
        if (edge.from == node || edge.to == node) continue;
        const double squared = squared_distance(p, segments[e].from, segments[e].to);
        if (squared < snap * snap) hits.push_back({node, e, squared});
      }
    }
  });
}

std::vector<Crossing> find_crossings(const std::vector<Segment>& segments, const SegmentGrid& grid,
                                     double snap) {
  return gather<Crossing>(
      segments.size(), [&](std::size_t begin, std::size_t end, std::vector<Crossing>& found) {
        std::vector<std::uint32_t> near;
        std::vector<std::uint32_t> part;
        for (std::size_t e = begin; e < end; ++e) {
          const auto [a, b] = segments[e];
          find_along(segments[e], grid, near, part, snap);
          for (const std::uint32_t f : near)
            if (f > e && meeting(a, b, segments[f].from, segments[f].to) == Meeting::kProper)
              found.push_back({static_cast<std::uint32_t>(e), f});
        }
      });
}

}  // namespace quarry::linework
