#include "pipeline/improve/side_chains.hpp"

#include <algorithm>

#include "engine/geometry/segment.hpp"

namespace quarry {
namespace {

// How far off a vertex may lie, as shares of the edge's length: programs place what they halve along a curve
// to a millionth or so, and farther off lie sides of other courses.
constexpr double kLeastOff = 1e-5, kMostOff = 1e-3;

class ChainFinder {
 public:
  ChainFinder(const Mesh& mesh, double tolerance) : mesh_(mesh), tolerance_(tolerance) {}

  // The vertices from one end of the edge to the other along sides on it; just the first if there is no such
  // chain.
  [[nodiscard]] const std::vector<VertexId>& follow(const TaggedEdge& edge) {
    from_ = mesh_.point(edge.a);
    to_ = mesh_.point(edge.b);
    const double length = distance(from_, to_);
    const double off = std::clamp(tolerance_, kLeastOff * length, kMostOff * length);
    squared_off_ = off * off;
    chain_.assign(1, edge.a);
    for (double along = 0; chain_.back() != edge.b;) {
      const VertexId next = next_on_edge(chain_.back(), edge.b, along);
      if (!next.valid()) {
        chain_.resize(1);
        break;
      }
      chain_.push_back(next);
    }
    return chain_;
  }

 private:
  // The nearest vertex on the edge that a side leads to farther along than `along`, which follows.
  [[nodiscard]] VertexId next_on_edge(VertexId v, VertexId last, double& along) const {
    VertexId nearest;
    double least = 1;
    const auto look = [&](VertexId w) {
      if (w == last && !nearest.valid()) nearest = w;
      const Vec2 p = mesh_.point(w);
      const double t = projection_parameter(p, from_, to_);
      if (w == last || !(t > along && t < least) || squared_distance(p, from_, to_) > squared_off_) return;
      nearest = w;
      least = t;
    };
    for_each_side_around(mesh_, v, [&](SideId s) {
      look(mesh_.target(s));
      // Clockwise of the last face on the boundary is an edge that no side leaves by.
      const SideId back = mesh_.previous(s);
      if (!mesh_.neighbour(back).valid()) look(mesh_.origin(back));
    });
    along = least;
    return nearest;
  }

  const Mesh& mesh_;
  double tolerance_;
  Vec2 from_, to_;
  double squared_off_ = 0;
  std::vector<VertexId> chain_;
};

}  // namespace

std::vector<TaggedEdge> follow_sides(const Mesh& mesh, const std::vector<TaggedEdge>& tagged,
                                     double tolerance) {
  std::vector<TaggedEdge> sides;
  sides.reserve(tagged.size());
  ChainFinder finder(mesh, tolerance);
  for (const TaggedEdge& edge : tagged) {
    sides.push_back(edge);
    if (mesh.find_side(edge.a, edge.b).valid() || mesh.find_side(edge.b, edge.a).valid()) continue;
    const std::vector<VertexId>& chain = finder.follow(edge);
    if (chain.size() < 3) continue;
    sides.pop_back();
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) sides.push_back({chain[i], chain[i + 1], edge.number});
  }
  return sides;
}

}  // namespace quarry
