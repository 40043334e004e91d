#include "pipeline/surface/surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <numeric>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "io/mesh/mesh_format.hpp"
#include "kernels/quality/summary.hpp"
#include "pipeline/surface/surface_report.hpp"
#include "surface/model/far_points.hpp"
#include "tests/pipeline/surface/surface_job.hpp"
#include "tests/support/surface_zoo.hpp"

namespace quarry {
namespace {

TEST_F(SurfaceJob, MeetsTheCountWithinFivePerCent) {
  const std::string path = file_of(test::sphere(5));
  for (const Elements elements : {Elements::kQuad, Elements::kTriangle})
    for (const double count : {2000.0, 10'000.0}) {
      const SurfaceResult result = mesh_surface(options_for(path, count, elements), Progress());
      EXPECT_NEAR(static_cast<double>(result.mesh.count_alive_faces()), count, 0.05 * count);
    }
}

TEST_F(SurfaceJob, KeepsTheCornersOfAStripNarrowerThanTwoElements) {
  for (const double width : {0.05, 0.1, 0.2, 0.3})
    for (const SurfaceQuads method : {SurfaceQuads::kField, SurfaceQuads::kCluster}) {
      SurfaceOptions options;
      options.inputs = {file_of(
          test::surface_of({{0, 0, 0}, {1, 0, 0}, {1, width, 0}, {0, width, 0}}, {{0, 1, 2}, {0, 2, 3}}))};
      options.size = 0.1;
      options.method = method;
      EXPECT_NEAR(area_of(mesh_surface(options, Progress()).mesh), width, 1e-9) << width;
    }
}

TEST_F(SurfaceJob, MeshesAHandfulOfCellsWhicheverWayTheyFace) {
  TriangleSurface square = test::terrain(3, 3, [](double, double) { return 0.0; });
  for (int side = 0; side < 2; ++side) {
    SurfaceOptions options;
    options.inputs = {file_of(square)};
    options.size = 1.0 / 6;
    EXPECT_EQ(mesh_surface(options, Progress()).mesh.count_alive_faces(), 36U);
    for (SurfaceTriangle& t : square.triangles) std::swap(t[0], t[1]);
  }
}

TEST_F(SurfaceJob, FollowsTheCurvatureWithinTheError) {
  // Flat on one side, with a ridge on the other.
  const auto ridge = [](double x, double) { return 0.05 / (1 + 400 * (x - 0.8) * (x - 0.8)); };
  SurfaceOptions options;
  options.inputs = {file_of(test::terrain(120, 20, ridge))};
  options.size = 0.06;
  options.curvature = 5e-4;
  const SurfaceResult result = mesh_surface(options, Progress());
  const Mesh& mesh = result.mesh;
  double on_ridge = 0, edges_on_ridge = 0, flat = 0, flat_edges = 0;
  for (const FaceId f : mesh.faces())
    for (int k = 0; k < mesh.corner_count(f); ++k) {
      const Vec3 a = mesh.point3(mesh.origin(SideId(f, k))), b = mesh.point3(mesh.target(SideId(f, k)));
      const double x = 0.5 * (a.x + b.x);
      const bool at_ridge = std::abs(x - 0.8) < 0.03;
      (at_ridge ? on_ridge : flat) += at_ridge || x < 0.4 ? length(b - a) : 0;
      (at_ridge ? edges_on_ridge : flat_edges) += at_ridge || x < 0.4 ? 1 : 0;
    }
  EXPECT_GT(flat / flat_edges, 0.045);
  EXPECT_LT(on_ridge / edges_on_ridge, 0.035);
  EXPECT_GT(summarize_quality(mesh).quads.scaled_jacobian.min, 0.2);
}

TEST_F(SurfaceJob, KeepsLinesAsChainsWithTheirNumbers) {
  const std::string lines = folder_.file("lines.geojson");
  std::ofstream(lines)
      << R"({"type":"MultiLineString","coordinates":[[[0.1,0.2],[0.9,0.7]],[[0.2,0.8],[0.8,0.1]],)"
         R"([[0.5,0.9],[0.55,1.3]],[[3,3],[4,4]]]})";
  const auto hills = [](double x, double y) { return 0.1 * std::sin(6 * x) * std::cos(5 * y); };
  SurfaceOptions options = options_for(file_of(test::terrain(30, 30, hills)), 2000);
  options.lines = {lines};
  const SurfaceResult result = mesh_surface(options, Progress());
  const Mesh& mesh = result.mesh;
  const auto constraint = mesh.find_tag<EdgeId, std::int32_t>("constraint");
  std::array<double, 4> lengths{};
  for (const EdgeId e : mesh.edges()) {
    if (constraint[e] >= 4) continue;
    const auto [a, b] = mesh.edge_ends(e);
    const Vec3 d = mesh.point3(b) - mesh.point3(a);
    lengths.at(static_cast<std::size_t>(constraint[e])) += std::hypot(d.x, d.y);
  }
  EXPECT_NEAR(lengths[0], std::hypot(0.8, 0.5), 0.01);
  EXPECT_NEAR(lengths[1], std::hypot(0.6, 0.7), 0.01);
  EXPECT_NEAR(lengths[2], 0.1 * std::hypot(1, 0.125), 0.01);
  EXPECT_EQ(lengths[3], 0);
  EXPECT_EQ(result.imprint.imprinted, 3U);
  EXPECT_GT(summarize_quality(mesh).quads.scaled_jacobian.min, 0.2);
}

TEST_F(SurfaceJob, TellsWhatBecameOfEachLine) {
  const std::string lines = folder_.file("lines.geojson");
  std::ofstream(lines) << R"({"type":"FeatureCollection","features":[)"
                          R"({"type":"Feature","properties":{"name":"first"},"geometry":)"
                          R"({"type":"LineString","coordinates":[[0.1,0.2],[0.9,0.2]]}},)"
                          R"({"type":"Feature","properties":{},"geometry":{"type":"MultiLineString",)"
                          R"("coordinates":[[[0.1,0.2],[0.9,0.2]],[[0.5,0.4],[0.5,1.4]],[[3,3],[4,4]],)"
                          R"([[0.2,0.5],[0.8,0.5]],[[0.2,0.8],[0.3,0.9]]]}}]})";
  SurfaceOptions options = options_for(file_of(test::terrain(9, 9, [](double, double) { return 0.0; })), 400);
  options.lines = {lines};
  const SurfaceResult result = mesh_surface(options, Progress());
  const JobReport report = report_surface(options, result, summarize_quality(result.mesh));
  const std::vector<LineFate> fates = {LineFate::kJoined,  LineFate::kJoined, LineFate::kClipped,
                                       LineFate::kDropped, LineFate::kSplit,  LineFate::kKept};
  ASSERT_EQ(report.lines.size(), fates.size());
  for (std::size_t i = 0; i < fates.size(); ++i) {
    const LineId line(i);
    EXPECT_EQ(report.lines[line].fate, fates[i]) << i;
    EXPECT_EQ(report.lines[line].why.empty(), i >= 4) << i;
    EXPECT_EQ(std::isnan(report.line_distances[line]), i == 3) << i;
    if (i != 3) {
      EXPECT_LT(report.line_distances[line], 1e-6) << i;
    }
  }
  EXPECT_EQ(report.lines[LineId(1U)].with, std::vector<LineId>{LineId(0U)});
  EXPECT_EQ(report.lines[LineId(4U)].with, std::vector<LineId>{LineId(2U)});
  EXPECT_EQ(report.line_attributes[LineId(0U)].name, "first");
}

TEST_F(SurfaceJob, KeepsGroupsAsRegionsWithTheirNames) {
  TriangleSurface flat = test::terrain(20, 20, [](double, double) { return 0.0; });
  for (std::size_t t = 0; t < flat.triangles.size(); ++t) flat.groups[t] = t < 400 ? 1 : 2;
  for (Vec3& p : flat.points) p.z = 0.01 * p.x * p.y;
  const SurfaceResult result = mesh_surface(options_for(file_of(flat), 500), Progress());
  const auto region = result.mesh.find_tag<FaceId, std::int32_t>("region");
  std::set<std::string> names;
  for (const FaceId f : result.mesh.faces()) {
    const double y =
        result.mesh.point3(result.mesh.corner(f, 0)).y + result.mesh.point3(result.mesh.corner(f, 2)).y;
    ASSERT_TRUE(result.names.regions.contains(region[f]));
    const std::string name = result.names.regions.at(region[f]);
    EXPECT_EQ(name, y < 1 ? "part_1" : "part_2");
    names.insert(name);
  }
  EXPECT_EQ(names.size(), 2U);
}

TEST_F(SurfaceJob, WritesPointsInWhichSheetsMeetOnce) {
  const SurfaceResult result = mesh_surface(options_for(file_of(test::three_sheets()), 600), Progress());
  const std::string path = folder_.file("out.obj");
  write_mesh(path, result.mesh, {});
  const ReadCells cells = read_cells(path);
  std::set<std::tuple<double, double, double>> points;
  for (std::size_t i = 0; i < cells.x.size(); ++i) points.insert({cells.x[i], cells.y[i], cells.z[i]});
  EXPECT_EQ(points.size(), cells.x.size());
  EXPECT_LT(points.size(), result.mesh.count_alive_vertices());
  EXPECT_EQ(points.size(), summarize_quality(result.mesh).vertices);
}

TEST_F(SurfaceJob, HasTheEdgesInWhichSheetsMeetOnceAndNotOnTheOuterBoundary) {
  const SurfaceResult result = mesh_surface(options_for(file_of(test::three_sheets()), 600), Progress());
  const Mesh& mesh = result.mesh;
  const auto kind = mesh.find_tag<EdgeId, std::int32_t>("kind");
  double met = 0, outer = 0;
  for (const EdgeId e : mesh.edges()) {
    const auto [a, b] = mesh.edge_ends(e);
    const double along = length(mesh.point3(b) - mesh.point3(a));
    (kind[e] == kOuterBoundary ? outer : met) += along;
  }
  EXPECT_NEAR(met, 1, 1e-9);
  EXPECT_NEAR(outer, 9, 1e-9);
}

// Of the file: points at one place are one.
int euler_characteristic(const ReadCells& cells) {
  std::set<std::pair<VertexId, VertexId>> edges;
  for (const FaceCorners& face : cells.faces)
    for (std::size_t k = 0; k < 4; ++k) edges.insert(std::minmax(face[k], face[(k + 1) % 4]));
  return static_cast<int>(cells.x.size()) - static_cast<int>(edges.size()) +
         static_cast<int>(cells.faces.size());
}

TEST_F(SurfaceJob, MeshesAOneSidedBandWithoutAGapAtItsSeam) {
  for (const double count : {500.0, 1500.0, 3000.0}) {
    SCOPED_TRACE(count);
    const SurfaceResult result = mesh_surface(options_for(file_of(test::moebius(60)), count), Progress());
    EXPECT_GT(result.repair.seams.count, 0U);
    EXPECT_GT(summarize_quality(result.mesh).quads.scaled_jacobian.min, 0);
    const std::string path = folder_.file("band.obj");
    write_mesh(path, result.mesh, {});
    EXPECT_EQ(euler_characteristic(read_cells(path)), 0);
    EXPECT_EQ(summarize_quality(read_mesh(path)).quads.faces, result.mesh.count_alive_faces());
  }
}

TEST_F(SurfaceJob, MendsTheSizeWhereTheFirstOneMissesTheCount) {
  // With one round 440 and 6,636.
  const std::string path = file_of(test::sphere(5));
  for (const auto& [elements, count] : {std::pair{Elements::kQuad, 500.0}, {Elements::kTriangle, 7000.0}}) {
    const SurfaceResult result = mesh_surface(options_for(path, count, elements), Progress());
    EXPECT_NEAR(static_cast<double>(result.mesh.count_alive_faces()), count, 0.05 * count);
  }
}

bool notes_mention(const SurfaceResult& result, const std::string& words) {
  return std::any_of(result.notes.begin(), result.notes.end(),
                     [&](const std::string& note) { return note.find(words) != std::string::npos; });
}

TEST_F(SurfaceJob, TellsOfCracksThatWeldingWouldClose) {
  // Each triangle with points of its own, rounded apart.
  const TriangleSurface whole = test::sphere(3);
  TriangleSurface cracked;
  for (const SurfaceTriangle& t : whole.triangles) {
    const auto base = static_cast<std::uint32_t>(cracked.points.size());
    for (const std::uint32_t p : t) cracked.points.push_back((1 + 1e-6 * (base % 7)) * whole.points[p]);
    cracked.triangles.push_back({base, base + 1, base + 2});
  }
  cracked.groups.assign(cracked.triangles.size(), 0);
  EXPECT_TRUE(notes_mention(mesh_surface(options_for(file_of(cracked), 2000), Progress()), "--weld"));
  const auto bump = [](double x, double y) { return x * y; };
  EXPECT_FALSE(notes_mention(
      mesh_surface(options_for(file_of(test::terrain(9, 9, bump), "terrain.obj"), 200), Progress()),
      "--weld"));
}

TEST_F(SurfaceJob, TellsWhereElementsAreSmallerThanWantedAndWhy) {
  TriangleSurface plate = test::sphere(5);
  for (Vec3& p : plate.points) p.z *= 0.1;
  EXPECT_TRUE(notes_mention(mesh_surface(options_for(file_of(plate), 800), Progress()),
                            "elements are smaller than wanted on"));
  EXPECT_FALSE(
      notes_mention(mesh_surface(options_for(file_of(test::sphere(5), "ball.obj"), 2000), Progress()),
                    "elements are smaller than wanted on"));
}

TEST_F(SurfaceJob, KeepsToTheEdgeOfABladeAndToTheCount) {
  // Smooth all around, and blunt on the scale of the elements: smoothing drew the mesh back from the edge,
  // and only many times as many elements were valid, if any.
  TriangleSurface blade = test::sphere(5);
  for (Vec3& p : blade.points) p = {10 * p.x, p.y, 0.2 * p.z};
  const SurfaceResult result = mesh_surface(options_for(file_of(blade), 3000), Progress());
  EXPECT_NEAR(static_cast<double>(result.mesh.count_alive_faces()), 3000, 150);
  const QualitySummary quality = summarize_quality(result.mesh);
  EXPECT_GT(quality.quads.scaled_jacobian.mean, 0.88);
  double width = 0;
  for (const VertexId v : result.mesh.vertices()) width = std::max(width, result.mesh.point3(v).y);
  EXPECT_GT(width, 0.97);
}

TEST_F(SurfaceJob, KeepsTheApexOfAConeAndGoodQuadsAroundIt) {
  struct Cone {
    std::uint32_t sectors, rings;
    double height;
  };
  for (const Cone cone : {Cone{64, 1, 2}, Cone{64, 8, 2}, Cone{16, 1, 2}, Cone{64, 1, 6}}) {
    SCOPED_TRACE(cone.height);
    const SurfaceResult result = mesh_surface(
        options_for(file_of(test::cone(cone.sectors, cone.rings, cone.height)), 2000), Progress());
    const QualitySummary quality = summarize_quality(result.mesh);
    EXPECT_GT(quality.quads.scaled_jacobian.mean, 0.97);
    EXPECT_GT(quality.quads.scaled_jacobian.min, 0.1);
    double height = 0;
    for (const VertexId v : result.mesh.vertices()) height = std::max(height, result.mesh.point3(v).z);
    EXPECT_EQ(height, cone.height);
  }
}

// Single vertices used to be brought to such tops, with edges as long as the hills are high.
TEST_F(SurfaceJob, HasElementsAsSmallAsNarrowHillsThatItWouldCutOff) {
  const std::array tops = {Vec3{0.3, 0.3, 0.3}, Vec3{0.7, 0.4, 0.3}, Vec3{0.45, 0.75, 0.3}};
  SurfaceOptions options = options_for(file_of(test::narrow_hills(tops, 0.04)), 0);
  options.count.reset();
  options.size = 0.05;
  const SurfaceResult result = mesh_surface(options, Progress());
  const SurfaceModel model = test::modelled(result.repaired).model;
  std::vector<std::uint32_t> points(model.free_points().size());
  std::iota(points.begin(), points.end(), 0U);
  for (const NearestFace& near : find_nearest_faces(result.mesh, model, points))
    EXPECT_LT(near.distance, 0.3 * *options.size);
}

TEST_F(SurfaceJob, TellsInTheReportWhatWasRepaired) {
  TriangleSurface open = test::sphere(3);
  open.triangles.pop_back();
  open.triangles.push_back(open.triangles.front());
  const SurfaceOptions options = options_for(file_of(open), 800);
  const SurfaceResult result = mesh_surface(options, Progress());
  const JobReport report = report_surface(options, result, summarize_quality(result.mesh));
  ASSERT_FALSE(report.notes.empty());
  EXPECT_NE(report.notes.front().find("twice"), std::string::npos);
  EXPECT_EQ(result.repair.holes, 1U);
}

TEST_F(SurfaceJob, CountsEachPassThatRan) {
  const SurfaceOptions options = options_for(file_of(test::sphere(3)), 800);
  const SurfaceResult result = mesh_surface(options, Progress());
  const JobReport report = report_surface(options, result, summarize_quality(result.mesh));
  ASSERT_EQ(report.passes.size(), result.method == SurfaceQuads::kField ? 6U : 3U);
  for (const PassReport& pass : report.passes) {
    EXPECT_FALSE(pass.name.empty());
    EXPECT_GE(pass.live, pass.won) << pass.name;
  }
  EXPECT_EQ(report.passes[2].name, "flips");
  EXPECT_GT(report.passes[2].rounds, 0U);
}

TEST_F(SurfaceJob, RefusesWhatItCannotMeshInOneLine) {
  SurfaceOptions many = options_for(file_of(test::cube()), 1e6);
  many.max_elements = 1000;
  try {
    (void)mesh_surface(many, Progress());
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kBudget);
  }
  const std::string flat =
      file_of(test::surface_of({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2}}), "flat.obj");
  try {
    (void)mesh_surface(options_for(flat, 100), Progress());
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kGeometry);
  }
}

TEST_F(SurfaceJob, OfQuadsFollowsAFieldWithFewerIrregularVerticesThanClusters) {
  SurfaceOptions options = options_for(file_of(test::sphere(5)), 4000);
  const SurfaceResult field = mesh_surface(options, Progress());
  options.method = SurfaceQuads::kCluster;
  const SurfaceResult cluster = mesh_surface(options, Progress());
  EXPECT_EQ(field.method, SurfaceQuads::kField);
  EXPECT_EQ(cluster.method, SurfaceQuads::kCluster);
  EXPECT_LT(summarize_quality(field.mesh).valence.irregular_share(),
            summarize_quality(cluster.mesh).valence.irregular_share());
  EXPECT_GT(summarize_quality(field.mesh).quads.scaled_jacobian.mean, 0.98);
}

// A band that meanders: a terrain of columns x rows cells bent along a course whose direction swings by so
// many radians, until neighbouring turns nearly touch. Its rims are features, and coarse elements have all
// their corners there.
TriangleSurface meander(double swing, double waves, double width) {
  constexpr std::uint32_t kColumns = 200, kRows = 6;
  constexpr double kLength = 10;
  TriangleSurface band = test::terrain(kColumns, kRows, [](double, double) { return 0.0; });
  Vec3 at;
  for (std::uint32_t i = 0; i <= kColumns; ++i) {
    const double turn = swing * std::sin(waves * kLength * i / kColumns);
    if (i > 0) at = at + (kLength / kColumns) * Vec3{std::cos(turn), 0, std::sin(turn)};
    for (std::uint32_t j = 0; j <= kRows; ++j)
      band.points[j * (kColumns + 1) + i] = at + Vec3{0, width * j / kRows, 0};
  }
  return band;
}

// Elements that are longer than the turns are far apart lie on the wrong ones: then there is no mesh.
TEST_F(SurfaceJob, MeshesBandsThatTurnBackValidlyOrNotHoweverCoarsely) {
  const std::vector<std::tuple<double, double, double, double>> cases = {
      {1.2, 7, 0.6, 60}, {2, 7, 2, 20},      {2, 7, 2, 60},      {2.3, 2, 2, 60},
      {2.3, 4, 0.6, 60}, {2.3, 4, 0.6, 200}, {2.3, 4, 0.6, 600}, {2.3, 4, 2, 60}};
  for (const auto& [swing, waves, width, count] : cases) {
    const std::string path = file_of(meander(swing, waves, width));
    try {
      const SurfaceResult result = mesh_surface(options_for(path, count), Progress());
      EXPECT_GT(summarize_quality(result.mesh).quads.scaled_jacobian.min, 0)
          << swing << " " << waves << " " << count;
      EXPECT_EQ(count_invalid(result), 0U) << swing << " " << waves << " " << count;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kGeometry);
      EXPECT_GT(swing, 1.2) << "the turns are far apart";
    }
  }
}

// Strips of regions that are narrower than two elements: a lattice has as many rows as there are strips.
TEST_F(SurfaceJob, WithFeaturesTooNearForALatticeClustersAndSaysSo) {
  TriangleSurface strips = test::terrain(40, 40, [](double, double) { return 0.0; });
  for (std::size_t t = 0; t < strips.groups.size(); ++t)
    strips.groups[t] = static_cast<std::int32_t>(t / 80 % 2);
  const SurfaceResult result = mesh_surface(options_for(file_of(strips), 600), Progress());
  EXPECT_EQ(result.method, SurfaceQuads::kCluster);
  ASSERT_EQ(result.notes.size(), 2U);
  EXPECT_NE(result.notes[0].find("--quads cluster"), std::string::npos);
  EXPECT_EQ(result.notes[1].find("--count asks for 600 elements"), 0U) << result.notes[1];
  EXPECT_GT(summarize_quality(result.mesh).quads.scaled_jacobian.min, 0);
}

}  // namespace
}  // namespace quarry
