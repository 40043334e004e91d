// The paths of a network as linked steps, so that a node can leave them without touching the rest.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "kernels/linework/growing_rows.hpp"
#include "kernels/linework/path_network.hpp"

namespace quarry::linework {

class LinkedPaths {
 public:
  explicit LinkedPaths(PathNetwork& network);

  // Puts the paths back into the network.
  void write_back();

  // The steps at a node.
  [[nodiscard]] std::span<const std::uint32_t> at(NodeId node) const { return steps_at_.at(node.value()); }
  [[nodiscard]] std::uint32_t before(std::uint32_t step) const { return steps_[step].before; }
  [[nodiscard]] std::uint32_t after(std::uint32_t step) const { return steps_[step].after; }
  [[nodiscard]] NodeId node_before(std::uint32_t step) const { return steps_[steps_[step].before].node; }
  [[nodiscard]] NodeId node_after(std::uint32_t step) const { return steps_[steps_[step].after].node; }
  [[nodiscard]] double parameter(std::uint32_t step) const { return steps_[step].at; }
  [[nodiscard]] bool is_end(std::uint32_t step) const {
    return steps_[step].before == kNone || steps_[step].after == kNone;
  }
  [[nodiscard]] std::uint32_t raw_number(std::uint32_t step) const {
    return network_.paths[steps_[step].path].raw;
  }
  [[nodiscard]] bool rigid(std::uint32_t step) const { return raw_of(step).rigid; }

  // Of the raw stretch between two steps of a path from the segment between their nodes.
  [[nodiscard]] double deviation(std::uint32_t from, std::uint32_t to) const;
  // The larger deviation of the edges before and after a step if it were at another node.
  [[nodiscard]] double deviation_if_moved(std::uint32_t step, NodeId node) const;

  [[nodiscard]] bool joined(NodeId a, NodeId b) const;
  // A node without edges that is no input point.
  [[nodiscard]] bool alone(NodeId node) const;
  // An input point is there.
  [[nodiscard]] bool marked(NodeId node) const;
  // Distinct, ascending.
  [[nodiscard]] std::vector<NodeId> neighbours(NodeId node) const;
  // One neighbour only.
  [[nodiscard]] bool dangles(NodeId node) const { return neighbours(node).size() == 1; }
  [[nodiscard]] bool on_outline(NodeId node) const;
  [[nodiscard]] bool joined_by_outline(NodeId a, NodeId b) const;
  [[nodiscard]] bool share_outline_neighbour(NodeId a, NodeId b) const;

  // Every path leaves the node out.
  void remove_node(NodeId node);
  // Every path that went through `gone` goes through `kept`.
  void merge(NodeId gone, NodeId kept);

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;
  struct Step {
    NodeId node;
    std::uint32_t path;
    std::uint32_t before;
    std::uint32_t after;
    double at;
  };

  [[nodiscard]] const RawLine& raw_of(std::uint32_t step) const;
  [[nodiscard]] bool outline(std::uint32_t step) const;
  [[nodiscard]] std::vector<NodeId> outline_neighbours(NodeId node) const;
  void unlink(std::uint32_t step);

  PathNetwork& network_;
  std::vector<Step> steps_;
  std::vector<std::uint32_t> first_;  // of each path
  GrowingRows steps_at_;
};

}  // namespace quarry::linework
