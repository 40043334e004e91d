// A hundred thousand fractures, noded by GEOS as well: both results lie on one another, within what cleaning
// may move a line by. GEOS nodes exactly and moves nothing.
#include <vector>

#include <gtest/gtest.h>

#include "pipeline/generate/fractures.hpp"
#include "tests/kernels/linework/geos.hpp"

namespace quarry {
namespace {

constexpr std::uint64_t kFractures = 100'000;

void append_segments(const Geos& geos, const GEOSGeometry* line, std::vector<Segment>& segments) {
  const GEOSCoordSequence* points = GEOSGeom_getCoordSeq_r(geos.handle, line);
  unsigned size = 0;
  GEOSCoordSeq_getSize_r(geos.handle, points, &size);
  Vec2 before;
  for (unsigned i = 0; i < size; ++i) {
    Vec2 p;
    GEOSCoordSeq_getXY_r(geos.handle, points, i, &p.x, &p.y);
    if (i > 0) segments.push_back({before, p});
    before = p;
  }
}

std::vector<Segment> noded_by_geos(const std::vector<Points>& lines) {
  const Geos geos;
  std::vector<GEOSGeometry*> parts;
  for (const Points& line : lines) parts.push_back(geos.line_of(line));
  GEOSGeometry* all = geos.collection_of(GEOS_MULTILINESTRING, std::move(parts));
  GEOSGeometry* noded = GEOSNode_r(geos.handle, all);
  std::vector<Segment> segments;
  for (int i = 0; noded != nullptr && i < GEOSGetNumGeometries_r(geos.handle, noded); ++i)
    append_segments(geos, GEOSGetGeometryN_r(geos.handle, noded, i), segments);
  GEOSGeom_destroy_r(geos.handle, noded);
  GEOSGeom_destroy_r(geos.handle, all);
  return segments;
}

std::vector<Segment> interior_segments(const NodedLines& lines) {
  std::vector<Segment> result;
  for (const Piece& piece : lines.pieces)
    if (piece.kind == PieceKindOf::kInterior)
      result.push_back({lines.nodes[piece.from], lines.nodes[piece.to]});
  return result;
}

// How many places along the segments have none of the others within reach.
std::size_t far_places(const std::vector<Segment>& segments, const std::vector<Segment>& others,
                       double reach) {
  const SegmentGrid grid(others, 4 * reach);
  std::size_t far = 0;
  for (const Segment& s : segments) {
    for (const double at : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      const Vec2 p = point_at(at, s.from, s.to);
      bool near = false;
      grid.visit_near(Box2{p, p}.grown(reach), [&](std::uint32_t id) {
        near = near || squared_distance(p, others[id].from, others[id].to) <= reach * reach;
      });
      far += near ? 0 : 1;
    }
  }
  return far;
}

TEST(LargeCleaningOracle, LiesWithinTheBudgetOfWhatGeosNodesAndTheOtherWay) {
  FractureOptions fractures;
  fractures.box = {{466000, 6691000}, {467000, 6692000}};
  fractures.count = kFractures;
  const LineSet raw = generate_fractures(fractures, Progress()).lines;
  ASSERT_GE(raw.lines.size(), kFractures);
  // A 20th of the shortest fracture.
  const double snap = 0.035 * 1000 / std::sqrt(static_cast<double>(kFractures));
  const CleanOptions options{.snap = snap, .min_edge = 2 * snap, .tolerance = snap};
  const CleanedLines cleaned = clean_lines(raw, wide_box(raw), options);
  std::vector<Points> kept;
  for (const LineId id : IdRange<LineId>(raw.lines.size())) {
    const Points& points = raw.lines[id].points;
    if (cleaned.ledger[id].fate != LineFate::kDropped)
      kept.push_back(points);
    else
      EXPECT_LT(distance(points.front(), points.back()), budget(cleaned.options)) << cleaned.ledger[id].why;
  }

  const std::vector<Segment> own = interior_segments(cleaned.lines);
  const std::vector<Segment> theirs = noded_by_geos(kept);
  ASSERT_GT(theirs.size(), 2 * kFractures);
  EXPECT_EQ(far_places(own, theirs, budget(cleaned.options)), 0U) << own.size() << " pieces";
  EXPECT_EQ(far_places(theirs, own, budget(cleaned.options)), 0U) << theirs.size() << " of GEOS";
  // Crossings within the snapping distance of one another are one node, and short pieces go: hardly any here.
  EXPECT_NEAR(static_cast<double>(own.size()), static_cast<double>(theirs.size()),
              0.1 * static_cast<double>(theirs.size()));
}

}  // namespace
}  // namespace quarry
