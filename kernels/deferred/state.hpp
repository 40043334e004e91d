// What all steps of deferred insertion share: the lines, what has been inserted of each, and the patience
// spent. Entries of a node or piece are written by the operation of that node or piece alone.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/geometry/line_set.hpp"
#include "engine/mesh/constraint.hpp"
#include "kernels/deferred/options.hpp"

namespace quarry::deferred {

// Events of one node or piece, summed up at the end.
struct Events {
  std::uint32_t attractions = 0, taken = 0, flips = 0, splits = 0, fallbacks = 0, rebuilt = 0, most_tries = 0;
};

struct State {
  State(const NodedLines& noded, const DeferredOptions& chosen, ConstraintTags constraint_tags);

  const NodedLines& lines;
  const DeferredOptions& options;
  ConstraintTags tags;
  PieceFinder finder;
  double floor_length;  // below it edges are split no more

  IdVector<NodeId, VertexId> vertex_of_node;
  IdVector<NodeId, VertexId> near_node;   // where the search for a node starts
  IdVector<PieceId, VertexId> front;      // the vertex up to which a piece is in the mesh
  IdVector<PieceId, double> min_quality;  // limit that follows the wedges at the ends of a piece
  IdVector<NodeId, std::uint32_t> node_tries;
  IdVector<PieceId, std::uint32_t> piece_tries;
  IdVector<PieceId, std::uint32_t> piece_steps;
  IdVector<NodeId, Events> node_events;
  IdVector<PieceId, Events> piece_events;

  [[nodiscard]] Vec2 from(PieceId piece) const { return lines.nodes[lines.pieces[piece].from]; }
  [[nodiscard]] Vec2 to(PieceId piece) const { return lines.nodes[lines.pieces[piece].to]; }

  // Steps after which only fallbacks are left to a piece: many times what its length can need.
  [[nodiscard]] std::uint32_t most_steps(PieceId piece) const;

  // Limits of an attraction after some tries.
  [[nodiscard]] double distortion_limit(std::uint32_t tries) const;
  [[nodiscard]] double quality_limit(double base, std::uint32_t tries) const;
};

}  // namespace quarry::deferred
