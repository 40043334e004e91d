#include "pipeline/cli/node_file.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "engine/geometry/pieces_around.hpp"
#include "io/lines/geojson_writer.hpp"
#include "kernels/linework/node_classes.hpp"

namespace quarry::cli {
namespace {

std::string properties_of(const NodedLines& lines, std::span<const PieceId> around, NodeClass node_class) {
  std::size_t pieces = 0;
  std::vector<std::uint32_t> numbers;
  for (const PieceId piece : around) {
    if (lines.pieces[piece].kind != PieceKindOf::kInterior) continue;
    ++pieces;
    for (const LineId line : lines.numbers(piece)) numbers.push_back(line.value());
  }
  std::ranges::sort(numbers);
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return fmt::format("\"class\":\"{}\",\"pieces\":{},\"lines\":[{}]", letter_of(node_class), pieces,
                     fmt::join(numbers, ","));
}

}  // namespace

void write_node_file(const std::string& path, const NodedLines& lines, const std::string& system) {
  const IdVector<NodeId, NodeClass> classes = classify_nodes(lines);
  const PiecesAround around(lines);
  std::vector<NodeId> nodes;
  std::vector<Vec2> points;
  for (const NodeId node : IdRange<NodeId>(classes.size())) {
    if (classes[node] == NodeClass::kNone) continue;
    nodes.push_back(node);
    points.push_back(lines.nodes[node]);
  }
  write_points_geojson(
      path, points,
      [&](std::size_t i) { return properties_of(lines, around.at(nodes[i]), classes[nodes[i]]); }, system);
}

}  // namespace quarry::cli
