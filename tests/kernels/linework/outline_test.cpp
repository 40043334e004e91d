#include "kernels/linework/outline.hpp"

#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "kernels/linework/clean_lines.hpp"
#include "tests/kernels/linework/line_samples.hpp"

namespace quarry {
namespace {

Points square(double x, double y, double side) {
  return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}, {x, y}};
}

LineSet polygons_of(const std::vector<std::vector<Points>>& polygons) {
  LineSet set;
  set.files = {"made.geojson"};
  for (const auto& rings : polygons) {
    for (std::size_t r = 0; r < rings.size(); ++r) {
      InputLine ring;
      ring.points = rings[r];
      ring.polygon_ring = true;
      ring.hole = r > 0;
      set.lines.push_back(ring);
    }
  }
  return set;
}

template <class Job>
std::string input_error(Job&& job) {
  try {
    job();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInput);
    return error.message();
  }
  ADD_FAILURE() << "no error";
  return {};
}

TEST(DefaultOutline, IsThePolygonsWithTheirHoles) {
  const LineSet raw = polygons_of({{square(0, 0, 10), square(4, 4, 2)}});
  const Outline outline = default_outline(raw, 0.05);
  EXPECT_EQ(outline.rule, OutlineRule::kPolygons);
  EXPECT_EQ(outline.rings.size(), 2U);
  EXPECT_DOUBLE_EQ(outline_length(cleaned_in(raw, outline).lines), 48);
}

TEST(DefaultOutline, IsTheUnionOfPolygonsThatShareBorders) {
  // The shared border is digitised twice, a little differently.
  const LineSet raw =
      polygons_of({{square(0, 0, 10)}, {{{10.01, 0}, {20, 0}, {20, 10}, {9.99, 10}, {10.01, 0}}}});
  const CleanedLines result = cleaned_in(raw, default_outline(raw, 0.05));
  EXPECT_NEAR(outline_length(result.lines), 60, 0.1);
  EXPECT_EQ(interior_pieces(result.lines), 1U);
}

TEST(DefaultOutline, IsTheUnionOfPolygonsThatOverlap) {
  const LineSet raw = polygons_of({{square(0, 0, 10)}, {square(5, 5, 10)}});
  const CleanedLines result = cleaned_in(raw, default_outline(raw, 0.05));
  EXPECT_DOUBLE_EQ(outline_length(result.lines), 60);
  EXPECT_EQ(interior_pieces(result.lines), 4U);
}

TEST(DefaultOutline, CallsPolygonsThatCrossSplit) {
  // The second is turned a little, so that the crossings are no numbers of few digits.
  const Points turned{{5, 5.3}, {15.1, 5}, {15.3, 15.2}, {5.2, 15}, {5, 5.3}};
  for (const LineSet& raw :
       {polygons_of({{square(0, 0, 10)}, {square(5, 5, 10)}}), polygons_of({{square(0, 0, 10)}, {turned}}),
        lines_of({square(0, 0, 10), square(5, 5, 10)}), lines_of({square(0, 0, 10), turned})}) {
    const CleanedLines result = cleaned_in(raw, default_outline(raw, 0.05));
    for (const std::uint32_t i : {0U, 1U}) {
      EXPECT_STREQ(name_of(result.ledger[line(i)].fate), "split") << result.ledger[line(i)].why;
      EXPECT_EQ(result.ledger[line(i)].with, std::vector{line(1 - i)});
    }
  }
}

TEST(DefaultOutline, CallsPolygonsThatShareABorderJoined) {
  const LineSet raw = polygons_of({{square(0, 0, 10)}, {square(10, 0, 10)}});
  const CleanedLines result = cleaned_in(raw, default_outline(raw, 0.05));
  EXPECT_STREQ(name_of(result.ledger[line(0)].fate), "joined");
  EXPECT_STREQ(name_of(result.ledger[line(1)].fate), "joined");
}

TEST(DefaultOutline, CallsALineThatItCutsAwayClippedAndTellsWhatItMeets) {
  LineSet raw = polygons_of({{square(0, 0, 10)}});
  InputLine across;
  across.points = {{-5, 5}, {15, 5}};
  raw.lines.push_back(across);
  const CleanedLines result = cleaned_in(raw, default_outline(raw, 0.05));
  EXPECT_EQ(result.ledger[line(0)].fate, LineFate::kSplit);
  EXPECT_EQ(result.ledger[line(1)].fate, LineFate::kClipped);
  EXPECT_EQ(result.ledger[line(1)].with, std::vector{line(0)});
}

TEST(DefaultOutline, FillsAHoleThatAnIslandFills) {
  const LineSet raw = polygons_of({{square(0, 0, 10), square(4, 4, 2)}, {square(4, 4, 2)}});
  const CleanedLines result = cleaned_in(raw, default_outline(raw, 0.05));
  EXPECT_DOUBLE_EQ(outline_length(result.lines), 40);
  EXPECT_EQ(interior_pieces(result.lines), 4U);
}

TEST(DefaultOutline, ClipsLinesToThePolygonsAndTells) {
  LineSet raw = polygons_of({{square(0, 0, 10)}});
  InputLine across;
  across.points = {{-5, 5}, {15, 5}};
  raw.lines.push_back(across);
  across.points = {{20, 20}, {30, 30}};
  raw.lines.push_back(across);
  const CleanedLines result = cleaned_in(raw, default_outline(raw, 0.05));
  EXPECT_EQ(result.ledger[line(1)].fate, LineFate::kClipped);
  EXPECT_DOUBLE_EQ(result.ledger[line(1)].clipped_length, 10);
  EXPECT_EQ(result.ledger[line(2)].fate, LineFate::kDropped);
  EXPECT_NE(result.ledger[line(2)].why.find("outside"), std::string::npos);
  EXPECT_EQ(interior_pieces(result.lines), 1U);
}

TEST(DefaultOutline, IsTheOutermostClosedLinesIfTheyHoldTheRest) {
  const LineSet raw = lines_of({square(2, 2, 3), square(0, 0, 10), {{1, 1}, {9, 9}}});
  const Outline outline = default_outline(raw, 0.05);
  EXPECT_EQ(outline.rule, OutlineRule::kClosedLines);
  ASSERT_EQ(outline.rings.size(), 1U);
  EXPECT_EQ(outline.rings[0].line, line(1));
  const CleanedLines result = cleaned_in(raw, outline);
  EXPECT_DOUBLE_EQ(outline_length(result.lines), 40);
}

TEST(DefaultOutline, TakesAClosedLineThatFillsABayForOutermost) {
  // All points of the second line lie on the rim of the first.
  const LineSet raw =
      lines_of({{{0, 0}, {10, 0}, {10, 10}, {7, 10}, {7, 4}, {3, 4}, {3, 10}, {0, 10}, {0, 0}},
                {{3, 4}, {7, 4}, {7, 10}, {3, 10}, {3, 4}}});
  const Outline outline = default_outline(raw, 0.05);
  EXPECT_EQ(outline.rings.size(), 2U);
  EXPECT_DOUBLE_EQ(outline_length(cleaned_in(raw, outline).lines), 40);
}

TEST(DefaultOutline, IsTheBoxOtherwise) {
  const LineSet raw = lines_of({square(2, 2, 3), {{0, 0}, {9, 8}}});
  const Outline outline = default_outline(raw, 0.05);
  EXPECT_EQ(outline.rule, OutlineRule::kBox);
  const CleanedLines result = cleaned_in(raw, outline);
  EXPECT_DOUBLE_EQ(outline_length(result.lines), 34);
  EXPECT_TRUE(has_node(result.lines, {9, 0}));
}

TEST(BoxOutline, KeepsItsShapeWhereLinesComeNear) {
  const LineSet raw =
      lines_of({{{0, 0}, {10, 10}}, {{3, 0.04}, {7, 0.03}}, {{2, 5}, {9.97, 5}}, {{5, 0.06}, {5, 6}}});
  const CleanedLines result = cleaned_in(raw, box_outline(raw, 0.05));
  EXPECT_DOUBLE_EQ(outline_length(result.lines), 40);
}

TEST(BoxOutline, GrowsWhereLinesHaveNoWidth) {
  const LineSet raw = lines_of({{{0, 5}, {10, 5}}});
  const Outline outline = box_outline(raw, 0.05);
  EXPECT_NE(outline.text.find("grown"), std::string::npos);
  const CleanedLines result = cleaned_in(raw, outline);
  EXPECT_EQ(interior_pieces(result.lines), 1U);
  EXPECT_DOUBLE_EQ(outline_length(result.lines), 24);
}

TEST(BoxOutline, RefusesLinesThatAreOnePoint) {
  EXPECT_NE(input_error([] {
              (void)box_outline(lines_of({{{3, 4}, {3, 4}}}), 0.05);
            }).find("(3, 4)"),
            std::string::npos);
}

TEST(HullOutline, IsConvexAndHoldsAllPoints) {
  const LineSet raw = lines_of({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{2, 0}, {2, 6}}, {{1, 1}, {3, 3}}});
  const Outline outline = hull_outline(raw, 0.05);
  ASSERT_EQ(outline.rings.size(), 1U);
  EXPECT_EQ(outline.rings[0].points, (Points{{0, 0}, {4, 0}, {4, 4}, {2, 6}, {0, 4}, {0, 0}}));
}

TEST(HullOutline, FallsBackOnTheBoxForLinesWithoutArea) {
  EXPECT_EQ(hull_outline(lines_of({{{0, 0}, {4, 4}}}), 0.05).rule, OutlineRule::kBox);
}

TEST(BoundaryOutline, TakesNestedClosedLinesAsHoles) {
  const LineSet raw = lines_of({{{-1, 5}, {11, 5}}});
  const LineSet boundary = lines_of({square(0, 0, 10), square(4, 4, 2)});
  const CleanedLines result = cleaned_in(raw, boundary_outline(boundary, 0.05));
  EXPECT_DOUBLE_EQ(outline_length(result.lines), 48);
  EXPECT_EQ(interior_pieces(result.lines), 2U);
  EXPECT_DOUBLE_EQ(result.ledger[line(0)].clipped_length, 4);
  for (const PieceId p : IdRange<PieceId>(result.lines.pieces.size()))
    EXPECT_EQ(result.lines.numbers(p).empty(), result.lines.pieces[p].kind == PieceKindOf::kOutline);
}

TEST(BoundaryOutline, GivesALineThatRunsAlongItItsNumber) {
  const LineSet raw = lines_of({{{2, 0.02}, {8, 0.01}}, {{5, 2}, {5, 8}}});
  const CleanedLines result = cleaned_in(raw, boundary_outline(lines_of({square(0, 0, 10)}), 0.05));
  std::size_t numbered = 0;
  for (const PieceId p : IdRange<PieceId>(result.lines.pieces.size()))
    if (result.lines.pieces[p].kind == PieceKindOf::kOutline) numbered += result.lines.numbers(p).size();
  EXPECT_EQ(numbered, 1U);
}

TEST(BoundaryOutline, NeedsARing) {
  EXPECT_NE(input_error([] {
              (void)boundary_outline(lines_of({{{0, 0}, {1, 1}}}), 0.05);
            }).find("no polygon"),
            std::string::npos);
}

TEST(Outlines, ThatCrossThemselvesAreRefusedWithThePlace) {
  const Points bow{{0, 0}, {4, 4}, {4, 0}, {0, 4}, {0, 0}};
  for (const auto& message : {input_error([&] { (void)boundary_outline(lines_of({bow}), 0.05); }),
                              input_error([&] { (void)default_outline(polygons_of({{bow}}), 0.05); })})
    EXPECT_NE(message.find("(2, 2)"), std::string::npos) << message;
}

TEST(Outlines, ThatHoldNoLineAreRefused) {
  const LineSet raw = lines_of({{{50, 50}, {60, 60}}});
  const std::string message = input_error(
      [&] { (void)clean_lines(raw, boundary_outline(lines_of({square(0, 0, 10)}), 0.05), kOptions); });
  EXPECT_NE(message.find("no part of any line"), std::string::npos);
  EXPECT_NE(message.find("(50, 50)"), std::string::npos);
}

TEST(Outlines, AroundLinesThatAreAllTooShortAreRefused) {
  const LineSet raw = lines_of({{{1, 1}, {1.01, 1}}, {{9, 9}, {9, 9.01}}});
  EXPECT_NE(input_error([&] { (void)clean_lines(raw, wide_box(raw), kOptions); }).find("smaller size"),
            std::string::npos);
}

TEST(Outlines, WithoutAreaAreRefused) {
  const Points sliver{{0, 0}, {10, 0}, {10, 0.01}, {0, 0.01}, {0, 0}};
  const LineSet raw = polygons_of({{sliver}});
  EXPECT_NE(
      input_error([&] { (void)clean_lines(raw, default_outline(raw, 0.05), kOptions); }).find("no area"),
      std::string::npos);
}

}  // namespace
}  // namespace quarry
