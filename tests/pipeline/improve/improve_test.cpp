#include "pipeline/improve/improve.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "engine/base/random.hpp"
#include "engine/mesh/validate.hpp"
#include "engine/parallel/parallel.hpp"
#include "io/mesh/mesh_format.hpp"
#include "tests/io/mesh/mesh_comparison.hpp"
#include "tests/io/mesh/sample_mesh.hpp"
#include "tests/io/mesh/tag_measures.hpp"
#include "tests/io/mesh/temporary_folder.hpp"
#include "tests/pipeline/improve/improve_checks.hpp"

namespace quarry {
namespace {

class Improve : public testing::TestWithParam<const char*> {
 protected:
  // Crooked quads and a few triangles, two regions, lines with several numbers.
  [[nodiscard]] std::string sample(const SampleMesh& sample = {.size = 24, .disorder = 0.6}) const {
    const std::string path = folder_.file(std::string("in") + GetParam());
    write_mesh(path, make_sample_mesh(sample), {});
    return path;
  }
  TemporaryFolder folder_;
};

TEST_P(Improve, KeepsRegionsAndTaggedEdgesOfEveryFormat) {
  const SampleMesh crooked{.size = 24, .disorder = 0.6, .corner = {6.7e6, 10}};
  const Mesh before = make_sample_mesh(crooked);
  const ImproveResult result = improve_mesh({.input = sample(crooked)}, {});
  EXPECT_EQ(validate(result.mesh, GeometryCheck::kPlanarCorners), "");
  expect_near(areas_by(result.mesh, "region"), areas_by(before, "region"));
  expect_near(edge_lengths(result.mesh), edge_lengths(before));
}

TEST_P(Improve, LiftsTheQuality) {
  const ImproveResult result = improve_mesh({.input = sample()}, {});
  const QualitySummary after = summarize_quality(result.mesh);
  EXPECT_GT(after.all.scaled_jacobian.min, result.before.all.scaled_jacobian.min);
  EXPECT_GT(after.all.scaled_jacobian.mean, result.before.all.scaled_jacobian.mean);
}

INSTANTIATE_TEST_SUITE_P(Formats, Improve, testing::Values(".vtu", ".msh", ".obj", ".inp"),
                         [](const auto& format) { return std::string(format.param + 1); });

class ImproveJob : public testing::Test {
 protected:
  void expect_error(const std::string& path, ErrorKind kind, const std::string& message) const {
    expect_improve_error({.input = path}, kind, message);
  }
  TemporaryFolder folder_;
};

TEST_F(ImproveJob, IsTheSameOnAnyNumberOfThreads) {
  const std::string path = folder_.file("in.vtu");
  write_mesh(path, make_sample_mesh({.size = 120, .disorder = 0.7}), {});
  expect_same_bytes_on_threads(folder_, path);
}

TEST_F(ImproveJob, TurnsAClockwiseMeshAndSaysSo) {
  const std::string path =
      folder_.file("a.obj", "v 0 0\nv 1 0\nv 2 0\nv 0 1\nv 1 1\nv 2 1\nf 4 5 2 1\nf 2 3 6 5\n");
  const ImproveResult result = improve_mesh({.input = path}, {});
  EXPECT_EQ(result.turned, 1U);
  ASSERT_EQ(result.notes.size(), 1U);
  EXPECT_NE(result.notes[0].find("1 of 2 faces were clockwise"), std::string::npos) << result.notes[0];
  EXPECT_EQ(validate(result.mesh, GeometryCheck::kPlanarCorners), "");
}

TEST_F(ImproveJob, UntanglesAVertexThatLiesOutsideItsStar) {
  SampleMesh sample{.size = 6, .disorder = 0, .triangles = false};
  Mesh mesh = make_sample_mesh(sample);
  mesh.set_point(VertexId(sample_vertex(sample, 2, 2)), {3.4, 3.4});
  const std::string path = folder_.file("in.vtu");
  write_mesh(path, mesh, {});
  const ImproveResult result = improve_mesh({.input = path}, {});
  EXPECT_GT(result.invalid, 0U);
  EXPECT_EQ(validate(result.mesh, GeometryCheck::kPlanarCorners), "");
}

// A square of n by n quads whose inner vertices lie up to `disorder` / 2 edges from their places, and those
// of its sides up to `along` / 2 along them.
std::string tangled_square(std::uint32_t n, double disorder, std::uint64_t seed, double along = 0) {
  std::string text;
  for (std::uint32_t j = 0; j <= n; ++j)
    for (std::uint32_t i = 0; i <= n; ++i) {
      const std::uint64_t k = std::uint64_t{j} * (n + 1) + i;
      const bool in_x = i > 0 && i < n;
      const bool in_y = j > 0 && j < n;
      const double by = in_x && in_y ? disorder : along;
      text += "v " + std::to_string(i + (in_x ? by : 0) * (uniform01(seed, 2 * k) - 0.5)) + " " +
              std::to_string(j + (in_y ? by : 0) * (uniform01(seed, 2 * k + 1) - 0.5)) + "\n";
    }
  for (std::uint32_t j = 0; j < n; ++j)
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = j * (n + 1) + i + 1;
      text += "f " + std::to_string(a) + " " + std::to_string(a + 1) + " " + std::to_string(a + n + 2) + " " +
              std::to_string(a + n + 1) + "\n";
    }
  return text;
}

TEST_F(ImproveJob, UntanglesWhateverMayMove) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
    const ImproveResult result =
        improve_mesh({.input = folder_.file("in.obj", tangled_square(16, 4, seed))}, {});
    EXPECT_GT(result.invalid, 50U) << seed;
    EXPECT_EQ(validate(result.mesh, GeometryCheck::kPlanarCorners), "") << seed;
  }
}

TEST_F(ImproveJob, LetsVerticesSlideAlongStraightSidesWhereItUntangles) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
    const ImproveResult result =
        improve_mesh({.input = folder_.file("in.obj", tangled_square(16, 4, seed, 0.9))}, {});
    EXPECT_GT(result.invalid, 50U) << seed;
    EXPECT_EQ(validate(result.mesh, GeometryCheck::kPlanarCorners), "") << seed;
    EXPECT_EQ(result.pieces, 4U) << seed;
    double least = 16;
    for (const VertexId v : result.mesh.vertices()) {
      if (!result.mesh.on_boundary(v)) continue;
      const Vec2 p = result.mesh.point(v);
      EXPECT_TRUE(p.x == 0 || p.x == 16 || p.y == 0 || p.y == 16) << seed << ": " << p.x << " " << p.y;
    }
    for (const EdgeId e : result.mesh.edges()) {
      const auto [a, b] = result.mesh.edge_ends(e);
      least = std::min(least, distance(result.mesh.point(a), result.mesh.point(b)));
    }
    EXPECT_GT(least, 0.3) << "sides were as short as 0.1, seed " << seed;
  }
}

TEST_F(ImproveJob, SaysWhereAMeshStaysInvalid) {
  // A corner of the boundary that is reflex within one quad: no vertex may move.
  expect_error(folder_.file("a.obj", "v 0 0\nv 2 0\nv 0.5 0.5\nv 0 2\nf 1 2 3 4\n"), ErrorKind::kGeometry,
               "1 faces cannot be made valid");
}

TEST_F(ImproveJob, CutsAQuadThatCannotBeMadeValidIfTrianglesAreWelcome) {
  const std::string path = folder_.file("a.obj", "v 0 0\nv 2 0\nv 0.5 0.5\nv 0 2\nf 1 2 3 4\n");
  const ImproveResult result = improve_mesh({.input = path, .mixed_quality = 0.3}, {});
  EXPECT_EQ(result.low_quads.cut, 1U);
  EXPECT_EQ(validate(result.mesh, GeometryCheck::kPlanarCorners), "");
}

TEST_F(ImproveJob, KeepsTaggedEdgesOfQuadsThatItCuts) {
  // The first quad has a corner of nearly half a turn, where the boundary bends.
  const std::string path = folder_.file("a.obj",
                                        "v 0 0\nv 1 -0.05\nv 2 0\nv 1 1\nv 2.6 1.8\nv 3 0.4\nf 1 2 3 4\nf 3 "
                                        "6 5 4\ng line_2\nl 3 4\ng line_7\nl "
                                        "2 3\n");
  const ImproveResult result = improve_mesh({.input = path, .mixed_quality = 0.3}, {});
  EXPECT_EQ(result.low_quads.cut, 1U);
  EXPECT_EQ(summarize_quality(result.mesh).quads.faces, 1U);
  EXPECT_EQ(validate(result.mesh, GeometryCheck::kPlanarCorners), "");
  const Lengths lengths = edge_lengths(result.mesh);
  EXPECT_NEAR(lengths.at({2, 1}), std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(lengths.at({7, 2}), std::hypot(1.0, 0.05), 1e-12);
}

TEST_F(ImproveJob, RefusesMeshesWithoutFaces) {
  expect_error(folder_.file("b.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n"), ErrorKind::kGeometry, "no face");
}

TEST_F(ImproveJob, RefusesAnEdgeOfThreeFacesWithItsPlace) {
  expect_error(folder_.file("a.obj", "v 0 0\nv 1 0\nv 0 1\nv 0 -1\nv 1 2\nf 1 2 3\nf 2 1 4\nf 1 2 5\n"),
               ErrorKind::kInput, "(0, 0) - (1, 0)");
}

// Two quads over a line of the old format of Gmsh, beside a third.
TEST_F(ImproveJob, KeepsTheNamesOfGroups) {
  const std::string path = folder_.file(
      "a.msh",
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n1 5 \"main fault\"\n2 6 \"rock\"\n2 7 "
      "\"ore\"\n"
      "$EndPhysicalNames\n$Nodes\n8\n1 0 0 0\n2 1 0 0\n3 2 0 0\n4 3 0 0\n5 0 1 0\n6 1 1 0\n7 2 1 0\n8 3 1 0\n"
      "$EndNodes\n$Elements\n4\n1 1 2 5 1 2 6\n2 3 2 6 1 1 2 6 5\n3 3 2 6 1 2 3 7 6\n4 3 2 7 2 3 4 8 7\n"
      "$EndElements\n");
  const ImproveResult result = improve_mesh({.input = path}, {});
  const std::string out = folder_.file("out.msh");
  write_mesh(out, result.mesh, {.names = result.names});
  const ReadCells cells = read_cells(out);
  EXPECT_EQ(cells.names.lines.at(0), "main fault");
  EXPECT_EQ(cells.names.regions.at(0), "rock");
  EXPECT_EQ(cells.names.regions.at(1), "ore");
  EXPECT_EQ(std::count(cells.constraints.begin(), cells.constraints.end(), 0), 1);
}

TEST_F(ImproveJob, LeavesOutLinesBetweenPointsOfNoFace) {
  const ImproveResult result =
      improve_mesh({.input = folder_.file("a.obj",
                                          "v 0 0\nv 1 0\nv 1 1\nv 0 1\nv 9 9\nv 8 9\nf 1 2 3 4\n"
                                          "g line_2\nl 5 6\nl 1 2\n")},
                   {});
  ASSERT_EQ(result.notes.size(), 1U);
  EXPECT_NE(result.notes[0].find("1 lines join points that belong to no face"), std::string::npos);
  EXPECT_EQ(edge_lengths(result.mesh).at({2, 2}), 1.0);
}

// A point at `well`; a zone for each of the two regions, but for three faces of the first; two box sides; an
// aperture for line 5.
Mesh make_grouped_sample(VertexId well, const SampleMesh& sample) {
  Mesh mesh = make_sample_mesh(sample);
  mesh.add_tag<VertexId, std::int32_t>(kPointTag, -1)[well] = 3;
  const MeshFileTags tags(mesh);
  auto zone = mesh.add_tag<FaceId, std::int32_t>(kZoneTag, -1);
  for (const FaceId f : mesh.faces()) zone[f] = f.value() < 3 ? -1 : 1 - tags.region(f);
  auto side = mesh.add_tag<EdgeId, std::int32_t>(kBoxSideTag, -1);
  auto aperture = mesh.add_tag<EdgeId, double>(kApertureTag, std::nan(""));
  for (const EdgeId e : mesh.edges()) {
    const auto [a, b] = mesh.edge_ends(e);
    if (tags.constraint(e) == -1) side[e] = std::max(mesh.point(a).x, mesh.point(b).x) == 0 ? 0 : 1;
    if (tags.constraint(e) == 5) aperture[e] = 0.125;
  }
  return mesh;
}

TEST_F(ImproveJob, KeepsPointsInTheirPlacesAndGroupsWithTheirRegionsAndLines) {
  const SampleMesh sample{.size = 24, .disorder = 0.6};
  const VertexId well(sample_vertex(sample, 5, 7));
  const Mesh before = make_grouped_sample(well, sample);
  write_mesh(folder_.file("in.vtu"), before,
             {.groups = {{kZoneTag, {"east", "west"}}, {kBoxSideTag, {"left", "right"}}}});
  const ImproveResult result = improve_mesh({.input = folder_.file("in.vtu")}, {});
  const Mesh& mesh = result.mesh;
  EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
  EXPECT_EQ(result.groups.size(), 2U);
  expect_near(edge_lengths(mesh), edge_lengths(before));
  for (const char* const tag : {"region", kZoneTag}) expect_near(areas_by(mesh, tag), areas_by(before, tag));

  const auto point = mesh.find_tag<VertexId, std::int32_t>(kPointTag);
  for (const VertexId v : mesh.vertices()) EXPECT_EQ(point[v], mesh.point(v) == before.point(well) ? 3 : -1);
  EXPECT_EQ(std::ranges::count(point.values(), 3), 1);
  const auto side = mesh.find_tag<EdgeId, std::int32_t>(kBoxSideTag);
  const auto aperture = mesh.find_tag<EdgeId, double>(kApertureTag);
  const MeshFileTags tags(mesh);
  for (const EdgeId e : mesh.edges()) {
    const auto [a, b] = mesh.edge_ends(e);
    const bool left = std::max(mesh.point(a).x, mesh.point(b).x) == 0;
    EXPECT_EQ(side[e], tags.constraint(e) == -1 ? (left ? 0 : 1) : -1);
    EXPECT_EQ(aperture[e] == 0.125, tags.constraint(e) == 5);
  }
}

}  // namespace
}  // namespace quarry
