// GEOS as an oracle: where nothing comes near a tolerance, noding has one right answer.
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/base/random.hpp"
#include "tests/kernels/linework/geos.hpp"
#include "tests/kernels/linework/line_samples.hpp"
#include "tests/kernels/linework/random_lines.hpp"

namespace quarry {
namespace {

TEST(CleaningOracle, NodesAsManyPiecesOfTheSameLengthAsGeos) {
  const Geos geos;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    std::vector<Points> lines;
    for (std::uint64_t i = 0; i < 60; ++i) {
      const auto at = [&](std::uint64_t k) { return 100 * uniform01(seed, 4 * i + k); };
      lines.push_back({{at(0), at(1)}, {at(2), at(3)}});
    }
    const LineSet raw = lines_of(lines);
    const CleanedLines result = clean_lines(raw, wide_box(raw), {1e-7, 0, 0});

    std::vector<GEOSGeometry*> parts;
    for (const Points& points : lines) parts.push_back(geos.line_of(points));
    GEOSGeometry* all = geos.collection_of(GEOS_MULTILINESTRING, std::move(parts));
    GEOSGeometry* noded = GEOSNode_r(geos.handle, all);
    ASSERT_NE(noded, nullptr);
    double length = 0;
    GEOSLength_r(geos.handle, noded, &length);
    double own = 0;
    for (const Piece& piece : result.lines.pieces)
      if (piece.kind == PieceKindOf::kInterior)
        own += distance(result.lines.nodes[piece.from], result.lines.nodes[piece.to]);
    EXPECT_EQ(interior_pieces(result.lines),
              static_cast<std::size_t>(GEOSGetNumGeometries_r(geos.handle, noded)))
        << "seed " << seed;
    EXPECT_NEAR(own, length, 1e-9 * length) << "seed " << seed;
    GEOSGeom_destroy_r(geos.handle, noded);
    GEOSGeom_destroy_r(geos.handle, all);
  }
}

TEST(CleaningOracle, FindsTheSameUnionOfPolygonsAsGeos) {
  const Geos geos;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const LineSet raw = random_polygons(seed);
    const CleanedLines result = clean_lines(raw, default_outline(raw, 1e-8), {1e-8, 0, 0});
    std::vector<GEOSGeometry*> polygons;
    for (const InputLine& ring : raw.lines) {
      GEOSGeometry* polygon = geos.polygon_of(ring.points);
      if (ring.hole) {
        GEOSGeometry* holed = GEOSDifference_r(geos.handle, polygons.back(), polygon);
        GEOSGeom_destroy_r(geos.handle, polygons.back());
        GEOSGeom_destroy_r(geos.handle, polygon);
        polygons.back() = holed;
      } else {
        polygons.push_back(polygon);
      }
    }
    GEOSGeometry* all = geos.collection_of(GEOS_GEOMETRYCOLLECTION, std::move(polygons));
    GEOSGeometry* both = GEOSUnaryUnion_r(geos.handle, all);
    ASSERT_NE(both, nullptr);
    double length = 0;
    GEOSLength_r(geos.handle, both, &length);
    EXPECT_NEAR(outline_length(result.lines), length, 1e-6 * length) << "seed " << seed;
    GEOSGeom_destroy_r(geos.handle, both);
    GEOSGeom_destroy_r(geos.handle, all);
  }
}

}  // namespace
}  // namespace quarry
