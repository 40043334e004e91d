#include "surface/join/join_chains.hpp"

#include <algorithm>
#include <span>

#include "surface/repair/surface_edges.hpp"

namespace quarry {
namespace {

class ChainWalk {
 public:
  ChainWalk(const RepairedSurface& repaired, const FeatureOptions& corners)
      : repaired_(repaired),
        corners_(corners),
        node_(repaired.surface.points.size(), 0),
        used_(2 * repaired.joins.size(), 0) {
    for (const SheetJoin& join : repaired.joins)
      for (std::size_t k = 0; k < 2; ++k) links_.push_back({join[k], join[1 - k]});
    std::sort(links_.begin(), links_.end());
    mark_nodes();
  }

  std::vector<JoinChain> run() {
    // First those that begin at a node; what is left is closed.
    for (const bool closed : {false, true})
      for (std::size_t k = 0; k < links_.size(); ++k)
        if (used_[k] == 0 && (closed || is_node(links_[k][0]))) add(walk(k));
    return std::move(chains_);
  }

 private:
  using Link = std::array<std::uint32_t, 2>;  // from, to

  [[nodiscard]] bool is_node(std::uint32_t p) const { return node_[p] != 0; }
  [[nodiscard]] std::size_t first_link(std::uint32_t from) const {
    return static_cast<std::size_t>(std::lower_bound(links_.begin(), links_.end(), Link{from, 0U}) -
                                    links_.begin());
  }

  void mark_nodes() {
    for (std::size_t k = 0; k < links_.size();) {
      const std::size_t begin = k;
      while (k < links_.size() && links_[k][0] == links_[begin][0]) ++k;
      if (k - begin != 2) node_[links_[begin][0]] = 1;
    }
    // At an edge that is no join sheets go on only from one triangle to another of its group.
    const TriangleSurface& surface = repaired_.surface;
    const SurfaceEdges edges(surface);
    for (std::size_t e = 0; e < edges.count(); ++e) {
      const std::span<const std::uint32_t> sides = edges.sides(e);
      const auto [a, b] = SurfaceEdges::ends(surface, sides[0]);
      const bool goes_on = sides.size() == 2 && surface.groups[sides[0] / 3] == surface.groups[sides[1] / 3];
      if (goes_on || std::binary_search(repaired_.joins.begin(), repaired_.joins.end(), join_of(a, b)))
        continue;
      node_[a] = node_[b] = 1;
    }
  }

  void use(std::size_t link) {
    used_[link] = 1;
    const Link back{links_[link][1], links_[link][0]};
    used_[static_cast<std::size_t>(std::lower_bound(links_.begin(), links_.end(), back) - links_.begin())] =
        1;
  }

  [[nodiscard]] JoinChain walk(std::size_t link) {
    JoinChain chain;
    chain.points = {links_[link][0], links_[link][1]};
    use(link);
    while (!is_node(chain.points.back()) && chain.points.back() != chain.points.front()) {
      std::size_t next = first_link(chain.points.back());
      if (used_[next] != 0) ++next;
      chain.points.push_back(links_[next][1]);
      use(next);
    }
    if (!is_node(chain.points.back())) chain.ends = ChainEnds::kClosed;
    return chain;
  }

  // In the pieces between its corners.
  void add(JoinChain chain) {
    std::vector<Vec3> places;
    for (const std::uint32_t p : chain.points) places.push_back(repaired_.surface.points[p]);
    std::vector<std::uint32_t> corners = find_corners(places, chain.ends, corners_);
    if (corners.empty()) {
      chains_.push_back(std::move(chain));
      return;
    }
    if (chain.ends == ChainEnds::kClosed) {
      chain.points.pop_back();
      std::rotate(chain.points.begin(), chain.points.begin() + corners[0], chain.points.end());
      chain.points.push_back(chain.points.front());
      const std::uint32_t first = corners[0];
      for (std::uint32_t& corner : corners) corner -= first;
      corners.erase(corners.begin());
    }
    std::uint32_t from = 0;
    corners.push_back(static_cast<std::uint32_t>(chain.points.size() - 1));
    for (const std::uint32_t to : corners) {
      chains_.push_back({{chain.points.begin() + from, chain.points.begin() + to + 1}, ChainEnds::kNodes});
      from = to;
    }
  }

  const RepairedSurface& repaired_;
  const FeatureOptions& corners_;
  std::vector<Link> links_;  // each join from both ends, ascending
  std::vector<std::uint8_t> node_, used_;
  std::vector<JoinChain> chains_;
};

}  // namespace

std::vector<JoinChain> join_chains(const RepairedSurface& repaired, const FeatureOptions& corners) {
  return ChainWalk(repaired, corners).run();
}

}  // namespace quarry
