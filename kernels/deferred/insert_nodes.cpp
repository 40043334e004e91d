#include "kernels/deferred/insert_nodes.hpp"

#include <algorithm>

#include "kernels/deferred/locate.hpp"
#include "kernels/deferred/refine.hpp"
#include "kernels/deferred/smooth_star.hpp"
#include "kernels/local/split.hpp"
#include "kernels/local/star.hpp"

namespace quarry::deferred {

bool NodeInsertion::propose(const Mesh& mesh, NodeId node, Cavity& cavity, Plan& plan) const {
  const Vec2 p = state_.lines.nodes[node];
  const Location location = locate(mesh, state_.near_node[node], p);
  plan.vertex = mesh.origin(location.side);
  plan.fallback = false;
  if (location.place == Place::kOutside) {
    plan.step = Step::kConflict;
    cavity.claim(plan.vertex);
    return true;
  }
  if (location.place == Place::kVertex) return propose_take(mesh, mesh.origin(location.side), cavity, plan);

  const FaceId face = location.side.face();
  Attraction best;
  for (int k = 0; k < 3; ++k) {
    const VertexId v = mesh.corner(face, k);
    if (!state_.tags.support[v].is_free() || mesh.on_boundary(v)) continue;
    const Attraction attraction = AttractionMeter(mesh, v).to(p);
    if (attraction.better_than(best)) best = attraction;
  }
  const std::uint32_t tries = state_.node_tries[node];
  const double quality = state_.quality_limit(state_.options.min_quality, tries);
  if (acceptable(best, quality, state_.distortion_limit(tries)))
    return propose_attract(mesh, best, cavity, plan);
  if (tries < state_.options.max_tries && propose_refine(mesh, face, cavity, plan)) return true;
  return propose_fallback(mesh, node, location.side, location.place == Place::kEdge, best, cavity, plan);
}

bool NodeInsertion::propose_take(const Mesh& mesh, VertexId v, Cavity& cavity, Plan& plan) const {
  const Support support = state_.tags.support[v];
  plan.step = support.is_node() || support.slides() ? Step::kConflict : Step::kTake;
  plan.vertex = v;
  claim_star(mesh, v, cavity);
  return true;
}

bool NodeInsertion::propose_attract(const Mesh& mesh, const Attraction& best, Cavity& cavity,
                                    Plan& plan) const {
  plan.step = Step::kAttract;
  plan.vertex = best.vertex;
  claim_two_rings(mesh, best.vertex, cavity);
  return true;
}

bool NodeInsertion::propose_refine(const Mesh& mesh, FaceId face, Cavity& cavity, Plan& plan) const {
  const auto refinement = propose_refinement(mesh, state_, longest_side(mesh, face), cavity);
  if (!refinement) return false;
  plan.step = Step::kRefine;
  plan.side = refinement->side;
  plan.point = refinement->point;
  plan.support = refinement->support;
  return true;
}

// A free corner may still do; else the face that holds the node is split there, or the one of its edges where
// that leaves better triangles: a node beside an edge would leave a flat one. One of these is always
// possible: the node lies strictly inside the face, or on the edge.
bool NodeInsertion::propose_fallback(const Mesh& mesh, NodeId node, SideId side, bool on_edge,
                                     const Attraction& best, Cavity& cavity, Plan& plan) const {
  plan.fallback = true;
  if (tolerable(best)) return propose_attract(mesh, best, cavity, plan);
  const Vec2 p = state_.lines.nodes[node];
  plan.point = p;
  plan.support = Support::at(node);
  plan.side = side;
  plan.step = on_edge ? Step::kSplitEdge : Step::kSplitFace;
  if (on_edge && state_.tags.constrained(side)) {
    plan.step = Step::kConflict;
    claim_split_edge(mesh, side, cavity);
    cavity.will_create(0, 0);
    return true;
  }
  double worst = on_edge ? 2 : worst_of_face_split(mesh, side.face(), p);
  for (int k = 0; k < 3 && !on_edge; ++k) {
    const SideId edge(side.face(), k);
    if (state_.tags.constrained(edge) || !mesh.neighbour(edge).valid() || !can_split_edge(mesh, edge, p))
      continue;
    const double quality = worst_of_edge_split(mesh, edge, p);
    if (quality <= worst) continue;
    worst = quality;
    plan.side = edge;
    plan.step = Step::kSplitEdge;
  }
  if (plan.step == Step::kSplitFace)
    claim_split_face(mesh, side.face(), cavity);
  else
    claim_split_edge(mesh, plan.side, cavity);
  return true;
}

void NodeInsertion::apply(MeshEditor& editor, NodeId node, const Plan& plan, NewIds ids,
                          FollowUps<NodeId>& follow_ups) const {
  Events& events = state_.node_events[node];
  if (plan.fallback) ++events.fallbacks;
  switch (plan.step) {
    case Step::kConflict:
      state_.near_node[node] = plan.vertex;
      return;
    case Step::kTake:
      ++events.taken;
      editor.set(state_.tags.support, plan.vertex, Support::at(node));
      state_.vertex_of_node[node] = plan.vertex;
      return;
    case Step::kAttract:
      ++events.attractions;
      editor.set_point(plan.vertex, state_.lines.nodes[node]);
      editor.set(state_.tags.support, plan.vertex, Support::at(node));
      state_.vertex_of_node[node] = plan.vertex;
      smooth_star(editor, state_, plan.vertex);
      return;
    case Step::kRefine:
      ++events.splits;
      events.most_tries = std::max(events.most_tries, ++state_.node_tries[node]);
      state_.near_node[node] = plan.vertex;
      split_edge(editor, state_.tags, plan.side, plan.point, plan.support, ids);
      follow_ups.push_back(node);
      return;
    case Step::kSplitFace:
      state_.vertex_of_node[node] =
          split_face(editor, state_.tags, plan.side.face(), plan.point, plan.support, ids);
      return;
    case Step::kSplitEdge:
      state_.vertex_of_node[node] = split_edge(editor, state_.tags, plan.side, plan.point, plan.support, ids);
      return;
  }
}

}  // namespace quarry::deferred
