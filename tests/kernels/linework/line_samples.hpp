// Line sets made by hand, and an independent look at what cleaning made of them.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "engine/geometry/grid.hpp"
#include "engine/geometry/segment.hpp"
#include "kernels/linework/clean_lines.hpp"

namespace quarry {

using Points = std::vector<Vec2>;

inline LineSet lines_of(const std::vector<Points>& lines) {
  LineSet set;
  set.files = {"made.geojson"};
  for (const Points& points : lines) {
    InputLine line;
    line.points = points;
    line.feature = static_cast<std::uint32_t>(set.lines.size());
    set.lines.push_back(line);
  }
  return set;
}

inline LineId line(std::uint32_t number) { return LineId(number); }

// A box around the lines that is far from all of them.
inline Outline wide_box(const LineSet& lines) {
  const Box2 box = lines.box();
  const Box2 wide = box.grown(0.5 * box.longer_side());
  Outline outline;
  outline.rigid = true;
  outline.rings.push_back(
      {{wide.low, {wide.high.x, wide.low.y}, wide.high, {wide.low.x, wide.high.y}, wide.low}, 0, LineId()});
  return outline;
}

inline constexpr CleanOptions kOptions{.snap = 0.05, .min_edge = 0.1, .tolerance = 0.05};

inline double budget(const CleanOptions& options) {
  return options.snap + options.min_edge + options.tolerance;
}

// The pieces that bear each line's number, as segments.
inline IdVector<LineId, std::vector<Segment>> pieces_by_line(const NodedLines& lines, std::size_t count) {
  IdVector<LineId, std::vector<Segment>> result(count);
  for (const PieceId p : IdRange<PieceId>(lines.pieces.size()))
    for (const LineId id : lines.numbers(p))
      result[id].push_back({lines.nodes[lines.pieces[p].from], lines.nodes[lines.pieces[p].to]});
  return result;
}

inline double distance_to(Vec2 p, const std::vector<Segment>& segments) {
  double best = std::numeric_limits<double>::infinity();
  for (const Segment& s : segments) best = std::min(best, squared_distance(p, s.from, s.to));
  return std::sqrt(best);
}

// Largest distance of points along `from` to `to`.
inline double one_way(const std::vector<Segment>& from, const std::vector<Segment>& to) {
  double worst = 0;
  for (const Segment& s : from)
    for (int k = 0; k <= 8; ++k) worst = std::max(worst, distance_to(point_at(k / 8.0, s.from, s.to), to));
  return worst;
}

inline std::vector<Segment> raw_segments(const InputLine& raw) {
  std::vector<Segment> result;
  for (std::size_t i = 0; i + 1 < raw.points.size(); ++i)
    result.push_back({raw.points[i], raw.points[i + 1]});
  return result;
}

// Every node has an even number of outline pieces: the outline is closed.
inline void expect_closed_outline(const NodedLines& lines) {
  std::vector<int> count(lines.nodes.size(), 0);
  for (const Piece& piece : lines.pieces) {
    if (piece.kind != PieceKindOf::kOutline) continue;
    ++count[piece.from.value()];
    ++count[piece.to.value()];
  }
  EXPECT_TRUE(std::all_of(count.begin(), count.end(), [](int pieces) { return pieces % 2 == 0; }));
}

// Every line that is neither dropped nor clipped lies within the budget of its pieces and they of it; dropped
// ones have no piece but a reason. Exactness is checked by clean_lines itself.
inline void expect_faithful(const LineSet& raw, const CleanedLines& cleaned) {
  const double near = budget(cleaned.options) * (1 + 1e-9);
  ASSERT_EQ(cleaned.ledger.size(), raw.lines.size());
  expect_closed_outline(cleaned.lines);
  const auto all_pieces = pieces_by_line(cleaned.lines, raw.lines.size());
  for (const LineId id : IdRange<LineId>(raw.lines.size())) {
    const LedgerEntry& entry = cleaned.ledger[id];
    const std::vector<Segment>& pieces = all_pieces[id];
    if (entry.fate == LineFate::kDropped) {
      EXPECT_TRUE(pieces.empty()) << id.value();
      EXPECT_FALSE(entry.why.empty()) << id.value();
      continue;
    }
    ASSERT_FALSE(pieces.empty()) << id.value();
    EXPECT_LE(entry.moved, near) << id.value();
    EXPECT_LE(one_way(pieces, raw_segments(raw.lines[id])), near) << id.value();
    if (entry.fate == LineFate::kClipped) continue;
    EXPECT_LE(one_way(raw_segments(raw.lines[id]), pieces), near) << id.value();
  }
}

// Cleaned within a wide box, and faithful.
inline CleanedLines cleaned(const LineSet& raw, const CleanOptions& options = kOptions) {
  CleanedLines result = clean_lines(raw, wide_box(raw), options);
  expect_faithful(raw, result);
  return result;
}

inline CleanedLines cleaned_in(const LineSet& raw, const Outline& outline) {
  CleanedLines result = clean_lines(raw, outline, kOptions);
  expect_faithful(raw, result);
  return result;
}

inline std::size_t interior_pieces(const NodedLines& lines) {
  return static_cast<std::size_t>(
      std::count_if(lines.pieces.begin(), lines.pieces.end(),
                    [](const Piece& piece) { return piece.kind == PieceKindOf::kInterior; }));
}

inline double outline_length(const NodedLines& lines) {
  double sum = 0;
  for (const Piece& piece : lines.pieces)
    if (piece.kind == PieceKindOf::kOutline) sum += distance(lines.nodes[piece.from], lines.nodes[piece.to]);
  return sum;
}

inline bool has_node(const NodedLines& lines, Vec2 p) {
  return std::find(lines.nodes.begin(), lines.nodes.end(), p) != lines.nodes.end();
}

}  // namespace quarry
