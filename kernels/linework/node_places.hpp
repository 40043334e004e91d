// The places of the nodes while lines are noded: all of them apart, found by nearness, and who may still
// move.
#pragma once

#include <cstdint>
#include <vector>

#include "kernels/linework/node_buckets.hpp"
#include "kernels/linework/path_network.hpp"

namespace quarry::linework {

class NodePlaces {
 public:
  // apart: nodes nearer than this are one, in input units.
  NodePlaces(PathNetwork& network, double apart);

  // Nodes nearer than this are one.
  [[nodiscard]] double apart() const { return apart_; }
  [[nodiscard]] bool on_outline(NodeId node) const { return on_outline_[node.value()] != 0; }
  // Exactly one path ends at the node, and the node has not moved yet.
  [[nodiscard]] bool ends_one_path(NodeId node) const { return end_of_one_[node.value()] == 1; }
  // The node nearest to p among those that are not apart from it; none if all are.
  [[nodiscard]] NodeId nearest(Vec2 p) const { return buckets_.nearest(p); }
  // Calls visit(node, place) for all nodes nearer to the segment ab than apart(), and for others.
  template <class Visit>
  void visit_along(Vec2 a, Vec2 b, Visit&& visit) const {
    buckets_.visit_along(a, b, visit);
  }

  NodeId add(Vec2 p, bool outline);
  // The node nearest to p, or a new one. On the outline if asked for.
  NodeId at(Vec2 p, bool outline);

  // Moves and merges happen between these two; the second puts what became one into the network, and has the
  // paths through what moved checked anew.
  void begin_merging();
  void finish_merging();
  // Moves a node to a foot on an edge, once: on the outline whatever is near, elsewhere only if the foot is
  // apart from other nodes.
  void move(NodeId node, Vec2 foot, bool outline);
  // Moves a node to a place on the outline; nodes that are too near to that place become one with it, so that
  // nodes stay apart. Returns the node that stands there in the end.
  NodeId put_on_outline(NodeId node, Vec2 place);

 private:
  void put(NodeId node, Vec2 to);
  [[nodiscard]] NodeId root(NodeId node) const;

  PathNetwork& network_;
  NodeBuckets buckets_;
  std::vector<std::uint32_t> end_of_one_;  // how many paths end at the node; 0 once it has moved
  std::vector<std::uint8_t> on_outline_;
  double apart_;
  // Since begin_merging().
  bool merged_ = false;
  std::vector<NodeId> moved_;
  IdVector<NodeId, NodeId> substitute_;  // a node that merges into another: that other
};

}  // namespace quarry::linework
