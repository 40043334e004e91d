#include "kernels/deferred/state.hpp"

#include <algorithm>
#include <cmath>

#include "kernels/quality/element.hpp"

namespace quarry::deferred {
namespace {

// Directions of the pieces at a node, ascending by angle.
std::vector<std::pair<double, PieceId>> directions_at(const NodedLines& lines, const PieceFinder& finder,
                                                      NodeId node) {
  std::vector<std::pair<double, PieceId>> result;
  for (const PieceId id : finder.at(node)) {
    const Piece& piece = lines.pieces[id];
    const Vec2 d = lines.nodes[piece.from == node ? piece.to : piece.from] - lines.nodes[node];
    result.emplace_back(std::atan2(d.y, d.x), id);
  }
  std::sort(result.begin(), result.end());
  return result;
}

// Lo's measure of the isosceles triangle that fills a wedge.
double isosceles_quality(double angle) {
  const double t = std::min(angle, std::numbers::pi / 3);
  return lo_measure(Vec2{0, 0}, Vec2{1, 0}, Vec2{std::cos(t), std::sin(t)});
}

}  // namespace

State::State(const NodedLines& noded, const DeferredOptions& chosen, ConstraintTags constraint_tags)
    : lines(noded),
      options(chosen),
      tags(constraint_tags),
      finder(noded),
      floor_length(chosen.length_floor * chosen.spacing),
      vertex_of_node(noded.nodes.size()),
      near_node(noded.nodes.size()),
      front(noded.pieces.size()),
      min_quality(noded.pieces.size(), chosen.min_quality),
      node_tries(noded.nodes.size(), 0),
      piece_tries(noded.pieces.size(), 0),
      piece_steps(noded.pieces.size(), 0),
      node_events(noded.nodes.size()),
      piece_events(noded.pieces.size()) {
  if (!options.wedge_relative) return;
  // The best triangle in a wedge cannot be better than the isosceles one: a fixed limit would refine for
  // ever.
  for (const NodeId node : IdRange<NodeId>(lines.nodes.size())) {
    const auto directions = directions_at(lines, finder, node);
    const std::size_t count = directions.size();
    for (std::size_t i = 0; i < count && count > 1; ++i) {
      const double next = directions[(i + 1) % count].first + (i + 1 == count ? 2 * std::numbers::pi : 0);
      const double limit = 0.6 * isosceles_quality(next - directions[i].first);
      for (const PieceId piece : {directions[i].second, directions[(i + 1) % count].second})
        min_quality[piece] = std::min(min_quality[piece], limit);
    }
  }
}

std::uint32_t State::most_steps(PieceId piece) const {
  return 5000 +
         static_cast<std::uint32_t>(std::min(1e9, 5 * distance(from(piece), to(piece)) / floor_length));
}

double State::distortion_limit(std::uint32_t tries) const {
  return std::min(1.0, options.max_distortion * std::pow(1 / options.relaxation, tries));
}

double State::quality_limit(double base, std::uint32_t tries) const {
  if (tries <= options.patient_tries) return base;
  return base * std::pow(options.quality_relaxation, tries - options.patient_tries);
}

}  // namespace quarry::deferred
