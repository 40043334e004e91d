#include "surface/feature/curve_network.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "surface/feature/corners.hpp"
#include "surface/feature/cusps.hpp"
#include "surface/feature/edge_chains.hpp"
#include "surface/feature/point_incidence.hpp"

namespace quarry {
namespace {

class CurveBuilder {
 public:
  CurveBuilder(const TriangleSurface& surface, std::span<const FeatureEdge> features,
               const FeatureOptions& options, std::span<const std::uint32_t> more_nodes)
      : surface_(surface),
        features_(features),
        options_(options),
        at_(surface.points.size(), features.size(), [&](std::size_t e) { return features[e].ends; }),
        node_(surface.points.size(), 0) {
    for (const FeatureEdge& feature : features) ends_.push_back(feature.ends);
    for (const std::uint32_t p : more_nodes) node_[p] = 1;
  }

  CurveNetwork run() {
    find_junctions();
    // Chains between junctions first: corners are looked for along them.
    std::vector<std::uint32_t> corners;
    for (const EdgeChain& chain : edge_chains(ends_, node_))
      for (const std::uint32_t corner : find_corners(points_of(chain.points), chain.ends, options_))
        corners.push_back(chain.points[corner]);
    for (const std::uint32_t corner : corners) node_[corner] = 1;
    for (const std::uint32_t cusp : find_cusps(surface_, bound(), options_.size)) node_[cusp] = 1;
    CurveNetwork network;
    std::vector<NodeId> node_at(node_.size());
    for (std::uint32_t p = 0; p < node_.size(); ++p)
      if (node_[p] != 0) node_at[p] = network.nodes.push_back(p);
    network.curves_at.resize(network.nodes.size());
    for (EdgeChain& chain : edge_chains(ends_, node_)) {
      Polyline3 course(points_of(chain.points));
      const FeatureEdge& first = features_[chain.first_edge];
      const NodeId from = node_at[chain.points.front()], to = node_at[chain.points.back()];
      const PieceId curve =
          network.curves.push_back({std::move(chain.points), first.kind, first.line, std::move(course)});
      if (from.valid()) network.curves_at[from].push_back(curve);
      if (to.valid() && to != from) network.curves_at[to].push_back(curve);
    }
    return network;
  }

 private:
  // By point, whether it lies on a feature.
  [[nodiscard]] std::vector<std::uint8_t> bound() const {
    std::vector<std::uint8_t> bound(node_.size());
    for (std::uint32_t p = 0; p < bound.size(); ++p) bound[p] = at_.around(p).empty() ? 0 : 1;
    return bound;
  }
  [[nodiscard]] std::vector<Vec3> points_of(std::span<const std::uint32_t> chain) const {
    std::vector<Vec3> points;
    for (const std::uint32_t p : chain) points.push_back(surface_.points[p]);
    return points;
  }

  void find_junctions() {
    for (std::uint32_t p = 0; p < node_.size(); ++p) {
      const auto edges = at_.around(p);
      if (edges.empty()) continue;
      const auto alike = [&](const FeatureEdge& a, const FeatureEdge& b) {
        return a.kind == b.kind && a.line == b.line;
      };
      if (edges.size() != 2 || !alike(features_[edges[0]], features_[edges[1]])) node_[p] = 1;
    }
  }

  const TriangleSurface& surface_;
  std::span<const FeatureEdge> features_;
  const FeatureOptions& options_;
  PointIncidence at_;  // features
  std::vector<std::array<std::uint32_t, 2>> ends_;
  std::vector<std::uint8_t> node_;
};

}  // namespace

PieceId CurveNetwork::under_edge(Support a, Support b, Vec3 middle) const {
  if (a.slides()) return a.piece();
  if (b.slides()) return b.piece();
  if (!a.is_node() || !b.is_node()) return {};
  const std::uint32_t from = nodes[a.node()];
  const std::uint32_t to = nodes[b.node()];
  PieceId best;
  double least = 0;
  for (const PieceId id : curves_at[a.node()]) {
    const std::vector<std::uint32_t>& points = curves[id].points;
    if (std::minmax(points.front(), points.back()) != std::minmax(from, to)) continue;
    const Vec3 d = project(id, middle) - middle;
    if (best.valid() && !(dot(d, d) < least)) continue;
    best = id;
    least = dot(d, d);
  }
  return best;
}

CurveNetwork make_curve_network(const TriangleSurface& surface, std::span<const FeatureEdge> features,
                                const FeatureOptions& options, std::span<const std::uint32_t> more_nodes) {
  return CurveBuilder(surface, features, options, more_nodes).run();
}

}  // namespace quarry
