#include "surface/feature/sharp_chains.hpp"

#include <algorithm>

#include "surface/feature/point_incidence.hpp"

namespace quarry {
namespace {

class ChainFilter {
 public:
  ChainFilter(std::span<const Vec3> points, std::span<const SharpEdge> edges,
              std::span<const std::uint8_t> bound)
      : points_(points),
        edges_(edges),
        bound_(bound),
        alive_(edges.size(), 1),
        at_(points.size(), edges.size(), [&](std::size_t e) { return edges[e].ends; }) {}

  std::vector<std::uint8_t> run(double shortest) {
    cut_loose_ends(0.5 * shortest);
    drop_parts(shortest);
    return std::move(alive_);
  }

 private:
  [[nodiscard]] std::size_t degree(std::uint32_t p) const {
    const auto edges = at_.around(p);
    return static_cast<std::size_t>(
        std::count_if(edges.begin(), edges.end(), [&](std::uint32_t e) { return alive_[e] != 0; }));
  }
  [[nodiscard]] double length_of(std::uint32_t e) const {
    return length(points_[edges_[e].ends[1]] - points_[edges_[e].ends[0]]);
  }
  [[nodiscard]] std::uint32_t other_end(std::uint32_t e, std::uint32_t p) const {
    return edges_[e].ends[0] == p ? edges_[e].ends[1] : edges_[e].ends[0];
  }

  // From a loose end to the first point with another number of edges than two.
  void cut_loose_ends(double shortest) {
    for (std::uint32_t p = 0; p < at_.points(); ++p) {
      if (bound_[p] != 0 || degree(p) != 1) continue;
      std::vector<std::uint32_t> chain;
      double sum = 0;
      std::uint32_t at = p;
      do {
        const auto edges = at_.around(at);
        const auto next = std::find_if(edges.begin(), edges.end(), [&](std::uint32_t e) {
          return alive_[e] != 0 && (chain.empty() || e != chain.back());
        });
        chain.push_back(*next);
        sum += length_of(*next);
        at = other_end(*next, at);
      } while (bound_[at] == 0 && degree(at) == 2 && sum < shortest);
      // Both ends loose: a chain of its own, which is judged as a whole.
      if (sum >= shortest || (bound_[at] == 0 && degree(at) == 1)) continue;
      for (const std::uint32_t e : chain) alive_[e] = 0;
    }
  }

  void drop_parts(double shortest) {
    std::vector<std::uint8_t> seen(edges_.size(), 0);
    for (std::uint32_t first = 0; first < edges_.size(); ++first) {
      if (alive_[first] == 0 || seen[first] != 0) continue;
      std::vector<std::uint32_t> part{first};
      seen[first] = 1;
      double sum = 0;
      bool strong = false;
      std::size_t anchors = 0;
      for (std::size_t i = 0; i < part.size(); ++i) {
        sum += length_of(part[i]);
        strong = strong || edges_[part[i]].strong;
        for (const std::uint32_t p : edges_[part[i]].ends) {
          anchors += bound_[p];
          for (const std::uint32_t e : at_.around(p)) {
            if (alive_[e] == 0 || seen[e] != 0) continue;
            seen[e] = 1;
            part.push_back(e);
          }
        }
      }
      if (strong && (sum >= shortest || anchors >= 2)) continue;
      for (const std::uint32_t e : part) alive_[e] = 0;
    }
  }

  std::span<const Vec3> points_;
  std::span<const SharpEdge> edges_;
  std::span<const std::uint8_t> bound_;
  std::vector<std::uint8_t> alive_;
  PointIncidence at_;
};

}  // namespace

std::vector<SharpEdge> keep_long_chains(std::span<const Vec3> points, std::vector<SharpEdge> edges,
                                        std::span<const std::uint8_t> bound, double shortest) {
  const std::vector<std::uint8_t> keep = ChainFilter(points, edges, bound).run(shortest);
  std::size_t kept = 0;
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (keep[e] != 0) edges[kept++] = edges[e];
  edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(kept), edges.end());
  return edges;
}

}  // namespace quarry
