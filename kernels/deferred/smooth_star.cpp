#include "kernels/deferred/smooth_star.hpp"

#include <algorithm>
#include <vector>

#include "kernels/local/star.hpp"

namespace quarry::deferred {
namespace {

// The mean of the link, weighted as the options say.
Vec2 mean_of_link(const Link& link, const State& state, Vec2 here) {
  Vec2 sum;
  double weights = 0;
  for (const Vec2 p : link.distinct()) {
    const Vec2 d = p - here;
    const double weight = state.options.inverse_length_weights ? 1 / length(d) : 1;
    sum = sum + weight * d;
    weights += weight;
  }
  return here + (1 / weights) * sum;
}

// The point of a piece nearest to p, constructed from the end that it is nearer to.
Vec2 point_on_piece(const State& state, PieceId piece, Vec2 p) {
  const Vec2 a = state.from(piece);
  const Vec2 d = state.to(piece) - a;
  const double t = std::clamp(dot(p - a, d) / squared_length(d), 0.0, 1.0);
  return a + t * d;
}

bool try_move(MeshEditor& editor, const State& state, const Link& link, VertexId v, Vec2 p, double before) {
  const double enough = state.options.guard_star_minimum ? before : state.options.min_quality;
  const double after = star_quality(link, p, enough);
  if (after <= 0 || after < enough) return false;
  editor.set_point(v, p);
  return true;
}

// True if the vertex moved by more than a small share of the spacing.
bool smooth_vertex(MeshEditor& editor, const State& state, VertexId v, Link& link) {
  const Support support = editor.get(state.tags.support, v);
  if (support.is_fixed()) return false;
  const Vec2 here = editor.point(v);
  link.gather(editor.mesh(), v);
  Vec2 p = mean_of_link(link, state, here);
  if (support.slides()) p = point_on_piece(state, support.piece(), p);
  const double enough = 1e-3 * state.options.spacing;
  if (squared_length(p - here) < enough * enough) return false;
  const double before = star_quality(link, here);
  if (try_move(editor, state, link, v, p, before)) return true;
  p = midpoint(here, p);
  if (support.slides()) p = point_on_piece(state, support.piece(), p);
  return try_move(editor, state, link, v, p, before);
}

}  // namespace

void smooth_star(MeshEditor& editor, const State& state, VertexId v) {
  thread_local std::vector<VertexId> vertices;
  thread_local Link link;
  vertices.assign(1, v);
  for_each_link_vertex(editor.mesh(), v, [&](VertexId u) {
    if (!editor.mesh().on_boundary(u)) vertices.push_back(u);
  });
  for (std::uint32_t sweep = 0; sweep < state.options.sweeps; ++sweep) {
    bool moved = false;
    for (const VertexId u : vertices) moved = smooth_vertex(editor, state, u, link) || moved;
    if (!moved) return;
  }
}

}  // namespace quarry::deferred
