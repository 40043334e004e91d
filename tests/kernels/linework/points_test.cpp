// Points of the input among lines that are cleaned.
#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "engine/base/random.hpp"
#include "engine/geometry/segment.hpp"
#include "kernels/linework/clean_lines.hpp"
#include "tests/kernels/linework/line_samples.hpp"
#include "tests/kernels/linework/random_lines.hpp"

namespace quarry {
namespace {

LineSet with_points(LineSet lines, const std::vector<Vec2>& places) {
  for (const Vec2 place : places) lines.points.push_back({place});
  return lines;
}

Vec2 place_of(const CleanedLines& result, std::size_t point) {
  return result.lines.nodes[result.points[PointId(point)].node];
}

std::size_t pieces_at(const CleanedLines& result, std::size_t point) {
  const NodeId node = result.points[PointId(point)].node;
  std::size_t count = 0;
  for (const Piece& piece : result.lines.pieces) count += piece.from == node || piece.to == node ? 1U : 0U;
  return count;
}

TEST(CleaningPoints, APointByItselfIsANodeWithoutPieces) {
  const CleanedLines result = cleaned(with_points(lines_of({{{0, 0}, {8, 8}}}), {{2.125, 6.25}}));
  EXPECT_EQ(place_of(result, 0), (Vec2{2.125, 6.25}));
  EXPECT_EQ(pieces_at(result, 0), 0U);
  EXPECT_EQ(interior_pieces(result.lines), 1U);
}

TEST(CleaningPoints, ALineIsBentToAPointThatIsNear) {
  const CleanedLines result = cleaned(with_points(lines_of({{{0, 0}, {8, 0}, {8, 8}}}), {{4, 0.04}}));
  EXPECT_EQ(place_of(result, 0), (Vec2{4, 0.04}));
  EXPECT_EQ(pieces_at(result, 0), 2U);
  EXPECT_NEAR(result.ledger[line(0)].moved, 0.04, 1e-12);
}

TEST(CleaningPoints, AnEndIsJoinedToAPointAndNotThePointToTheEnd) {
  const CleanedLines result =
      cleaned(with_points(lines_of({{{0, 0}, {4, 4}}, {{0, 8}, {8, 8}}}), {{4.03, 4}}));
  EXPECT_EQ(place_of(result, 0), (Vec2{4.03, 4}));
  EXPECT_EQ(pieces_at(result, 0), 1U);
}

TEST(CleaningPoints, APointNearTheOutlineMovesOntoIt) {
  const CleanedLines result = cleaned_in(with_points(lines_of({{{0, 0}, {8, 8}}}), {{4, 7.98}}),
                                         box_outline(lines_of({{{0, 0}, {8, 8}}}), 0.05));
  EXPECT_EQ(place_of(result, 0), (Vec2{4, 8}));
  EXPECT_NEAR(result.points[PointId(0U)].moved, 0.02, 1e-12);
}

TEST(CleaningPoints, OnesWithinTheSnappingDistanceShareANode) {
  const CleanedLines result =
      cleaned(with_points(lines_of({{{0, 0}, {8, 8}}}), {{2, 6}, {2.02, 6}, {2.2, 6}}));
  EXPECT_EQ(result.points[PointId(0U)].node, result.points[PointId(1U)].node);
  EXPECT_NE(result.points[PointId(0U)].node, result.points[PointId(2U)].node);
  EXPECT_EQ(result.points[PointId(1U)].why, "one vertex for points 0, 1");
}

TEST(CleaningPoints, OnesOutsideTheOutlineAreDroppedWithTheReason) {
  const LineSet lines = lines_of({{{0, 0}, {8, 8}}});
  const CleanedLines result = cleaned_in(with_points(lines, {{4, 9}, {4, 6}}), box_outline(lines, 0.05));
  EXPECT_FALSE(result.points[PointId(0U)].node.valid());
  EXPECT_EQ(result.points[PointId(0U)].why, "lies outside the outline");
  EXPECT_TRUE(result.points[PointId(1U)].node.valid());
}

TEST(CleaningPoints, ABendAtAPointStays) {
  const CleanedLines result =
      cleaned(with_points(lines_of({{{0, 0}, {4, 0.01}, {8, 0}, {8, 8}}}), {{4, 0.01}}));
  EXPECT_EQ(place_of(result, 0), (Vec2{4, 0.01}));
  EXPECT_EQ(pieces_at(result, 0), 2U);
}

TEST(CleaningPoints, AShortLineBetweenTwoPointsStays) {
  const CleanedLines result =
      cleaned(with_points(lines_of({{{4, 4}, {4.08, 4}}, {{0, 0}, {8, 8.5}}}), {{4, 4}, {4.08, 4}}));
  EXPECT_EQ(place_of(result, 0), (Vec2{4, 4}));
  EXPECT_EQ(place_of(result, 1), (Vec2{4.08, 4}));
  EXPECT_EQ(pieces_at(result, 1), 1U);
}

TEST(CleaningPoints, PointsAloneAreCleanedInTheirBox) {
  const LineSet points = with_points({}, {{0, 0}, {8, 8}, {3, 5}});
  const CleanedLines result = cleaned_in(points, box_outline(points, 0.05));
  EXPECT_EQ(pieces_at(result, 0), 2U) << "a corner of the box";
  EXPECT_EQ(place_of(result, 2), (Vec2{3, 5}));
}

// Points anywhere, on lines, and a little beside ends and lines.
LineSet soup_with_points(std::uint64_t seed) {
  LineSet raw = soup(seed, {});
  const std::size_t lines = raw.lines.size();
  for (std::uint64_t i = 0; i < 30; ++i) {
    const auto draw = [&](std::uint64_t k) { return uniform01(seed, 100 * i + k); };
    const InputLine& line = raw.lines[LineId(static_cast<std::size_t>(draw(0) * static_cast<double>(lines)))];
    const Vec2 a = line.points.front(), b = line.points.back();
    const double at = draw(1) < 0.3 ? 0 : draw(2);
    const double beside = draw(3) < 0.3 ? 0 : draw(4) < 0.5 ? 0.03 : 3;
    raw.points.push_back({point_at(at, a, b) + Vec2{beside * (draw(5) - 0.5), beside * (draw(6) - 0.5)}});
  }
  return raw;
}

TEST(CleaningPoints, InRandomSoupsEachHasItsNodeOrAReason) {
  const CleanOptions options{0.015, 0.03, 0.015};
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const LineSet raw = soup_with_points(seed);
    CleanedLines result;
    ASSERT_NO_THROW(result = clean_lines(raw, box_outline(raw, options.snap), options));
    ASSERT_EQ(result.points.size(), raw.points.size());
    for (const PointEntry& entry : result.points) {
      ASSERT_TRUE(entry.node.valid()) << entry.why;
      EXPECT_LE(entry.moved, 3 * options.snap);
    }
    expect_faithful(raw, result);
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace quarry
