#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "kernels/linework/clean_lines.hpp"
#include "tests/kernels/linework/line_samples.hpp"

namespace quarry {
namespace {

TEST(Cleaning, KeepsASingleLineWithItsBits) {
  const CleanedLines result = cleaned(lines_of({{{0.1, 0.2}, {7.3, 0.4}}}));
  EXPECT_EQ(interior_pieces(result.lines), 1U);
  EXPECT_TRUE(has_node(result.lines, {0.1, 0.2}));
  EXPECT_TRUE(has_node(result.lines, {7.3, 0.4}));
  EXPECT_EQ(result.ledger[line(0)].fate, LineFate::kKept);
  EXPECT_EQ(result.ledger[line(0)].moved, 0);
}

TEST(Cleaning, MakesACrossingANode) {
  const CleanedLines result = cleaned(lines_of({{{0, 0}, {4, 4}}, {{0, 4}, {4, 0}}}));
  EXPECT_EQ(interior_pieces(result.lines), 4U);
  EXPECT_TRUE(has_node(result.lines, {2, 2}));
  EXPECT_EQ(result.ledger[line(0)].fate, LineFate::kSplit);
  EXPECT_EQ(result.ledger[line(0)].with, std::vector{line(1)});
}

TEST(Cleaning, JoinsANearMissByMovingTheEndOntoTheLine) {
  const CleanedLines result = cleaned(lines_of({{{0, 0}, {8, 0}}, {{4, 0.04}, {4, 5}}}));
  EXPECT_EQ(interior_pieces(result.lines), 3U);
  EXPECT_TRUE(has_node(result.lines, {4, 0}));
  EXPECT_EQ(result.ledger[line(1)].fate, LineFate::kJoined);
  EXPECT_EQ(result.ledger[line(1)].with, std::vector{line(0)});
  EXPECT_DOUBLE_EQ(result.ledger[line(0)].moved, 0);
}

TEST(Cleaning, LeavesAGapWiderThanSnap) {
  const CleanedLines result = cleaned(lines_of({{{0, 0}, {8, 0}}, {{4, 0.06}, {4, 5}}}));
  EXPECT_EQ(interior_pieces(result.lines), 2U);
  EXPECT_EQ(result.ledger[line(1)].fate, LineFate::kKept);
}

TEST(Cleaning, RemovesAnOvershootShorterThanTheShortestPiece) {
  const CleanedLines result = cleaned(lines_of({{{0, 0}, {8, 0}}, {{4, -0.09}, {4, 5}}}));
  EXPECT_EQ(interior_pieces(result.lines), 3U);
  EXPECT_TRUE(has_node(result.lines, {4, 0}));
  EXPECT_NEAR(result.ledger[line(1)].moved, 0.09, 1e-12);
}

TEST(Cleaning, KeepsALongerOvershoot) {
  EXPECT_EQ(interior_pieces(cleaned(lines_of({{{0, 0}, {8, 0}}, {{4, -0.11}, {4, 5}}})).lines), 4U);
}

TEST(Cleaning, SharesTheOverlapOfCollinearLines) {
  const CleanedLines result = cleaned(lines_of({{{0, 0}, {6, 0}}, {{4, 0}, {9, 0}}}));
  EXPECT_EQ(interior_pieces(result.lines), 3U);
  std::size_t both = 0;
  for (const PieceId p : IdRange<PieceId>(result.lines.pieces.size()))
    both += result.lines.numbers(p).size() == 2 ? 1U : 0U;
  EXPECT_EQ(both, 1U);
  EXPECT_EQ(result.ledger[line(0)].fate, LineFate::kJoined);
}

TEST(Cleaning, TellsOfManyLinesOnOneCourseOnlyTheFirst) {
  const LineSet set = lines_of(std::vector(3 * kMostToldAtOnePlace, Points{{0, 0}, {3, 1}, {8, 0}}));
  const CleanedLines result = cleaned(set);
  for (const PieceId p : IdRange<PieceId>(result.lines.pieces.size()))
    EXPECT_TRUE(result.lines.numbers(p).empty() || result.lines.numbers(p).size() == set.lines.size());
  for (const LineId id : IdRange<LineId>(set.lines.size())) {
    EXPECT_EQ(result.ledger[id].fate, LineFate::kJoined);
    EXPECT_LE(result.ledger[id].with.size(), kMostToldAtOnePlace);
    EXPECT_GE(result.ledger[id].with.size(), kMostToldAtOnePlace - 1);
  }
}

TEST(Cleaning, MergesDuplicatesWithBothNumbers) {
  const CleanedLines result = cleaned(lines_of({{{0, 0}, {3, 1}, {6, 0}}, {{6, 0}, {3, 1}, {0, 0}}}));
  EXPECT_EQ(interior_pieces(result.lines), 2U);
  EXPECT_EQ(result.ledger[line(0)].with, std::vector{line(1)});
  EXPECT_EQ(result.ledger[line(1)].with, std::vector{line(0)});
}

TEST(Cleaning, MergesParallelsNearerThanSnap) {
  const CleanedLines result = cleaned(lines_of({{{0, 0}, {6, 0}}, {{0, 0.04}, {6, 0.04}}}));
  EXPECT_EQ(interior_pieces(result.lines), 1U);
  for (const PieceId p : IdRange<PieceId>(result.lines.pieces.size()))
    EXPECT_EQ(result.lines.numbers(p).size(),
              result.lines.pieces[p].kind == PieceKindOf::kInterior ? 2U : 0U);
}

TEST(Cleaning, KeepsParallelsApartBeyondSnap) {
  EXPECT_EQ(interior_pieces(cleaned(lines_of({{{0, 0}, {6, 0}}, {{0, 0.08}, {6, 0.08}}})).lines), 2U);
}

TEST(Cleaning, BendsALineThroughAForeignBendThatIsNear) {
  const CleanedLines result = cleaned(lines_of({{{0, 0}, {8, 0}}, {{0, 3}, {4, 0.03}, {8, 3}}}));
  EXPECT_EQ(interior_pieces(result.lines), 4U);
  EXPECT_TRUE(has_node(result.lines, {4, 0.03}));
}

TEST(Cleaning, SimplifiesWithinTheToleranceAndNotBeyond) {
  const CleanedLines result = cleaned(lines_of({{{0, 0}, {2, 0.04}, {4, 0}}, {{0, 5}, {2, 5.06}, {4, 5}}}));
  EXPECT_EQ(interior_pieces(result.lines), 3U);
  EXPECT_FALSE(has_node(result.lines, {2, 0.04}));
  EXPECT_TRUE(has_node(result.lines, {2, 5.06}));
}

TEST(Cleaning, MeasuresSimplificationAgainstTheRawLine) {
  Points arc;
  for (int i = 0; i <= 200; ++i) arc.push_back({10 * std::cos(i * 0.01), 10 * std::sin(i * 0.01)});
  const CleanedLines result = cleaned(lines_of({arc}));
  EXPECT_LT(interior_pieces(result.lines), 20U);
  EXPECT_LE(result.ledger[line(0)].moved, kOptions.tolerance);
}

TEST(Cleaning, NeverSimplifiesALineAcrossANode) {
  // The bend may not go: the end of the other line lies between it and the chord.
  const CleanedLines result = cleaned(lines_of({{{0, 0}, {5, 0.09}, {10, 0}}, {{5, 0.035}, {5, -4}}}),
                                      {.snap = 0.02, .min_edge = 0.1, .tolerance = 0.1});
  EXPECT_TRUE(has_node(result.lines, {5, 0.09}));
}

TEST(Cleaning, DropsAZeroLengthLineWithAReason) {
  const CleanedLines result = cleaned(lines_of({{{0, 0}, {8, 0}}, {{3, 3}, {3, 3}}, {}}));
  EXPECT_EQ(result.ledger[line(1)].fate, LineFate::kDropped);
  EXPECT_EQ(result.ledger[line(1)].why, "has no length");
  EXPECT_EQ(result.ledger[line(2)].why, "has no points");
}

TEST(Cleaning, DropsAnIsolatedLineShorterThanTheShortestPiece) {
  const CleanedLines result = cleaned(lines_of({{{0, 0}, {8, 0}}, {{3, 3}, {3.09, 3}}}));
  EXPECT_EQ(result.ledger[line(1)].fate, LineFate::kDropped);
  EXPECT_NE(result.ledger[line(1)].why.find("min-edge"), std::string::npos);
}

TEST(Cleaning, CollapsesAShortPieceBetweenJunctions) {
  const CleanedLines result = cleaned(lines_of({{{0, 0}, {8, 0}}, {{4, 0}, {4, 4}}, {{4.08, 0}, {5, -4}}}));
  EXPECT_EQ(interior_pieces(result.lines), 4U);
  EXPECT_EQ(result.counts.short_pieces, 0U);
}

TEST(Cleaning, MeetsAStarOfManyLinesInOneNode) {
  std::vector<Points> lines;
  for (int i = 0; i < 180; ++i) {
    const double angle = std::numbers::pi * i / 180;
    const Vec2 u{50 * std::cos(angle), 50 * std::sin(angle)};
    lines.push_back({u, Vec2{} - u});
  }
  const CleanedLines result = cleaned(lines_of(lines));
  EXPECT_EQ(interior_pieces(result.lines), 360U);
  EXPECT_EQ(result.lines.nodes.size(), 365U);
}

TEST(Cleaning, KeepsAWideCombAndMergesANarrowOne) {
  for (const double gap : {0.1, 0.01, 0.001}) {
    std::vector<Points> lines;
    for (int i = 0; i < 20; ++i) lines.push_back({{0, gap * i}, {10, gap * i}});
    const CleanedLines result = cleaned(lines_of(lines));
    EXPECT_EQ(interior_pieces(result.lines) == 20U, gap == 0.1) << gap;
  }
}

TEST(Cleaning, KeepsASharpWedgeOfTwoLines) {
  const double slope = 0.05 * std::numbers::pi / 180;
  const CleanedLines result = cleaned(lines_of({{{0, 0}, {100, 0}}, {{0, 0}, {100, 100 * slope}}}));
  EXPECT_EQ(interior_pieces(result.lines), 2U);
  EXPECT_NEAR(result.counts.smallest_angle, 0.05, 1e-6);
}

TEST(Cleaning, ClosesASharpWedgeWithinTheSnappingDistanceWhereThatIsAskedFor) {
  CleanOptions options = kOptions;
  options.closed_wedge = 10;
  for (const double degrees : {0.05, 0.5, 3.0, 9.0}) {
    const double slope = std::tan(degrees * std::numbers::pi / 180);
    const LineSet raw = lines_of({{{0, 0}, {100, 0}}, {{0, 0}, {100, 100 * slope}}});
    const CleanedLines result = clean_lines(raw, wide_box(raw), options);
    EXPECT_EQ(result.counts.closed_wedges, 1U) << degrees;
    EXPECT_GT(result.counts.smallest_angle, 15) << degrees;
    EXPECT_LT(result.counts.largest_move, 1.01 * options.snap) << degrees;
    EXPECT_EQ(result.ledger[line(0)].fate, LineFate::kJoined) << degrees;
    require_noded(result.lines, options.snap);
  }
}

TEST(Cleaning, ClosesTheWedgesOfAFanOneAfterTheOther) {
  CleanOptions options = kOptions;
  options.closed_wedge = 10;
  std::vector<Points> lines;
  for (int i = 0; i < 20; ++i) lines.push_back({{0, 0}, {100, 0.5 * i}});
  const LineSet raw = lines_of(lines);
  const CleanedLines result = clean_lines(raw, wide_box(raw), options);
  EXPECT_GT(result.counts.closed_wedges, 10U);
  // Raw ones are of 0.3 degrees. Those stay narrow whose pieces are too short for the nodes.
  EXPECT_GT(result.counts.smallest_angle, 4);
  EXPECT_LT(result.counts.largest_move, budget(options));
}

TEST(Cleaning, RefusesToCloseWedgesOfWideAngles) {
  CleanOptions options = kOptions;
  for (const double angle : {-1.0, 31.0, std::nan("")}) {
    options.closed_wedge = angle;
    const LineSet raw = lines_of({{{0, 0}, {1, 0}}});
    EXPECT_THROW((void)clean_lines(raw, wide_box(raw), options), Error) << angle;
  }
}

TEST(Cleaning, DoesNotDrawALineAlongWithOneThatSlowlyLeavesIt) {
  // Each bend through a vertex of the arc would bring the straight line within reach of the next.
  Points arc;
  for (int i = 0; i <= 300; ++i) arc.push_back({0.1 * i, 0.0008 * 0.1 * i * 0.1 * i + 0.02});
  const LineSet raw = lines_of({{{0, 0}, {60, 0}}, arc});
  const CleanedLines result = cleaned(raw, {.snap = 0.05, .min_edge = 0.05, .tolerance = 0});
  EXPECT_LE(result.counts.largest_move, 0.1);
}

TEST(Cleaning, GivesTheRaisedSnapAndTellsSo) {
  const LineSet raw =
      lines_of({{{6.7e6, 6.7e6}, {6.7e6 + 1, 6.7e6}}, {{6.7e6, 6.7e6 + 1}, {6.7e6 + 1, 6.7e6 + 1}}});
  const CleanedLines result = clean_lines(raw, box_outline(raw, 0), {});
  EXPECT_GT(result.options.snap, 6.7e6 * 1e-15);
  EXPECT_LT(result.options.snap, 1e-6);
  EXPECT_EQ(result.options.min_edge, result.options.snap);
  EXPECT_EQ(result.notes.size(), 2U);
}

TEST(Cleaning, RefusesLengthsThatAreNone) {
  const LineSet raw = lines_of({{{0, 0}, {1, 1}}});
  for (const double bad : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW((void)clean_lines(raw, box_outline(raw, 0), {bad, 0, 0}), Error);
    EXPECT_THROW((void)clean_lines(raw, box_outline(raw, 0), {0, 0, bad}), Error);
  }
}

TEST(Cleaning, EndsWhenItIsCancelled) {
  const LineSet raw = lines_of({{{0, 0}, {1, 1}}});
  CancellationToken token;
  token.cancel();
  EXPECT_THROW((void)clean_lines(raw, box_outline(raw, 0.05), kOptions, Progress({}, &token)), Error);
}

TEST(Cleaning, TellsOfADuplicateInEitherDirection) {
  const CleanedLines result = cleaned(lines_of({{{0, 0}, {3, 1}, {6, 0}}, {{6, 0}, {3, 1}, {0, 0}}}));
  EXPECT_EQ(result.counts.duplicate_lines, 1U);
  EXPECT_NE(result.ledger[line(1)].why.find("has the points of line 0"), std::string::npos);
}

TEST(Cleaning, TellsOfSegmentsOfNoLength) {
  const CleanedLines result = cleaned(lines_of({{{0, 0}, {0, 0}, {4, 0}, {4, 0}}}));
  EXPECT_EQ(result.counts.empty_segments, 2U);
  EXPECT_EQ(result.ledger[line(0)].why, "2 of its segments have no length");
}

TEST(Cleaning, CutsAShortDangleAndTellsItsLine) {
  const CleanedLines result = cleaned(lines_of({{{0, 0}, {8, 0}}, {{4, -0.08}, {4, 4}}}));
  EXPECT_EQ(interior_pieces(result.lines), 3U);
  EXPECT_EQ(result.counts.cut_dangles, 1U);
  EXPECT_NE(result.ledger[line(1)].why.find("a dangling end"), std::string::npos);
  EXPECT_EQ(result.counts.nodes.abutting, 1U);
}

TEST(Cleaning, ResolvesACrossingUnderADegree) {
  const CleanedLines result = cleaned(lines_of({{{0, 0}, {100, 0}}, {{0, -0.5}, {100, 0.5}}}));
  EXPECT_EQ(result.counts.nodes.crossing, 1U);
  EXPECT_LT(result.counts.smallest_angle, 1);
}

TEST(NodeClasses, AreCountedAsFracturePeopleDo) {
  // A crossing, an abutment, a bend, six tips, and one end on the outline.
  const LineSet raw =
      lines_of({{{0, 0}, {8, 0}}, {{2, -2}, {2, 2}, {3, 4}}, {{6, 0}, {6, 3}}, {{1, -1}, {-9, -1}}});
  Outline outline;
  outline.rigid = true;
  outline.rings.push_back({{{-9, -9}, {20, -9}, {20, 9}, {-9, 9}, {-9, -9}}, 0, LineId()});
  const NodeClassCounts counts = clean_lines(raw, outline, kOptions).counts.nodes;
  EXPECT_EQ(counts.crossing, 1U);
  EXPECT_EQ(counts.abutting, 1U);
  EXPECT_EQ(counts.isolated, 6U);
  EXPECT_EQ(counts.edge, 1U);
}

TEST(RequireNoded, FindsWhatIsBroken) {
  NodedLines lines;
  lines.nodes = IdVector<NodeId, Vec2>(Points{{0, 0}, {4, 4}, {0, 4}, {4, 0}});
  lines.pieces.push_back({NodeId(0U), NodeId(1U)});
  lines.pieces.push_back({NodeId(2U), NodeId(3U)});
  EXPECT_THROW(require_noded(lines, 0.1), Error);
  lines.pieces[PieceId(1U)] = {NodeId(0U), NodeId(1U)};
  EXPECT_THROW(require_noded(lines, 0.1), Error);
  lines.pieces[PieceId(1U)] = {NodeId(0U), NodeId(2U)};
  EXPECT_NO_THROW(require_noded(lines, 0.1));
  lines.nodes[NodeId(2U)] = {1, 1.1};
  EXPECT_THROW(require_noded(lines, 0.1), Error);
  lines.nodes[NodeId(2U)] = {0, 0};
  EXPECT_THROW(require_noded(lines, 0.1), Error);
}

}  // namespace
}  // namespace quarry
