// The piece pass: each straight piece between two nodes becomes a chain of edges (Araujo & Celes 2014,
// section 3.1.3), one step a round: every piece has a front, the vertex up to which it is in the mesh.
#pragma once

#include "engine/operation/pass.hpp"
#include "kernels/deferred/attraction.hpp"
#include "kernels/deferred/state.hpp"

namespace quarry::deferred {

// Where a piece leaves the star of its front.
struct Exit {
  enum class Kind : std::uint8_t { kConnected, kVertex, kEdge, kNowhere } kind = Kind::kNowhere;
  SideId
      side;  // kConnected, kVertex: from the front to the vertex; kEdge: the crossed side, opposite the front
  Vec2 point{};  // kEdge: the crossing
};
[[nodiscard]] Exit find_exit(const Mesh& mesh, const State& state, PieceId piece);

class PieceInsertion {
 public:
  using Item = PieceId;
  enum class Step : std::uint8_t {
    kConnect,
    kTake,
    kAttract,
    kFlip,
    kRefine,
    kSplitHere,
    kBridge,
    kRebuild,
    kConflict
  };
  struct Plan {
    Step step;
    bool fallback;
    VertexId vertex;  // to take or attract
    SideId side;      // to flip or split
    Vec2 point;
    Support support;    // of the new vertex
    std::size_t faces;  // that a bridge crosses
  };

  explicit PieceInsertion(State& state) : state_(state) {}

  bool propose(const Mesh& mesh, PieceId piece, Cavity& cavity, Plan& plan) const;
  void apply(MeshEditor& editor, PieceId piece, const Plan& plan, NewIds ids,
             FollowUps<PieceId>& follow_ups) const;

 private:
  [[nodiscard]] Attraction best_attraction(const Mesh& mesh, PieceId piece, const Exit& exit) const;
  [[nodiscard]] bool flip_is_good(const Mesh& mesh, SideId side) const;
  bool propose_reached(const Mesh& mesh, PieceId piece, const Exit& exit, Cavity& cavity, Plan& plan) const;
  bool propose_refine(const Mesh& mesh, SideId side, Cavity& cavity, Plan& plan) const;
  bool propose_fallback(const Mesh& mesh, PieceId piece, const Exit& exit, const Attraction& best,
                        Cavity& cavity, Plan& plan) const;
  bool propose_bridge_or_rebuild(const Mesh& mesh, PieceId piece, Cavity& cavity, Plan& plan) const;
  void advance(MeshEditor& editor, PieceId piece, VertexId to, FollowUps<PieceId>& follow_ups) const;

  State& state_;
};

}  // namespace quarry::deferred
