#include "kernels/linework/place_order.hpp"

#include <cassert>
#include <utility>

#include "engine/geometry/hilbert.hpp"
#include "engine/parallel/parallel.hpp"
#include "engine/parallel/sort.hpp"

namespace quarry::linework {
namespace {

// Returns the new number of each.
IdVector<NodeId, NodeId> order_nodes(IdVector<NodeId, Vec2>& nodes) {
  Box2 box;
  for (const Vec2 node : nodes.raw()) box.extend(node);
  std::vector<std::uint64_t> keys(nodes.size());
  parallel::for_each(keys.size(), [&](std::size_t n) { keys[n] = hilbert_key(nodes[NodeId(n)], box); });
  const std::vector<std::uint32_t> order = parallel::sorted_order(std::move(keys));
  IdVector<NodeId, NodeId> renamed(nodes.size());
  IdVector<NodeId, Vec2> placed(nodes.size());
  parallel::for_each(order.size(), [&](std::size_t i) {
    renamed[NodeId(order[i])] = NodeId(i);
    placed[NodeId(i)] = nodes[NodeId(order[i])];
  });
  nodes = std::move(placed);
  return renamed;
}

// Copied one after the other, so that the steps of paths that lie together do so in memory as well.
void order_paths(PathNetwork& network, const std::vector<std::uint32_t>& order) {
  std::vector<RawLine> raw(order.size());
  std::vector<Path> paths(order.size());
  std::size_t points = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    raw[i] = network.raw[order[i]];
    paths[i] = network.paths[order[i]];
    paths[i].raw = static_cast<std::uint32_t>(i);
    points += raw[i].points.size();
  }
  network.raw_points.reserve(points);
  for (RawLine& line : raw) {
    const std::size_t begin = network.raw_points.size();
    network.raw_points.insert(network.raw_points.end(), line.points.begin(), line.points.end());
    line.points = std::span(network.raw_points).subspan(begin);
  }
  network.raw = std::move(raw);
  network.paths = std::move(paths);
}

}  // namespace

void order_by_place(PathNetwork& network) {
  assert(network.raw.size() == network.paths.size() && network.edges.empty());
  const IdVector<NodeId, NodeId> renamed = order_nodes(network.nodes);
  // Those without a step come last.
  std::vector<std::uint64_t> begins(network.paths.size(), network.nodes.size());
  parallel::for_each(begins.size(), [&](std::size_t p) {
    std::vector<PathStep>& steps = network.paths[p].steps;
    for (PathStep& step : steps) step.node = renamed[step.node];
    if (!steps.empty()) begins[p] = steps.front().node.value();
  });
  order_paths(network, parallel::sorted_order(std::move(begins)));
}

}  // namespace quarry::linework
