#include "io/lines/geojson_writer.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "engine/geometry/pieces_around.hpp"
#include "io/atomic_file.hpp"
#include "io/text_output.hpp"

namespace quarry {
namespace {

class Chains {
 public:
  explicit Chains(const NodedLines& lines)
      : lines_(lines), around_(lines), used_(lines.pieces.size(), false) {}

  // The chain through a piece that is in none yet, as nodes; empty if it is in one.
  std::vector<NodeId> take(PieceId seed) {
    if (used_[seed.value()]) return {};
    used_[seed.value()] = true;
    std::vector<NodeId> back = walk(seed, lines_.pieces[seed].from);
    std::reverse(back.begin(), back.end());
    const std::vector<NodeId> ahead = walk(seed, lines_.pieces[seed].to);
    back.insert(back.end(), ahead.begin(), ahead.end());
    return back;
  }

 private:
  std::vector<NodeId> walk(PieceId piece, NodeId node) {
    std::vector<NodeId> nodes{node};
    for (PieceId next = continuation(piece, node); next.valid(); next = continuation(next, node)) {
      used_[next.value()] = true;
      const Piece& step = lines_.pieces[next];
      node = step.from == node ? step.to : step.from;
      nodes.push_back(node);
    }
    return nodes;
  }

  // The piece that goes on from a node in the same way; none at junctions, ends and where a closed chain is
  // done.
  [[nodiscard]] PieceId continuation(PieceId piece, NodeId node) const {
    const std::span<const PieceId> around = around_.at(node);
    if (around.size() != 2) return {};
    const PieceId other = around[0] == piece ? around[1] : around[0];
    const bool same = lines_.pieces[other].kind == lines_.pieces[piece].kind &&
                      std::ranges::equal(lines_.numbers(other), lines_.numbers(piece));
    return same && !used_[other.value()] ? other : PieceId();
  }

  const NodedLines& lines_;
  PiecesAround around_;
  std::vector<bool> used_;
};

// A text in quotes. Bytes that are no UTF-8 are replaced.
std::string quoted(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

// Properties, each with a comma before it. numbers: of lines, or of points.
template <class Number>
std::string attribute_text(const LineSet* input, std::span<const Number> numbers) {
  if (input == nullptr) return {};
  for (const Number number : numbers) {
    const LineAttributes attributes = input->attributes_of(number);
    if (attributes.empty()) continue;
    std::string text;
    if (!attributes.name.empty()) text += fmt::format(",\"name\":{}", quoted(attributes.name));
    if (!attributes.set.empty()) text += fmt::format(",\"set\":{}", quoted(attributes.set));
    if (!attributes.material.empty()) text += fmt::format(",\"material\":{}", quoted(attributes.material));
    if (attributes.aperture) text += fmt::format(",\"aperture\":{}", *attributes.aperture);
    return text;
  }
  return {};
}

// properties: as the members of an object.
std::string point_feature(const std::string& properties, Vec2 p) {
  return fmt::format(
      "{{\"type\":\"Feature\",\"properties\":{{{}}},\"geometry\":{{\"type\":\"Point\",\"coordinates\":["
      "{},{}]}}}}",
      properties, p.x, p.y);
}

// Points by their nodes, each a feature.
std::vector<std::string> point_features(const NodedLines& lines, const GeojsonWriteOptions& options) {
  std::map<NodeId, std::vector<PointId>> points_at;
  for (const PointId id : IdRange<PointId>(options.points.size()))
    if (options.points[id].valid()) points_at[options.points[id]].push_back(id);
  std::vector<std::string> features;
  for (const auto& [node, points] : points_at) {
    std::vector<std::uint32_t> numbers;
    for (const PointId point : points) numbers.push_back(point.value());
    features.push_back(point_feature(fmt::format("\"points\":[{}]{}", fmt::join(numbers, ","),
                                                 attribute_text<PointId>(options.input, points)),
                                     lines.nodes[node]));
  }
  return features;
}

void begin_features(AtomicFile& file, const std::string& system) {
  file.write("{\"type\":\"FeatureCollection\",");
  if (!system.empty())
    file.write(fmt::format("\"crs\":{{\"type\":\"name\",\"properties\":{{\"name\":{}}}}},", quoted(system)));
  file.write("\"features\":[\n");
}

}  // namespace

void write_points_geojson(const std::string& path, std::span<const Vec2> points,
                          const std::function<std::string(std::size_t)>& properties,
                          const std::string& system) {
  AtomicFile file(path);
  begin_features(file, system);
  write_lines(file, points.size(), [&](TextLine text, std::size_t i) {
    text << point_feature(properties(i), points[i]) << (i + 1 < points.size() ? ",\n" : "\n");
  });
  file.write("]}\n");
  file.commit();
}

void write_lines_geojson(const std::string& path, const NodedLines& lines,
                         const GeojsonWriteOptions& options) {
  AtomicFile file(path);
  begin_features(file, options.system);
  Chains chains(lines);
  bool first = true;
  for (const PieceId id : IdRange<PieceId>(lines.pieces.size())) {
    const std::vector<NodeId> chain = chains.take(id);
    if (chain.empty()) continue;
    std::vector<std::uint32_t> numbers;
    for (const LineId line : lines.numbers(id)) numbers.push_back(line.value());
    fmt::memory_buffer text;
    fmt::format_to(std::back_inserter(text),
                   "{}{{\"type\":\"Feature\",\"properties\":{{\"lines\":[{}],\"kind\":\"{}\"{}}},",
                   first ? "" : ",\n", fmt::join(numbers, ","),
                   lines.pieces[id].kind == PieceKindOf::kOutline ? "outline" : "interior",
                   attribute_text<LineId>(options.input, lines.numbers(id)));
    fmt::format_to(std::back_inserter(text), "\"geometry\":{{\"type\":\"LineString\",\"coordinates\":[");
    for (std::size_t i = 0; i < chain.size(); ++i) {
      const Vec2 point = lines.nodes[chain[i]];
      fmt::format_to(std::back_inserter(text), "{}[{},{}]", i == 0 ? "" : ",", point.x, point.y);
    }
    fmt::format_to(std::back_inserter(text), "]}}}}");
    file.write(std::string_view(text.data(), text.size()));
    first = false;
  }
  for (const std::string& feature : point_features(lines, options)) {
    file.write((first ? "" : ",\n") + feature);
    first = false;
  }
  file.write("\n]}\n");
  file.commit();
}

}  // namespace quarry
