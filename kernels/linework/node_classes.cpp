#include "kernels/linework/node_classes.hpp"

#include "engine/geometry/pieces_around.hpp"
#include "engine/parallel/parallel.hpp"

namespace quarry {
namespace {

NodeClass class_of(const NodedLines& lines, std::span<const PieceId> around) {
  std::size_t interior = 0;
  for (const PieceId piece : around)
    if (lines.pieces[piece].kind == PieceKindOf::kInterior) ++interior;
  if (interior == 0) return NodeClass::kNone;
  if (interior < around.size()) return NodeClass::kEdge;
  if (interior == 1) return NodeClass::kIsolated;
  if (interior == 2) return NodeClass::kNone;
  return interior == 3 ? NodeClass::kAbutting : NodeClass::kCrossing;
}

}  // namespace

const char* letter_of(NodeClass node_class) {
  switch (node_class) {
    case NodeClass::kIsolated:
      return "I";
    case NodeClass::kAbutting:
      return "Y";
    case NodeClass::kCrossing:
      return "X";
    case NodeClass::kEdge:
      return "E";
    case NodeClass::kNone:
      break;
  }
  return "";
}

IdVector<NodeId, NodeClass> classify_nodes(const NodedLines& lines) {
  const PiecesAround around(lines);
  IdVector<NodeId, NodeClass> classes(lines.nodes.size());
  parallel::for_each(classes.size(),
                     [&](std::size_t n) { classes[NodeId(n)] = class_of(lines, around.at(NodeId(n))); });
  return classes;
}

NodeClassCounts count_classes(const IdVector<NodeId, NodeClass>& classes) {
  NodeClassCounts counts;
  for (const NodeClass node_class : classes) {
    counts.isolated += node_class == NodeClass::kIsolated ? 1 : 0;
    counts.abutting += node_class == NodeClass::kAbutting ? 1 : 0;
    counts.crossing += node_class == NodeClass::kCrossing ? 1 : 0;
    counts.edge += node_class == NodeClass::kEdge ? 1 : 0;
  }
  return counts;
}

}  // namespace quarry
