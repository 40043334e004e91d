// The section job with --quads matching, and with the outline's own vertices.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "engine/base/error.hpp"
#include "engine/mesh/validate.hpp"
#include "engine/parallel/parallel.hpp"
#include "pipeline/section/section.hpp"
#include "tests/pipeline/section/sample_lines.hpp"
#include "tests/support/mesh_arrays.hpp"

namespace quarry {
namespace {

class LineFile {
 public:
  LineFile(const std::string& name, const std::string& text)
      : path_(
            (std::filesystem::temp_directory_path() / fmt::format("quarry_matching_{}_{}", ::getpid(), name))
                .string()) {
    std::ofstream(path_) << text;
  }
  ~LineFile() { std::filesystem::remove(path_); }
  LineFile(const LineFile&) = delete;
  LineFile& operator=(const LineFile&) = delete;
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

SectionOptions matching_options(const std::string& path, double size) {
  SectionOptions options;
  options.inputs = {path};
  options.size = size;
  options.start = StartMesh::kDelaunay;
  options.quads = QuadMethod::kMatching;
  return options;
}

// A polygon of so many corners on an ellipse, and a line inside.
std::string ellipse_text(int corners) {
  std::string ring;
  for (int i = 0; i <= corners; ++i) {
    const double turn = 2 * std::numbers::pi * (i % corners) / corners;
    ring +=
        fmt::format("{}[{}, {}]", i == 0 ? "" : ", ", 500 + 50 * std::cos(turn), 300 + 40 * std::sin(turn));
  }
  return fmt::format(
      R"({{"type": "FeatureCollection", "features": [
         {{"type": "Feature", "properties": {{}}, "geometry": {{"type": "Polygon", "coordinates": [[{}]]}}}},
         {{"type": "Feature", "properties": {{}}, "geometry": {{"type": "LineString",
           "coordinates": [[480, 295], [520, 310]]}}}}]}})",
      ring);
}

TEST(SectionMatching, HasTheSameMeshOnAnyNumberOfThreads) {
  const LineFile file("threads.geojson", geojson_text(random_lines(3)));
  std::vector<std::uint64_t> expected;
  for (const int threads : {1, 2, 4, 7}) {
    parallel::with_threads(threads, [&] {
      const SectionResult result = mesh_section(matching_options(file.path(), 2), {});
      EXPECT_GT(result.matching.quads, 0U);
      if (threads == 1) expected = test::arrays_of(result.mesh);
      EXPECT_EQ(test::arrays_of(result.mesh), expected);
    });
  }
}

TEST(SectionMatching, EndsInValidQuadsOrSaysWhereNot) {
  int valid = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    const LineFile file("soup.geojson", geojson_text(random_lines(seed)));
    try {
      const SectionResult result = mesh_section(matching_options(file.path(), 1.5), {});
      EXPECT_EQ(validate(result.mesh, GeometryCheck::kPlanarCorners), "");
      for (const FaceId f : result.mesh.faces()) ASSERT_EQ(result.mesh.corner_count(f), 4);
      ++valid;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kGeometry) << error.message();
    }
  }
  EXPECT_GE(valid, 10);
}

TEST(SectionMatching, EndsInValidQuadsWhereForcedMergesLieInWedgesAtTheOutline) {
  for (const double size : {20.0, 40.0, 42.0, 43.0, 50.0}) {
    SCOPED_TRACE(fmt::format("size {}", size));
    const SectionResult result = mesh_section(matching_options("tests/data/demo_section.geojson", size), {});
    EXPECT_EQ(validate(result.mesh, GeometryCheck::kPlanarCorners), "");
    for (const FaceId f : result.mesh.faces()) ASSERT_EQ(result.mesh.corner_count(f), 4);
  }
}

TEST(SectionMatching, AnnealingLeavesFewerSteinerPoints) {
  std::uint64_t without = 0, annealed = 0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    // Few lines: near many there are Steiner points that no search can do without.
    Dice dice(seed);
    const Polyline line = {dice.point(100), dice.point(100)};
    const LineFile file("anneal.geojson",
                        geojson_text({{{0, 0}, {100, 0}, {100, 100}, {0, 100}, {0, 0}}, line}));
    SectionOptions options = matching_options(file.path(), 1);
    options.cleanup = CleanUpLevel::kNone;
    without += mesh_section(options, {}).matching.steiner_points;
    options.anneal = 50;
    annealed += mesh_section(options, {}).matching.steiner_points;
  }
  EXPECT_LT(static_cast<double>(annealed), 0.8 * static_cast<double>(without))
      << annealed << " and " << without;
}

TEST(SectionMatching, AnnealingIsAFunctionOfTheSeedAndNotOfThreads) {
  const LineFile file("anneal.geojson", geojson_text(random_lines(2)));
  SectionOptions options = matching_options(file.path(), 2);
  options.anneal = 30;
  std::vector<std::uint64_t> expected;
  for (const int threads : {1, 2, 4, 7}) {
    const parallel::ParticipationProbe probe;
    parallel::with_threads(threads, [&] {
      const SectionResult result = mesh_section(options, {});
      EXPECT_GT(result.matching.search.annealing_moves, 0U);
      if (threads == 1) expected = test::arrays_of(result.mesh);
      EXPECT_EQ(test::arrays_of(result.mesh) == expected, true) << threads << " threads";
    });
    EXPECT_EQ(probe.chunks_of_other_threads() > 0, threads > 1) << threads << " threads";
  }
  options.seed = 1;
  EXPECT_EQ(test::arrays_of(mesh_section(options, {}).mesh) == expected, false);
}

TEST(SectionMatching, KeepsTheOutlinesOwnVertices) {
  const LineFile file("even.geojson", ellipse_text(60));
  SectionOptions options = matching_options(file.path(), 4);
  options.keep_boundary = true;
  const SectionResult result = mesh_section(options, {});
  std::set<std::pair<double, double>> given, found;
  for (const InputLine& line : result.lines.lines)
    if (line.polygon_ring)
      for (const Vec2 p : line.points) given.emplace(p.x, p.y);
  for (const VertexId v : result.mesh.vertices())
    if (result.mesh.on_boundary(v)) found.emplace(result.mesh.point(v).x, result.mesh.point(v).y);
  EXPECT_EQ(found, given);
}

TEST(SectionMatching, RefusesAnOddOutlineThatMayNotChange) {
  const LineFile file("odd.geojson", ellipse_text(61));
  SectionOptions options = matching_options(file.path(), 4);
  options.keep_boundary = true;
  try {
    (void)mesh_section(options, {});
    FAIL() << "an odd outline was accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kGeometry);
    EXPECT_NE(error.message().find("61 sides"), std::string::npos) << error.message();
  }
}

}  // namespace
}  // namespace quarry
