#include "kernels/linework/node_places.hpp"

namespace quarry::linework {

NodePlaces::NodePlaces(PathNetwork& network, double apart)
    : network_(network),
      buckets_(network.nodes.empty() ? Vec2{} : network.nodes[NodeId(0U)], apart),
      end_of_one_(network.nodes.size(), 0),
      on_outline_(network.nodes.size(), 0),
      apart_(apart) {
  for (const Path& path : network.paths) {
    for (const PathStep& step : path.steps)
      if (path.outline) on_outline_[step.node.value()] = 1;
    if (path.steps.size() < 2) continue;
    for (const PathStep& end : {path.steps.front(), path.steps.back()}) ++end_of_one_[end.node.value()];
  }
  buckets_.reserve(network.nodes.size());
  for (const NodeId node : IdRange<NodeId>(network.nodes.size())) buckets_.insert(node, network.nodes[node]);
}

NodeId NodePlaces::add(Vec2 p, bool outline) {
  const NodeId node = network_.nodes.push_back(p);
  buckets_.insert(node, p);
  substitute_.push_back(node);
  on_outline_.push_back(outline ? 1 : 0);
  end_of_one_.push_back(0);
  return node;
}

NodeId NodePlaces::at(Vec2 p, bool outline) {
  const NodeId near = nearest(p);
  const NodeId node = near.valid() ? near : add(p, outline);
  if (outline) on_outline_[node.value()] = 1;
  return node;
}

void NodePlaces::begin_merging() {
  merged_ = false;
  moved_.clear();
  substitute_ = IdVector<NodeId, NodeId>(network_.nodes.size());
  for (const NodeId node : IdRange<NodeId>(substitute_.size())) substitute_[node] = node;
}

void NodePlaces::finish_merging() {
  network_.uncheck_paths_through(moved_);
  if (!merged_) return;
  for (const NodeId node : IdRange<NodeId>(substitute_.size())) substitute_[node] = root(node);
  network_.substitute(substitute_);
}

void NodePlaces::move(NodeId node, Vec2 foot, bool outline) {
  if (root(node) != node) return;
  if (outline) {
    (void)put_on_outline(node, foot);
  } else if (!buckets_.nearest(foot, node).valid()) {
    end_of_one_[node.value()] = 0;
    put(node, foot);
  }
}

NodeId NodePlaces::put_on_outline(NodeId node, Vec2 place) {
  for (NodeId near = buckets_.nearest(place, node); near.valid(); near = buckets_.nearest(place, node)) {
    const bool stays = on_outline(near);
    const NodeId gone = stays ? node : near;
    merged_ = true;
    substitute_[gone] = stays ? near : node;
    buckets_.remove(gone);
    if (stays) return near;
  }
  on_outline_[node.value()] = 1;
  put(node, place);
  return node;
}

void NodePlaces::put(NodeId node, Vec2 to) {
  moved_.push_back(node);
  buckets_.remove(node);
  network_.nodes[node] = to;
  buckets_.insert(node, to);
}

NodeId NodePlaces::root(NodeId node) const {
  while (substitute_[node] != node) node = substitute_[node];
  return node;
}

}  // namespace quarry::linework
