#include "surface/feature/edge_chains.hpp"

#include <cstddef>

#include "surface/feature/point_incidence.hpp"

namespace quarry {

std::vector<EdgeChain> edge_chains(std::span<const std::array<std::uint32_t, 2>> edges,
                                   std::span<const std::uint8_t> node) {
  const PointIncidence at(node.size(), edges.size(), [&](std::size_t e) { return edges[e]; });
  std::vector<std::uint8_t> seen(edges.size(), 0);
  const auto follow = [&](std::uint32_t from, std::uint32_t edge) {
    EdgeChain chain{{from}, edge};
    std::uint32_t p = from;
    for (;;) {
      seen[edge] = 1;
      p = edges[edge][0] == p ? edges[edge][1] : edges[edge][0];
      chain.points.push_back(p);
      if (node[p] != 0 || p == from) break;
      const auto around = at.around(p);
      edge = around[0] == edge ? around[1] : around[0];
    }
    chain.ends = node[from] != 0 ? ChainEnds::kNodes : ChainEnds::kClosed;
    return chain;
  };
  std::vector<EdgeChain> chains;
  for (const bool closed : {false, true})
    for (std::uint32_t p = 0; p < node.size(); ++p)
      if (closed || node[p] != 0)
        for (const std::uint32_t e : at.around(p))
          if (seen[e] == 0) chains.push_back(follow(p, e));
  return chains;
}

}  // namespace quarry
