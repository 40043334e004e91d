// The features of a surface as curves between nodes: what vertices of a mesh of the surface are bound to.
// Nodes keep their bits; what lies on a curve slides along its polyline.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/id.hpp"
#include "engine/geometry/line_set.hpp"
#include "engine/mesh/constraint.hpp"
#include "surface/feature/feature_edges.hpp"
#include "surface/feature/polyline3.hpp"

namespace quarry {

struct FeatureCurve {
  std::vector<std::uint32_t> points;  // of the surface; a closed curve ends where it begins
  FeatureKind kind;
  std::int32_t line;  // of which it is a part; -1: of none
  Polyline3 course;
};

struct CurveNetwork {
  IdVector<NodeId, std::uint32_t> nodes;  // points of the surface, ascending
  IdVector<PieceId, FeatureCurve> curves;
  IdVector<NodeId, std::vector<PieceId>> curves_at;  // that end at a node, ascending

  // The point of the curve nearest to p.
  [[nodiscard]] Vec3 project(PieceId curve, Vec3 p) const { return curves[curve].course.nearest(p); }
  // The curve under a constrained edge whose ends have these supports and whose middle lies there. Between
  // two nodes: of the curves that join them the one that comes nearest to the middle. None where an end is
  // fixed to a place of its own. Takes time by the curves that end at the first node.
  [[nodiscard]] PieceId under_edge(Support a, Support b, Vec3 middle) const;
  // Whether an outer edge of which the same is known may be halved: not where sheets meet, as the others know
  // nothing of the new vertex, nor between places that are fixed.
  [[nodiscard]] bool may_halve_outer(Support a, Support b, Vec3 middle) const {
    const PieceId curve = under_edge(a, b, middle);
    return curve.valid() && curves[curve].kind != FeatureKind::kJoin;
  }
};

// Nodes are the points at which other than two features meet, or two of different kinds or lines, the
// corners of chains: places where a chain turns by the stated angle over the stated length, strongest first
// and none within that length of another node, and cusps, at which no curve ends
// (surface/feature/cusps.hpp); and the points that are named besides. A closed curve may have no node.
[[nodiscard]] CurveNetwork make_curve_network(const TriangleSurface& surface,
                                              std::span<const FeatureEdge> features,
                                              const FeatureOptions& options,
                                              std::span<const std::uint32_t> more_nodes = {});

}  // namespace quarry
