// Prices of irregular vertices: what the user may say, and that the section job follows it.
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "engine/geometry/segment.hpp"
#include "engine/mesh/validate.hpp"
#include "engine/parallel/parallel.hpp"
#include "pipeline/section/price_source.hpp"
#include "pipeline/section/section.hpp"
#include "tests/io/mesh/temporary_folder.hpp"
#include "tests/pipeline/section/sample_lines.hpp"
#include "tests/support/mesh_arrays.hpp"

namespace quarry {
namespace {

class Prices : public testing::Test {
 protected:
  [[nodiscard]] SectionOptions options(std::uint64_t seed, const std::string& price) const {
    Dice dice(seed);
    std::vector<Polyline> lines;
    for (int i = 0; i < 8; ++i) {
      const Vec2 a = dice.point(100);
      lines.push_back({a, a + dice.point(60) - Vec2{30, 30}});
    }
    SectionOptions options;
    options.inputs = {folder_.file("lines.geojson", geojson_text(lines))};
    options.size = 1;
    options.irregular_price = price;
    return options;
  }
  void expect_error(const std::string& text, ErrorKind kind, const std::string& word) const {
    try {
      (void)PriceSource(text);
      ADD_FAILURE() << "accepted: " << text;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), kind) << error.message();
      EXPECT_NE(error.message().find(word), std::string::npos) << error.message();
    }
  }
  TemporaryFolder folder_;
};

// Irregular vertices off the lines and the boundary.
template <class Counts>
std::size_t count_irregular(const Mesh& mesh, const Counts& counts) {
  std::vector<bool> on_line(mesh.vertex_slots(), false);
  for (const EdgeId e : mesh.edges()) {
    const auto [a, b] = mesh.edge_ends(e);
    on_line[a.value()] = on_line[b.value()] = true;
  }
  std::size_t count = 0;
  for (const VertexId v : mesh.vertices()) {
    if (on_line[v.value()]) continue;
    int faces = 0;
    for_each_side_around(mesh, v, [&](SideId) { ++faces; });
    if (faces != 4 && counts(mesh.point(v))) ++count;
  }
  return count;
}

// Of them those within the distance of a line.
std::size_t count_near_lines(const SectionResult& result, double distance) {
  const NodedLines& lines = result.cleaned.lines;
  return count_irregular(result.mesh, [&](Vec2 p) {
    for (const Piece& piece : lines.pieces)
      if (piece.kind == PieceKindOf::kInterior &&
          squared_distance(p, lines.nodes[piece.from], lines.nodes[piece.to]) <= distance * distance)
        return true;
    return false;
  });
}

TEST_F(Prices, NearLinesLeaveFewerIrregularVerticesThere) {
  std::size_t usual = 0, priced = 0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    usual += count_near_lines(mesh_section(options(seed, ""), {}), 3);
    const SectionResult result = mesh_section(options(seed, "lines:3:8"), {});
    EXPECT_EQ(validate(result.mesh, GeometryCheck::kPlanarCorners), "");
    priced += count_near_lines(result, 3);
  }
  EXPECT_LT(static_cast<double>(priced), 0.8 * static_cast<double>(usual)) << priced << " and " << usual;
}

// Columns of cells of side 10 over the domain, every second one dear; the others have no value.
std::string striped_raster(bool first) {
  std::string row;
  for (int column = 0; column < 20; ++column) row += (column % 2 == 0) == first ? "20 " : "0 ";
  std::string text = "ncols 20\nnrows 20\nxllcorner -50\nyllcorner -50\ncellsize 10\nNODATA_value 0\n";
  for (int i = 0; i < 20; ++i) text += row + "\n";
  return text;
}

TEST_F(Prices, OfARasterLeaveFewerIrregularVerticesWhereItIsDear) {
  // Those in the first stripes, dear or not.
  const auto count = [&](bool dear) {
    const std::string path = folder_.file("price.asc", striped_raster(dear));
    std::size_t sum = 0;
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
      sum += count_irregular(mesh_section(options(seed, path), {}).mesh,
                             [](Vec2 p) { return static_cast<int>(std::floor((p.x + 50) / 10)) % 2 == 0; });
    return sum;
  };
  const std::size_t dear = count(true);
  const std::size_t cheap = count(false);
  EXPECT_LT(2 * dear, cheap) << dear << " and " << cheap;
}

TEST_F(Prices, GiveTheSameMeshOnAnyNumberOfThreads) {
  SectionOptions priced = options(1, "lines:3:8");
  priced.size = 2;
  std::vector<std::uint64_t> expected;
  for (const int threads : {1, 2, 4, 7}) {
    const parallel::ParticipationProbe probe;
    parallel::with_threads(threads, [&] {
      const std::vector<std::uint64_t> arrays = test::arrays_of(mesh_section(priced, {}).mesh);
      if (threads == 1) expected = arrays;
      EXPECT_EQ(arrays == expected, true) << threads << " threads";
    });
    EXPECT_EQ(probe.chunks_of_other_threads() > 0, threads > 1) << threads << " threads";
  }
}

TEST_F(Prices, OfOneAreNone) {
  SectionOptions priced = options(1, "lines:3:1");
  SectionOptions usual = options(1, "");
  priced.size = usual.size = 2;
  priced.cleanup = usual.cleanup = CleanUpLevel::kLocal;
  EXPECT_EQ(test::arrays_of(mesh_section(priced, {}).mesh) == test::arrays_of(mesh_section(usual, {}).mesh),
            true);
}

TEST_F(Prices, ThatMakeNoSenseAreRefused) {
  for (const std::string text : {"lines:", "lines:3", "lines:3:", "lines::4", "lines:3:0", "lines:-1:4",
                                 "lines:3:4:5", "lines:x:4", "lines:inf:4", "lines:nan:2"})
    expect_error(text, ErrorKind::kUsage, text);
  expect_error(folder_.file("none.asc"), ErrorKind::kInput, "none.asc");
  const std::string header = "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\nNODATA_value -1\n";
  expect_error(folder_.file("zero.asc", header + "1 2\n3 0\n"), ErrorKind::kInput, "row 2, column 2");
  expect_error(folder_.file("less.asc", header + "-1 -2\n3 4\n"), ErrorKind::kInput, "row 1, column 2");
}

TEST_F(Prices, AreOneOutsideOfTheRasterAndWithoutData) {
  const std::string path = folder_.file(
      "a.asc", "ncols 2\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 10\nNODATA_value -1\n7 -1\n");
  const IrregularPrice price = PriceSource(path).price({});
  EXPECT_EQ(price({5, 5, 0}), 7);
  EXPECT_EQ(price({15, 5, 0}), 1);
  EXPECT_EQ(price({-5, 5, 0}), 1);
}

}  // namespace
}  // namespace quarry
