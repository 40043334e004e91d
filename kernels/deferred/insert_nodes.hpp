// The node pass: every node of the lines becomes a vertex (Araujo & Celes 2014, section 3.1.2).
#pragma once

#include "engine/operation/pass.hpp"
#include "kernels/deferred/attraction.hpp"
#include "kernels/deferred/state.hpp"

namespace quarry::deferred {

// One step towards a node: take the vertex that lies there, attract one, refine, or put the node in by a
// split.
class NodeInsertion {
 public:
  using Item = NodeId;
  enum class Step : std::uint8_t { kTake, kAttract, kRefine, kSplitFace, kSplitEdge, kConflict };
  struct Plan {
    Step step;
    bool fallback;
    VertexId vertex;  // to take or attract; else a corner of the face that holds the node
    SideId side;      // to split
    Vec2 point;       // where the new vertex goes
    Support support;  // of the new vertex
  };

  explicit NodeInsertion(State& state) : state_(state) {}

  bool propose(const Mesh& mesh, NodeId node, Cavity& cavity, Plan& plan) const;
  void apply(MeshEditor& editor, NodeId node, const Plan& plan, NewIds ids,
             FollowUps<NodeId>& follow_ups) const;

 private:
  bool propose_take(const Mesh& mesh, VertexId v, Cavity& cavity, Plan& plan) const;
  bool propose_attract(const Mesh& mesh, const Attraction& best, Cavity& cavity, Plan& plan) const;
  bool propose_refine(const Mesh& mesh, FaceId face, Cavity& cavity, Plan& plan) const;
  bool propose_fallback(const Mesh& mesh, NodeId node, SideId side, bool on_edge, const Attraction& best,
                        Cavity& cavity, Plan& plan) const;

  State& state_;
};

}  // namespace quarry::deferred
