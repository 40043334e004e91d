#include "surface/join/divide_joins.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "surface/imprint/split_surface.hpp"
#include "surface/join/coarsen_joins.hpp"
#include "surface/join/join_chains.hpp"

namespace quarry {
namespace {

// A point of the curve this near to a wanted one takes its place, in wanted lengths.
constexpr double kNear = 0.05;
// Of a closed course.
constexpr double kFewestRound = 3;

class ChainDivider {
 public:
  ChainDivider(SplitSurface& surface, std::vector<std::uint8_t>& kept, double edge)
      : surface_(surface), kept_(kept), edge_(edge) {}

  void divide(const EdgeChain& chain) {
    std::vector<double> at{0};
    for (std::size_t i = 1; i < chain.points.size(); ++i)
      at.push_back(at.back() + length(surface_.point(chain.points[i]) - surface_.point(chain.points[i - 1])));
    const double fewest = chain.ends == ChainEnds::kClosed ? kFewestRound : 1;
    const double parts = std::max(fewest, std::round(at.back() / edge_));
    keep(chain.points.front());
    keep(chain.points.back());
    std::size_t i = 0;
    std::uint32_t from = chain.points.front();
    for (double part = 1; part < parts; ++part) {
      const double wanted = part / parts * at.back();
      while (i + 2 < at.size() && at[i + 1] <= wanted) from = chain.points[++i];
      from = point_at(from, chain.points[i + 1], wanted - at[i], at[i + 1] - wanted);
    }
  }

 private:
  void keep(std::uint32_t p) {
    kept_.resize(surface_.surface().points.size(), 0);
    kept_[p] = 1;
  }

  // On the join from a to b: so far from its beginning, of which a part may have been cut off, and its end.
  std::uint32_t point_at(std::uint32_t a, std::uint32_t b, double before, double behind) {
    const Vec3 to_end = surface_.point(b) - surface_.point(a);
    const double whole = length(to_end);
    std::uint32_t p = a;
    if (behind <= kNear * edge_)
      p = b;
    else if (before > kNear * edge_ && whole > behind)
      p = surface_.split_edge(a, b, surface_.point(b) - behind / whole * to_end);
    keep(p);
    // What is left of the join begins there, but at its end.
    return p == b ? a : p;
  }

  SplitSurface& surface_;
  std::vector<std::uint8_t>& kept_;
  double edge_;
};

}  // namespace

void divide_joins(RepairedSurface& repaired, const DivideJoinsOptions& options) {
  if (repaired.joins.empty()) return;
  std::vector<std::uint8_t> kept;
  const std::vector<EdgeChain> chains = join_chains(repaired, options.corners);
  SplitSurface surface(repaired);
  ChainDivider divider(surface, kept, options.edge);
  for (const EdgeChain& chain : chains) divider.divide(chain);
  surface.finish();
  kept.resize(repaired.surface.points.size(), 0);
  coarsen_joins(repaired, kept, options.deviation);
}

void halve_joins(RepairedSurface& repaired) {
  SplitSurface surface(repaired);
  for (const auto& [a, b] : std::vector<SheetJoin>(repaired.joins))
    surface.split_edge(a, b, 0.5 * (surface.point(a) + surface.point(b)));
  surface.finish();
}

}  // namespace quarry
