#include "kernels/linework/conflicts.hpp"

#include <algorithm>
#include <tuple>

#include "engine/geometry/segment.hpp"
#include "kernels/linework/gather.hpp"

namespace quarry::linework {
namespace {

constexpr std::size_t kNodesPerChunk = 1024;
constexpr std::size_t kCellsPerChunk = 4096;

// Sorts by what key(found) gives and drops what was found twice.
template <class Found, class Key>
void sort_unique(std::vector<Found>& found, Key&& key) {
  std::sort(found.begin(), found.end(), [&](const Found& a, const Found& b) { return key(a) < key(b); });
  found.erase(
      std::unique(found.begin(), found.end(), [&](const Found& a, const Found& b) { return key(a) == key(b); }),
      found.end());
}

bool apart(double a, double b, double c, double d) {
  return std::max(a, b) < std::min(c, d) || std::max(c, d) < std::min(a, b);
}

// Cheaper than the exact answer, and no for most pairs.
bool boxes_apart(const Segment& s, const Segment& t) {
  return apart(s.from.x, s.to.x, t.from.x, t.to.x) || apart(s.from.y, s.to.y, t.from.y, t.to.y);
}

}  // namespace

std::vector<Hit> find_hits(const PathNetwork& network, const std::vector<Segment>& segments,
                           const SegmentGrid& grid, double snap) {
  // By cells, so that what one node needs from memory is there for the next.
  const std::vector<std::uint32_t> order = grid.by_cells(network.nodes.raw());
  std::vector<Hit> hits = gather<Hit>(
      order.size(),
      [&](std::size_t begin, std::size_t end, std::vector<Hit>& found) {
        for (std::size_t i = begin; i < end; ++i) {
          const NodeId node(order[i]);
          if (network.degree[node.value()] == 0) continue;
          const Vec2 p = network.nodes[node];
          const Box2 box = Box2{p, p}.grown(snap);
          grid.visit_near(box, [&](std::uint32_t e) {
            const auto [a, b] = segments[e];
            if (apart(a.x, b.x, box.low.x, box.high.x) || apart(a.y, b.y, box.low.y, box.high.y)) return;
            if (network.edges[e].from == node || network.edges[e].to == node) return;
            const double squared = squared_distance(p, a, b);
            if (squared < snap * snap) found.push_back({node, e, squared});
          });
        }
      },
      kNodesPerChunk);
  sort_unique(hits, [](const Hit& hit) { return std::pair(hit.node, hit.edge); });
  return hits;
}

std::vector<Crossing> find_crossings(const std::vector<Segment>& segments, const SegmentGrid& grid) {
  std::vector<Crossing> crossings = gather<Crossing>(
      grid.cell_count(),
      [&](std::size_t begin, std::size_t end, std::vector<Crossing>& found) {
        for (std::size_t cell = begin; cell < end; ++cell) {
          const std::span<const std::uint32_t> entries = grid.entries(cell);
          for (std::size_t i = 0; i < entries.size(); ++i) {
            const Segment s = segments[entries[i]];
            for (std::size_t k = i + 1; k < entries.size(); ++k) {
              const Segment& t = segments[entries[k]];
              if (!boxes_apart(s, t) && meeting(s.from, s.to, t.from, t.to) == Meeting::kProper)
                found.push_back({entries[i], entries[k]});
            }
          }
        }
      },
      kCellsPerChunk);
  // Two that cross may share more cells than the one that holds the crossing.
  sort_unique(crossings, [](const Crossing& crossing) { return std::pair(crossing.first, crossing.second); });
  return crossings;
}

}  // namespace quarry::linework
