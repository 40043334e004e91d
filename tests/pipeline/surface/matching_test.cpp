// The surface job with --quads matching, rims that keep their vertices, and sheets that meet.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "engine/base/error.hpp"
#include "engine/mesh/validate.hpp"
#include "engine/parallel/parallel.hpp"
#include "io/mesh/mesh_format.hpp"
#include "kernels/quality/summary.hpp"
#include "tests/pipeline/surface/surface_job.hpp"
#include "tests/support/mesh_arrays.hpp"
#include "tests/support/surface_zoo.hpp"

namespace quarry {
namespace {

SurfaceOptions matching_for(const std::string& path, double count) {
  SurfaceOptions options = options_for(path, count);
  options.method = SurfaceQuads::kMatching;
  return options;
}

// Of radius 1 and height 2, open at both ends.
TriangleSurface tube(std::uint32_t around, std::uint32_t along) {
  TriangleSurface s = test::terrain(around, along, [](double, double) { return 0.0; });
  for (std::size_t i = 0; i < s.points.size(); ++i) {
    const double turn = 2 * std::numbers::pi * static_cast<double>(i % (around + 1) % around) / around;
    s.points[i] = {std::cos(turn), std::sin(turn), 2 * s.points[i].y};
  }
  return s;
}

// Three sheets of different widths, cut into cells.
TriangleSurface uneven_sheets() {
  TriangleSurface s = test::three_sheets();
  for (const std::size_t i : {2U, 3U}) s.points[i] = {1.7, 0.1, s.points[i].z};
  s.groups.assign(s.triangles.size(), 0);
  return s;
}

using Place = std::tuple<double, double, double>;
Place place_of(Vec3 p) { return {p.x, p.y, p.z}; }

std::set<Place> rim_of(const Mesh& mesh) {
  std::set<Place> rim;
  for (const VertexId v : mesh.vertices())
    if (mesh.alive(v) && mesh.on_boundary(v)) rim.insert(place_of(mesh.point3(v)));
  return rim;
}

void expect_good_quads(const SurfaceResult& result, double count) {
  EXPECT_EQ(result.method, SurfaceQuads::kMatching);
  EXPECT_NEAR(static_cast<double>(result.mesh.count_alive_faces()), count, 0.05 * count);
  EXPECT_EQ(validate(result.mesh, GeometryCheck::kNone), "");
  for (const FaceId f : result.mesh.faces()) ASSERT_EQ(result.mesh.corner_count(f), 4);
  EXPECT_EQ(count_invalid(result), 0U);
  const QualitySummary quality = summarize_quality(result.mesh);
  EXPECT_GT(quality.quads.scaled_jacobian.min, 0.2);
  EXPECT_GT(quality.quads.scaled_jacobian.mean, 0.94);
}

TEST_F(SurfaceJob, ByMatchingMakesGoodQuadsOfClosedOpenAndCreasedSurfaces) {
  for (const TriangleSurface& surface : {test::sphere(4), tube(40, 13), test::cube()}) {
    const SurfaceResult result = mesh_surface(matching_for(file_of(surface), 3000), Progress());
    expect_good_quads(result, 3000);
    EXPECT_GT(result.quads.matching.quads, 0U);
  }
}

TEST_F(SurfaceJob, ByMatchingHalvesNoEdgeButForParity) {
  SurfaceOptions options = matching_for(file_of(test::cube()), 3000);
  options.cleanup = CleanUpLevel::kNone;
  const SurfaceResult result = mesh_surface(options, Progress());
  EXPECT_LE(result.quads.matching.parity.halved_edges, 6U);
  EXPECT_NEAR(static_cast<double>(result.mesh.count_alive_faces()), 3000, 0.05 * 3000);
  EXPECT_LT(static_cast<double>(result.quads.matching.steiner_points), 0.02 * 3000);
}

TEST_F(SurfaceJob, ByMatchingWithAnnealingHasFewerSteinerPoints) {
  SurfaceOptions options = matching_for(file_of(test::sphere(4)), 2500);
  options.cleanup = CleanUpLevel::kNone;
  const SurfaceResult plain = mesh_surface(options, Progress());
  options.anneal = 100;
  const SurfaceResult annealed = mesh_surface(options, Progress());
  EXPECT_GT(annealed.quads.matching.search.annealing_moves, 0U);
  EXPECT_LT(annealed.quads.matching.steiner_points, plain.quads.matching.steiner_points);
  EXPECT_EQ(test::arrays_of(mesh_surface(options, Progress()).mesh), test::arrays_of(annealed.mesh));
  options.seed = 7;
  EXPECT_NE(test::arrays_of(mesh_surface(options, Progress()).mesh), test::arrays_of(annealed.mesh));
}

TEST_F(SurfaceJob, ByMatchingGivesTheSameMeshOnAnyNumberOfThreads) {
  const std::string path = file_of(tube(41, 13));
  std::vector<std::uint64_t> serial;
  for (const int threads : {1, 2, 4, 7}) {
    const parallel::ParticipationProbe probe;
    parallel::with_threads(threads, [&] {
      const SurfaceResult result = mesh_surface(matching_for(path, 2500), Progress());
      if (threads == 1) serial = test::arrays_of(result.mesh);
      EXPECT_EQ(test::arrays_of(result.mesh), serial) << threads;
    });
    if (threads > 1) {
      EXPECT_GT(probe.chunks_of_other_threads(), 0U);
    }
  }
}

TEST_F(SurfaceJob, KeepsTheVerticesOfRimsIfAsked) {
  const TriangleSurface surface = tube(40, 13);
  for (const double count : {1000.0, 4000.0}) {
    SurfaceOptions options = matching_for(file_of(surface), count);
    options.keep_boundary = true;
    const SurfaceResult result = mesh_surface(options, Progress());
    std::set<Place> ends;
    for (const Vec3 p : surface.points)
      if (p.z == 0 || p.z == 2) ends.insert(place_of(p));
    EXPECT_EQ(rim_of(result.mesh), ends) << count;
    EXPECT_EQ(count_invalid(result), 0U);
    for (const FaceId f : result.mesh.faces()) ASSERT_EQ(result.mesh.corner_count(f), 4);
  }
}

void expect_refusal(const SurfaceOptions& options, const std::string& part) {
  try {
    (void)mesh_surface(options, Progress());
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kGeometry);
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

TEST_F(SurfaceJob, RefusesToKeepARimWhoseEdgesAreFarLongerThanElements) {
  SurfaceOptions options = matching_for(
      file_of(test::surface_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}})), 100);
  options.keep_boundary = true;
  expect_refusal(options, "rims up to 1 long");
}

TEST_F(SurfaceJob, RefusesToKeepAnOddRimOfQuads) {
  TriangleSurface open = test::sphere(4);
  open.triangles.pop_back();
  open.groups.pop_back();
  SurfaceOptions options = matching_for(file_of(open), 1000);
  options.keep_boundary = true;
  expect_refusal(options, "3 sides");
  options.keep_boundary = false;
  EXPECT_EQ(count_invalid(mesh_surface(options, Progress())), 0U);
}

// A strip of regions is narrower than an element: nothing but its two long sides could be halved.
TEST_F(SurfaceJob, ByMatchingIsValidWhereFeaturesAreNarrowerThanAnElement) {
  TriangleSurface strips = test::terrain(40, 40, [](double, double) { return 0.0; });
  for (std::size_t t = 0; t < strips.groups.size(); ++t)
    strips.groups[t] = static_cast<std::int32_t>(t / 80 % 5 == 0 ? 1 : 0);
  const SurfaceResult result = mesh_surface(matching_for(file_of(strips), 800), Progress());
  EXPECT_EQ(count_invalid(result), 0U);
  for (const FaceId f : result.mesh.faces()) ASSERT_EQ(result.mesh.corner_count(f), 4);
  // What was made in another way is told.
  EXPECT_TRUE(result.method == SurfaceQuads::kMatching || !result.notes.empty());
}

// Of each edge in the common line of the sheets, how many faces have it in the file.
std::map<std::pair<double, double>, int> faces_along_join(const std::string& path) {
  const ReadCells cells = read_cells(path);
  std::map<std::pair<double, double>, int> faces;
  for (const FaceCorners& corners : cells.faces)
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t a = corners[k].value(), b = corners[(k + 1) % 4].value();
      if (cells.x[a] == 0 && cells.y[a] == 0 && cells.x[b] == 0 && cells.y[b] == 0)
        ++faces[std::minmax(cells.z[a], cells.z[b])];
    }
  return faces;
}

TEST_F(SurfaceJob, DividesWhatSheetsShareAlikeOnAllOfThem) {
  for (const SurfaceQuads method : {SurfaceQuads::kMatching, SurfaceQuads::kCluster})
    for (const double count : {10.0, 20.0, 120.0, 900.0}) {
      SurfaceOptions options = options_for(file_of(uneven_sheets()), count);
      options.method = method;
      const SurfaceResult result = mesh_surface(options, Progress());
      EXPECT_EQ(result.method, method);
      const std::string path = folder_.file("out.obj");
      write_mesh(path, result.mesh, {});
      const auto faces = faces_along_join(path);
      EXPECT_FALSE(faces.empty());
      for (const auto& [edge, number] : faces)
        EXPECT_EQ(number, 3) << edge.first << " to " << edge.second << " of " << count << " by "
                             << name_of(method);
    }
}

}  // namespace
}  // namespace quarry
