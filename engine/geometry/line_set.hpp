// Lines as they come from files, and lines as they leave cleaning: the two forms that cross folder borders.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/base/id.hpp"
#include "engine/geometry/box.hpp"
#include "engine/geometry/vec.hpp"

namespace quarry {

using LineId = Id<struct LineKind>;    // an input line, in reading order across all files
using PointId = Id<struct PointKind>;  // an input point, in reading order across all files
using NodeId = Id<struct NodeKind>;    // a point of the cleaned lines
using PieceId = Id<struct PieceKind>;  // a straight segment between two nodes of the cleaned lines

// What a file says of a line or a point beside where it lies; what it does not say is empty.
struct LineAttributes {
  std::string name;
  std::string set;
  std::string material;
  std::optional<double> aperture;  // in the file's unit, 0 or more

  [[nodiscard]] bool empty() const {
    return name.empty() && set.empty() && material.empty() && !aperture.has_value();
  }
  friend bool operator==(const LineAttributes&, const LineAttributes&) = default;
};

// Which plane the coordinates of a file lie in, as far as it says so.
struct CoordinateSystem {
  std::string
      definition;  // as the file has it: WKT, "EPSG:3067", "urn:ogc:def:crs:..."; "" if it says nothing
  bool geographic = false;  // coordinates are longitude and latitude in degrees
  bool assumed = false;     // the file says nothing; this is what its format means then

  friend bool operator==(const CoordinateSystem&, const CoordinateSystem&) = default;
};

// One line of the input: a LineString, a part of a MultiLineString or a ring of a polygon (closed: its last
// point equals its first). It keeps its number for good, even if it is dropped.
struct InputLine {
  static constexpr std::uint32_t kNoAttributes = std::numeric_limits<std::uint32_t>::max();

  std::vector<Vec2> points;
  std::vector<double> heights;               // one a point; empty if the file does not give all of them
  std::uint32_t file = 0;                    // index into LineSet::files
  std::uint32_t feature = 0;                 // number of the feature in its file, from 0
  bool polygon_ring = false;                 // a ring of a Polygon or MultiPolygon
  bool hole = false;                         // an inner ring
  std::uint32_t attributes = kNoAttributes;  // index into LineSet::attributes

  [[nodiscard]] bool closed() const { return points.size() > 2 && points.front() == points.back(); }
};

// A point of the input (a well, a sensor): it becomes a vertex. It keeps its number for good, even if it is
// dropped.
struct InputPoint {
  Vec2 place;
  std::optional<double> height = {};
  std::uint32_t file = 0;     // index into LineSet::files
  std::uint32_t feature = 0;  // number of the feature in its file, from 0
  std::uint32_t attributes = InputLine::kNoAttributes;
};

struct LineSet {
  std::vector<std::string> files;
  // One a file, or none.
  std::vector<CoordinateSystem> systems;
  // Shared by the lines and points of a feature.
  std::vector<LineAttributes> attributes;
  IdVector<LineId, InputLine> lines;
  IdVector<PointId, InputPoint> points;

  // Empty ones for a line of which the file says nothing.
  [[nodiscard]] LineAttributes attributes_of(LineId id) const { return attributes_at(lines[id].attributes); }
  [[nodiscard]] LineAttributes attributes_of(PointId id) const {
    return attributes_at(points[id].attributes);
  }

  [[nodiscard]] Box2 box() const {
    Box2 result;
    for (const InputLine& line : lines)
      for (const Vec2 point : line.points) result.extend(point);
    for (const InputPoint& point : points) result.extend(point.place);
    return result;
  }

 private:
  [[nodiscard]] LineAttributes attributes_at(std::uint32_t index) const {
    return index < attributes.size() ? attributes[index] : LineAttributes();
  }
};

// How far a LineSet was filled at some time.
struct LineSetMark {
  std::size_t lines = 0, points = 0;

  static LineSetMark of(const LineSet& set) { return {set.lines.size(), set.points.size()}; }
};

// What a piece is to the domain.
enum class PieceKindOf : std::uint8_t {
  kInterior,  // faces on both sides
  kOutline,   // on the outer boundary or the rim of a hole
};

// A straight segment between two nodes; pieces meet at nodes only, and no node lies nearer than the snapping
// distance to a piece that does not end there.
struct Piece {
  NodeId from;
  NodeId to;
  PieceKindOf kind = PieceKindOf::kInterior;
};

// Cleaned, noded line work. No two pieces join the same two nodes.
struct NodedLines {
  IdVector<NodeId, Vec2> nodes;
  IdVector<PieceId, Piece> pieces;
  // The input lines that run along each piece, ascending, in compressed rows: those of piece p are
  // line_numbers[line_begin[p] .. line_begin[p + 1]). Empty for an outline that is no input line.
  std::vector<std::uint32_t> line_begin;
  std::vector<LineId> line_numbers;

  // The input lines that run along a piece, ascending.
  [[nodiscard]] std::span<const LineId> numbers(PieceId piece) const {
    const std::uint32_t begin = line_begin[piece.value()];
    return std::span(line_numbers).subspan(begin, line_begin[piece.value() + 1] - begin);
  }
};

}  // namespace quarry
