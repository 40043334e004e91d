#include "kernels/deferred/insert_pieces.hpp"

#include <algorithm>
#include <cmath>

#include "engine/geometry/predicates.hpp"
#include "kernels/deferred/force.hpp"
#include "kernels/deferred/refine.hpp"
#include "kernels/deferred/smooth_star.hpp"
#include "kernels/local/flip.hpp"
#include "kernels/local/split.hpp"
#include "kernels/local/star.hpp"
#include "kernels/quality/element.hpp"

namespace quarry::deferred {
namespace {

// A target nearer to the front than this share of the crossing would make a short first edge.
constexpr double kNearestTarget = 0.6;
// A forced split is made if its triangles keep at least this height, as a share of the spacing: far above
// what rounding takes away. Else the piece is retriangulated in.
constexpr double kLowestForcedHeight = 1e-6;
// A bridge whose worst triangle is flatter than this, by Lo's measure, is not built.
constexpr double kWorstOfBridge = 1e-6;

// Marks an edge on both its faces.
void constrain(MeshEditor& editor, const State& state, VertexId a, VertexId b) {
  const Mesh& mesh = editor.mesh();
  const SideId s = mesh.find_side(a, b);
  const SideId r = s.valid() ? s : mesh.find_side(b, a);
  for (const SideId side : {r, mesh.neighbour(r)}) {
    if (!side.valid()) continue;
    const auto bits = static_cast<std::uint8_t>(state.tags.sides[side.face()] | (1U << side.index()));
    editor.set(state.tags.sides, side.face(), bits);
  }
}

}  // namespace

Exit find_exit(const Mesh& mesh, const State& state, PieceId piece) {
  const VertexId v = state.front[piece];
  const VertexId end = state.vertex_of_node[state.lines.pieces[piece].to];
  const Vec2 p = mesh.point(v);
  const Vec2 q = mesh.point(end);
  Exit exit;
  const SideId first = mesh.side_of(v);
  for (SideId s = first; s.valid();) {
    const SideId back = mesh.previous(s);
    const VertexId a = mesh.target(s);
    const VertexId b = mesh.origin(back);
    if (a == end) return {Exit::Kind::kConnected, s, q};
    if (b == end) return {Exit::Kind::kConnected, back, q};
    if (exit.kind == Exit::Kind::kNowhere) {
      const double right = orient2d(p, q, mesh.point(a));
      const double left = orient2d(p, q, mesh.point(b));
      const auto ahead = [&](VertexId u) { return dot(mesh.point(u) - p, q - p) > 0; };
      if (right == 0 && ahead(a))
        exit = {Exit::Kind::kVertex, s, mesh.point(a)};
      else if (left == 0 && ahead(b))
        exit = {Exit::Kind::kVertex, back, mesh.point(b)};
      else if (right < 0 && left > 0) {
        const double share = right / (right - left);
        exit = {Exit::Kind::kEdge, mesh.next(s), mesh.point(a) + share * (mesh.point(b) - mesh.point(a))};
      }
    }
    s = mesh.neighbour(back);
    if (s == first) break;
  }
  return exit;
}

Attraction PieceInsertion::best_attraction(const Mesh& mesh, PieceId piece, const Exit& exit) const {
  const Vec2 p = mesh.point(state_.front[piece]);
  const Vec2 d = state_.to(piece) - p;
  const double length2 = squared_length(d);
  const double crossing = dot(exit.point - p, d) / length2;
  Attraction best;
  for (const VertexId v : {mesh.origin(exit.side), mesh.target(exit.side)}) {
    if (!state_.tags.support[v].is_free() || mesh.on_boundary(v)) continue;
    const AttractionMeter meter(mesh, v);
    const double foot = dot(mesh.point(v) - p, d) / length2;
    const int targets = state_.options.several_targets ? 5 : 1;
    for (int i = 0; i < targets; ++i) {
      const double t = crossing + 0.25 * i * (foot - crossing);
      if (!(t >= kNearestTarget * crossing && t < 1)) continue;
      const Attraction attraction = meter.to(p + t * d);
      if (attraction.better_than(best)) best = attraction;
    }
  }
  return best;
}

bool PieceInsertion::flip_is_good(const Mesh& mesh, SideId side) const {
  if (!can_flip(mesh, side)) return false;
  const auto [a, b, c, d] = diamond_of(mesh, side);
  const Vec2 pa = mesh.point(a), pb = mesh.point(b), pc = mesh.point(c), pd = mesh.point(d);
  const double now = std::min(lo_measure(pa, pb, pc), lo_measure(pb, pa, pd));
  const double then = std::min(lo_measure(pc, pa, pd), lo_measure(pd, pb, pc));
  return then > state_.options.flip_quality || then > now;
}

bool PieceInsertion::propose(const Mesh& mesh, PieceId piece, Cavity& cavity, Plan& plan) const {
  plan.fallback = false;
  const Exit exit = find_exit(mesh, state_, piece);
  const VertexId front = state_.front[piece];
  if (exit.kind == Exit::Kind::kConnected || exit.kind == Exit::Kind::kVertex)
    return propose_reached(mesh, piece, exit, cavity, plan);
  if (exit.kind == Exit::Kind::kNowhere || !mesh.neighbour(exit.side).valid() ||
      state_.tags.constrained(exit.side)) {
    plan.step = Step::kConflict;
    cavity.claim(front);
    return true;
  }
  const std::uint32_t tries = state_.piece_tries[piece];
  if (state_.piece_steps[piece] > state_.most_steps(piece))
    return propose_fallback(mesh, piece, exit, Attraction(), cavity, plan);
  const Attraction best = best_attraction(mesh, piece, exit);
  const double quality = state_.quality_limit(state_.min_quality[piece], tries);
  if (acceptable(best, quality, state_.distortion_limit(tries))) {
    plan.step = Step::kAttract;
    plan.vertex = best.vertex;
    plan.point = best.target;
    claim_two_rings(mesh, best.vertex, cavity);
    return true;
  }
  if (state_.options.use_flips && flip_is_good(mesh, exit.side)) {
    plan.step = Step::kFlip;
    plan.side = exit.side;
    claim_flip(mesh, exit.side, cavity);
    return true;
  }
  if (tries < state_.options.max_tries && propose_refine(mesh, exit.side, cavity, plan)) {
    cavity.claim(front);
    return true;
  }
  return propose_fallback(mesh, piece, exit, best, cavity, plan);
}

// The end of the piece, or a vertex that happens to lie on it, is next to the front.
bool PieceInsertion::propose_reached(const Mesh& mesh, PieceId piece, const Exit& exit, Cavity& cavity,
                                     Plan& plan) const {
  const VertexId front = state_.front[piece];
  plan.vertex = mesh.origin(exit.side) == front ? mesh.target(exit.side) : mesh.origin(exit.side);
  claim_star(mesh, front, cavity);
  if (exit.kind == Exit::Kind::kConnected) {
    plan.step = Step::kConnect;
    return true;
  }
  const Support support = state_.tags.support[plan.vertex];
  const bool foreign = support.is_node() || (support.slides() && support.piece() != piece);
  plan.step = foreign ? Step::kConflict : Step::kTake;
  return true;
}

bool PieceInsertion::propose_refine(const Mesh& mesh, SideId crossed, Cavity& cavity, Plan& plan) const {
  const auto refinement = propose_refinement(mesh, state_, crossed, cavity);
  if (!refinement) return false;
  plan.step = Step::kRefine;
  plan.side = refinement->side;
  plan.point = refinement->point;
  plan.support = refinement->support;
  return true;
}

bool PieceInsertion::propose_fallback(const Mesh& mesh, PieceId piece, const Exit& exit,
                                      const Attraction& best, Cavity& cavity, Plan& plan) const {
  plan.fallback = true;
  if (tolerable(best)) {
    plan.step = Step::kAttract;
    plan.vertex = best.vertex;
    plan.point = best.target;
    claim_two_rings(mesh, best.vertex, cavity);
    return true;
  }
  // Splitting at the crossing leaves one crossed edge less, so it can be repeated only so often.
  if (can_split_edge(mesh, exit.side, exit.point) &&
      lowest_of_edge_split(mesh, exit.side, exit.point) > kLowestForcedHeight * state_.options.spacing) {
    plan.step = Step::kSplitHere;
    plan.side = exit.side;
    plan.point = exit.point;
    plan.support = Support::on(piece);
    claim_split_edge(mesh, exit.side, cavity);
    return true;
  }
  return propose_bridge_or_rebuild(mesh, piece, cavity, plan);
}

bool PieceInsertion::propose_bridge_or_rebuild(const Mesh& mesh, PieceId piece, Cavity& cavity,
                                               Plan& plan) const {
  plan.fallback = true;
  const Bridge bridge = best_bridge(mesh, state_, piece);
  if (bridge.worst > kWorstOfBridge) {
    plan.step = Step::kBridge;
    plan.point = bridge.target;
    plan.faces = bridge.faces;
    claim_bridge(mesh, state_, piece, bridge, cavity);
    return true;
  }
  plan.step = Step::kRebuild;
  claim_crossed(mesh, state_, piece, cavity);
  return true;
}

void PieceInsertion::advance(MeshEditor& editor, PieceId piece, VertexId to,
                             FollowUps<PieceId>& follow_ups) const {
  constrain(editor, state_, state_.front[piece], to);
  state_.front[piece] = to;
  state_.piece_tries[piece] = 0;
  if (to != state_.vertex_of_node[state_.lines.pieces[piece].to]) follow_ups.push_back(piece);
}

void PieceInsertion::apply(MeshEditor& editor, PieceId piece, const Plan& plan, NewIds ids,
                           FollowUps<PieceId>& follow_ups) const {
  Events& events = state_.piece_events[piece];
  if (plan.fallback) ++events.fallbacks;
  ++state_.piece_steps[piece];
  switch (plan.step) {
    case Step::kConflict:
      return;
    case Step::kConnect:
      advance(editor, piece, plan.vertex, follow_ups);
      return;
    case Step::kTake:
      ++events.taken;
      editor.set(state_.tags.support, plan.vertex, Support::on(piece));
      advance(editor, piece, plan.vertex, follow_ups);
      return;
    case Step::kAttract:
      ++events.attractions;
      editor.set_point(plan.vertex, plan.point);
      editor.set(state_.tags.support, plan.vertex, Support::on(piece));
      advance(editor, piece, plan.vertex, follow_ups);
      smooth_star(editor, state_, plan.vertex);
      return;
    case Step::kFlip:
      ++events.flips;
      flip_edge(editor, state_.tags, plan.side);
      follow_ups.push_back(piece);
      return;
    case Step::kRefine:
      ++events.splits;
      events.most_tries = std::max(events.most_tries, ++state_.piece_tries[piece]);
      split_edge(editor, state_.tags, plan.side, plan.point, plan.support, ids);
      follow_ups.push_back(piece);
      return;
    case Step::kSplitHere:
      advance(editor, piece, split_edge(editor, state_.tags, plan.side, plan.point, plan.support, ids),
              follow_ups);
      return;
    case Step::kBridge:
      advance(editor, piece, build_bridge(editor, state_, piece, {plan.faces, plan.point, 0}, ids),
              follow_ups);
      return;
    case Step::kRebuild: {
      ++events.rebuilt;
      const VertexId reached = rebuild_crossed(editor, state_, piece);
      if (!reached.valid()) return;
      if (state_.tags.support[reached].is_free())
        editor.set(state_.tags.support, reached, Support::on(piece));
      advance(editor, piece, reached, follow_ups);
      return;
    }
  }
}

}  // namespace quarry::deferred
