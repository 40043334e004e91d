// The classes by which fracture people count the nodes of a network (Manzocchi 2002, "The connectivity of
// two-dimensional networks of spatially correlated fractures"; Sanderson & Nixon 2015, "The use of topology
// in fracture network characterization").
#pragma once

#include <cstdint>

#include "engine/geometry/line_set.hpp"

namespace quarry {

// By the interior pieces that end at a node. Where two do, in a bend of a line or where one line goes on as
// another, there is no node in this sense.
enum class NodeClass : std::uint8_t {
  kNone,
  kIsolated,  // I: one piece, the tip of a line within the domain
  kAbutting,  // Y: three, one line ends on another
  kCrossing,  // X: four or more
  kEdge,      // E: on the outline, any number; how the lines go on there is not known
};

// "I", "Y", "X", "E"; "" for none.
[[nodiscard]] const char* letter_of(NodeClass node_class);

struct NodeClassCounts {
  std::uint32_t isolated = 0;
  std::uint32_t abutting = 0;
  std::uint32_t crossing = 0;
  std::uint32_t edge = 0;
};

[[nodiscard]] IdVector<NodeId, NodeClass> classify_nodes(const NodedLines& lines);
[[nodiscard]] NodeClassCounts count_classes(const IdVector<NodeId, NodeClass>& classes);

}  // namespace quarry
