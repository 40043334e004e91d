#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "engine/base/random.hpp"
#include "engine/mesh/validate.hpp"
#include "engine/parallel/parallel.hpp"
#include "io/mesh/mesh_format.hpp"
#include "pipeline/improve/improve.hpp"
#include "tests/io/mesh/sample_mesh.hpp"
#include "tests/io/mesh/tag_measures.hpp"
#include "tests/io/mesh/temporary_folder.hpp"
#include "tests/pipeline/improve/improve_checks.hpp"

namespace quarry {
namespace {

// Points and faces in the words of an .obj.
class Cells {
 public:
  // From 1.
  std::uint32_t point(Vec3 p) {
    text_ += fmt::format("v {:.17g} {:.17g} {:.17g}\n", p.x, p.y, p.z);
    return ++points_;
  }
  void face(std::initializer_list<std::uint32_t> corners) {
    text_ += "f";
    for (const std::uint32_t corner : corners) text_ += fmt::format(" {}", corner);
    text_ += "\n";
  }
  void more(const std::string& lines) { text_ += lines; }

  // n by n quads on place(u, v), u and v from 0 to 1; from(i, j) tells a point that is there already, or 0.
  template <class Place, class From>
  std::vector<std::uint32_t> patch(std::uint32_t n, const Place& place, const From& from) {
    std::vector<std::uint32_t> at;
    for (std::uint32_t j = 0; j <= n; ++j)
      for (std::uint32_t i = 0; i <= n; ++i) {
        const std::uint32_t there = from(i, j);
        at.push_back(there > 0 ? there
                               : point(place(static_cast<double>(i) / n, static_cast<double>(j) / n)));
      }
    for (std::uint32_t j = 0; j < n; ++j)
      for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t k = j * (n + 1) + i;
        face({at[k], at[k + 1], at[k + n + 2], at[k + n + 1]});
      }
    return at;
  }
  template <class Place>
  std::vector<std::uint32_t> patch(std::uint32_t n, const Place& place) {
    return patch(n, place, [](std::uint32_t, std::uint32_t) { return 0U; });
  }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::uint32_t points_ = 0;
};

// The six sides of a cube as patches of n by n quads, whose vertices within are moved about; they share no
// points but by their places.
Cells cube(std::uint32_t n, double disorder, std::uint64_t seed) {
  Cells cells;
  std::uint64_t draw = 0;
  const auto side = [&](Vec3 corner, Vec3 right, Vec3 up) {
    cells.patch(n, [&, right, up](double u, double v) {
      const bool inside = u > 0 && u < 1 && v > 0 && v < 1;
      const double by = inside ? disorder / n : 0;
      const double du = by * (uniform01(seed, draw++) - 0.5), dv = by * (uniform01(seed, draw++) - 0.5);
      return corner + (u + du) * right + (v + dv) * up;
    });
  };
  const Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, o{};
  side(o, y, x);
  side(o, x, z);
  side(o, z, y);
  side(z, x, y);
  side(x, y, z);
  side(y, z, x);
  return cells;
}

// How often an edge, by the places of its ends, is a side of a face.
std::map<std::array<double, 6>, int> uses_of_edges(const Mesh& mesh) {
  std::map<std::array<double, 6>, int> uses;
  for (const FaceId f : mesh.faces())
    for (int k = 0; k < mesh.corner_count(f); ++k) {
      const SideId s(f, k);
      const Vec3 a = mesh.point3(mesh.origin(s)), b = mesh.point3(mesh.target(s));
      const bool forward = std::array{a.x, a.y, a.z} < std::array{b.x, b.y, b.z};
      ++uses[forward ? std::array{a.x, a.y, a.z, b.x, b.y, b.z} : std::array{b.x, b.y, b.z, a.x, a.y, a.z}];
    }
  return uses;
}

class ImproveSurfaceFormats : public testing::TestWithParam<const char*> {
 protected:
  [[nodiscard]] ImproveResult improved(const SampleMesh& sample) const {
    const std::string path = folder_.file(std::string("in") + GetParam());
    write_mesh(path, make_sample_mesh(sample), {});
    return improve_mesh({.input = path}, {});
  }
  TemporaryFolder folder_;
};

constexpr SampleMesh kHills{.size = 24, .disorder = 0.6, .corner = {6.7e6, 10}, .relief = 0.05};

TEST_P(ImproveSurfaceFormats, KeepRegionsAndTaggedEdges) {
  const Mesh before = make_sample_mesh(kHills);
  const ImproveResult result = improved(kHills);
  EXPECT_EQ(validate(result.mesh, GeometryCheck::kNone), "");
  expect_near(areas_by(result.mesh, "region"), areas_by(before, "region"), 0.01);
  expect_near(edge_lengths(result.mesh), edge_lengths(before), 1e-6);
}

TEST_P(ImproveSurfaceFormats, GetBetterFacesOnTheSurface) {
  const ImproveResult result = improved(kHills);
  const QualitySummary after = summarize_quality(result.mesh);
  EXPECT_GT(after.all.scaled_jacobian.min, result.before.all.scaled_jacobian.min);
  EXPECT_GT(after.all.scaled_jacobian.mean, result.before.all.scaled_jacobian.mean);
  for (const VertexId v : result.mesh.vertices()) {
    const Vec3 p = result.mesh.point3(v);
    EXPECT_NEAR(p.z, sample_height(kHills, p.x, p.y), 0.03) << p.x << " " << p.y;
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, ImproveSurfaceFormats, testing::Values(".vtu", ".msh", ".obj", ".inp"),
                         [](const auto& format) { return std::string(format.param + 1); });

class ImproveSurface : public testing::Test {
 protected:
  [[nodiscard]] ImproveResult improved(const Cells& cells, ImproveOptions options = {}) const {
    options.input = folder_.file("in.obj", cells.text());
    return improve_mesh(options, {});
  }
  // As others read it: sheets share their points in a file.
  [[nodiscard]] Mesh written(const ImproveResult& result) const {
    write_mesh(folder_.file("out.obj"), result.mesh, {});
    return read_mesh(folder_.file("out.obj"));
  }
  TemporaryFolder folder_;
};

TEST_F(ImproveSurface, IsTheSameOnAnyNumberOfThreads) {
  const std::string path = folder_.file("in.vtu");
  write_mesh(path, make_sample_mesh({.size = 90, .disorder = 0.7, .relief = 0.04}), {});
  expect_same_bytes_on_threads(folder_, path);
}

TEST_F(ImproveSurface, KeepsTheSharpEdgesOfACubeThoughNoneIsTagged) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const ImproveResult result = improved(cube(8, 0.7, seed));
    EXPECT_EQ(validate(result.mesh, GeometryCheck::kNone), "") << seed;
    EXPECT_EQ(result.sharp_edges, 96U) << seed;
    const QualitySummary after = summarize_quality(result.mesh);
    EXPECT_NEAR(after.area, 6, 1e-9) << seed;
    EXPECT_GT(after.all.scaled_jacobian.min, result.before.all.scaled_jacobian.min) << seed;
    EXPECT_EQ(result.mesh.edge_slots(), 0U) << "what was not tagged is not: seed " << seed;
  }
}

TEST_F(ImproveSurface, RoundsACubeIfNoEdgeIsSharp) {
  const ImproveResult result = improved(cube(8, 0.5, 1), {.input = {}, .sharp_degrees = 180});
  EXPECT_EQ(result.sharp_edges, 0U);
  EXPECT_LT(summarize_quality(result.mesh).area, 6 - 1e-4);
}

TEST_F(ImproveSurface, WeldsPointsAtOnePlaceAndSaysSo) {
  const ImproveResult result = improved(cube(4, 0.3, 1));
  ASSERT_FALSE(result.notes.empty());
  EXPECT_NE(result.notes[0].find("52 points lie where another one does"), std::string::npos)
      << result.notes[0];
  for (const auto& [edge, uses] : uses_of_edges(result.mesh)) EXPECT_EQ(uses, 2);
}

TEST_F(ImproveSurface, TurnsFacesThatLookTheOtherWay) {
  Cells cells;
  const std::array<std::uint32_t, 6> at{cells.point({0, 0, 0}),   cells.point({1, 0, 0.1}),
                                        cells.point({2, 0, 0}),   cells.point({0, 1, 0}),
                                        cells.point({1, 1, 0.1}), cells.point({2, 1, 0})};
  cells.face({at[0], at[1], at[4], at[3]});
  cells.face({at[1], at[4], at[5], at[2]});
  const ImproveResult result = improved(cells);
  EXPECT_EQ(result.turned, 1U);
  ASSERT_EQ(result.notes.size(), 1U);
  EXPECT_NE(result.notes[0].find("1 of 2 faces are turned"), std::string::npos) << result.notes[0];
}

// Two quads have the sides of one corner in common, which lies on a slope.
TEST_F(ImproveSurface, RemovesADoublet) {
  Cells cells;
  const auto height = [](double x, double y) { return 0.3 * x + 0.1 * x * y; };
  const auto lifted = [&](double x, double y) { return Vec3{x, y, height(x, y)}; };
  const auto at = cells.patch(4, [&](double u, double v) { return lifted(4 * u, 4 * v); });
  std::string text = cells.text();
  const std::string quad = fmt::format("f {} {} {} {}\n", at[6], at[7], at[12], at[11]);
  const std::size_t place = text.find(quad);
  ASSERT_NE(place, std::string::npos);
  text.erase(place, quad.size());
  const Vec3 within = lifted(1.4, 1.6);
  text += fmt::format("v {} {} {}\nf {} {} {} 26\nf {} 26 {} {}\n", within.x, within.y, within.z, at[6],
                      at[7], at[12], at[6], at[12], at[11]);
  const ImproveResult result = improve_mesh({.input = folder_.file("in.obj", text)}, {});
  EXPECT_EQ(result.before.quads.faces, 17U);
  EXPECT_EQ(summarize_quality(result.mesh).quads.faces, 16U);
}

TEST_F(ImproveSurface, KeepsSheetsTogetherAlongWhatTheyShare) {
  Cells cells;
  std::uint64_t draw = 0;
  const auto sheet = [&](double angle) {
    return [&draw, angle](double u, double v) {
      const double by = u > 0 && u < 1 && v > 0 && v < 1 ? 0.06 : 0;
      const double r = u + by * (uniform01(7, draw++) - 0.5), s = v + by * (uniform01(7, draw++) - 0.5);
      return Vec3{r * std::cos(angle), r * std::sin(angle), s + 0.1 * std::sin(3 * s) * r};
    };
  };
  const auto first = cells.patch(10, sheet(0));
  for (const double angle : {2.0, 4.1})
    cells.patch(10, sheet(angle),
                [&](std::uint32_t i, std::uint32_t j) { return i == 0 ? first[11 * j] : 0U; });
  const ImproveResult result = improved(cells);
  int branches = 0;
  for (const auto& [edge, uses] : uses_of_edges(written(result))) {
    EXPECT_LE(uses, 3);
    if (uses == 3) ++branches;
  }
  EXPECT_EQ(branches, 10);
  EXPECT_GT(summarize_quality(result.mesh).all.scaled_jacobian.mean, result.before.all.scaled_jacobian.mean);
}

TEST_F(ImproveSurface, TakesABandOfOneSide) {
  Cells cells;
  std::vector<std::uint32_t> rows;
  const int around = 40, across = 6;
  for (int i = 0; i < around; ++i)
    for (int j = 0; j <= across; ++j) {
      const double t = 2 * std::numbers::pi * i / around, w = 0.6 * j / across - 0.3;
      const double r = 1 + w * std::cos(t / 2);
      rows.push_back(cells.point({r * std::cos(t), r * std::sin(t), w * std::sin(t / 2)}));
    }
  const auto at = [&](int i, int j) {
    const int row = i % around, column = i >= around ? across - j : j;
    return rows[static_cast<std::size_t>(row * (across + 1) + column)];
  };
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) cells.face({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  const ImproveResult result = improved(cells);
  const Mesh mesh = written(result);
  int rim = 0;
  for (const auto& [edge, uses] : uses_of_edges(mesh)) rim += uses == 1 ? 1 : 0;
  EXPECT_EQ(rim, 2 * around);
  EXPECT_GE(summarize_quality(mesh).all.scaled_jacobian.min, result.before.all.scaled_jacobian.min);
}

TEST_F(ImproveSurface, TakesTwoBodiesThatTouchInAPoint) {
  Cells cells = cube(4, 0.4, 1);
  Cells other = cube(4, 0.4, 2);
  const std::uint32_t count = 6 * 25;
  std::string text = cells.text();
  for (std::size_t begin = 0; begin < other.text().size();) {
    const std::size_t end = other.text().find('\n', begin);
    const std::string line = other.text().substr(begin, end - begin);
    double x = 0, y = 0, z = 0;
    unsigned a = 0, b = 0, c = 0, d = 0;
    if (std::sscanf(line.c_str(), "v %lf %lf %lf", &x, &y, &z) == 3)
      text += fmt::format("v {:.17g} {:.17g} {:.17g}\n", x + 1, y + 1, z + 1);
    else if (std::sscanf(line.c_str(), "f %u %u %u %u", &a, &b, &c, &d) == 4)
      text += fmt::format("f {} {} {} {}\n", a + count, b + count, c + count, d + count);
    begin = end + 1;
  }
  const ImproveResult result = improve_mesh({.input = folder_.file("in.obj", text)}, {});
  EXPECT_EQ(validate(result.mesh, GeometryCheck::kNone), "");
  EXPECT_NEAR(summarize_quality(result.mesh).area, 12, 1e-9);
}

TEST_F(ImproveSurface, KeepsPointsAndTaggedEdgesThatAreNoSides) {
  const SampleMesh sample{.size = 12, .disorder = 0.5, .relief = 0.05};
  Mesh before = make_sample_mesh(sample);
  const VertexId well(sample_vertex(sample, 4, 7));
  before.add_tag<VertexId, std::int32_t>(kPointTag, -1)[well] = 3;
  const VertexId a(sample_vertex(sample, 2, 2)), b(sample_vertex(sample, 4, 3));
  const EdgeId apart = before.add_edge(a, b);
  before.find_tag<EdgeId, std::int32_t>("constraint")[apart] = 9;
  write_mesh(folder_.file("in.vtu"), before, {});
  const ImproveResult result = improve_mesh({.input = folder_.file("in.vtu")}, {});
  const Mesh& mesh = result.mesh;
  const auto point = mesh.find_tag<VertexId, std::int32_t>(kPointTag);
  ASSERT_TRUE(point.valid());
  for (const VertexId v : mesh.vertices())
    EXPECT_EQ(point[v], mesh.point3(v) == before.point3(well) ? 3 : -1);
  EXPECT_EQ(std::ranges::count(point.values(), 3), 1);
  const MeshFileTags tags(mesh);
  int kept = 0;
  for (const EdgeId e : mesh.edges())
    if (tags.constraint(e) == 9) {
      const auto [from, to] = mesh.edge_ends(e);
      EXPECT_TRUE((mesh.point3(from) == before.point3(a) && mesh.point3(to) == before.point3(b)) ||
                  (mesh.point3(from) == before.point3(b) && mesh.point3(to) == before.point3(a)));
      ++kept;
    }
  EXPECT_EQ(kept, 1);
}

TEST_F(ImproveSurface, MakesTrianglesOfQuadsWithTwoCornersAtOnePlace) {
  Cells cells;
  const auto dome = [](double u, double v) {
    const double r = std::sin(0.5 * v), t = 2 * std::numbers::pi * u;
    return Vec3{r * std::cos(t), r * std::sin(t), std::cos(0.5 * v)};
  };
  const std::uint32_t n = 12;
  cells.patch(n, dome);
  const ImproveResult result = improved(cells);
  EXPECT_EQ(result.before.triangles.faces, n);
  EXPECT_EQ(result.before.quads.faces, n * (n - 1));
  EXPECT_EQ(validate(result.mesh, GeometryCheck::kNone), "");
}

TEST_F(ImproveSurface, LeavesNoInvertedFaceBehind) {
  SampleMesh sample{.size = 10, .disorder = 0.2, .triangles = false, .relief = 0.05};
  Mesh mesh = make_sample_mesh(sample);
  const VertexId v(sample_vertex(sample, 4, 4));
  mesh.set_point3(v, {5.3, 5.2, sample_height(sample, 5.3, 5.2)});
  write_mesh(folder_.file("in.vtu"), mesh, {});
  const ImproveResult result = improve_mesh({.input = folder_.file("in.vtu")}, {});
  EXPECT_GT(result.invalid, 0U);
  EXPECT_GT(summarize_quality(result.mesh).all.scaled_jacobian.min, 0.2);
}

TEST_F(ImproveSurface, UntanglesOnAFlatSideBesideSharpEdges) {
  Cells cells = cube(10, 0, 1);
  // A point of the first side goes over its neighbour, two rows from an edge.
  std::string text = cells.text();
  const std::string from = fmt::format("v {:.17g} {:.17g} {:.17g}\n", 0.2, 0.4, 0.0);
  const std::size_t place = text.find(from);
  ASSERT_NE(place, std::string::npos);
  text.replace(place, from.size(), "v 0.33 0.42 0\n");
  const ImproveResult result = improve_mesh({.input = folder_.file("in.obj", text)}, {});
  EXPECT_GT(result.invalid, 0U);
  const QualitySummary after = summarize_quality(result.mesh);
  EXPECT_NEAR(after.area, 6, 1e-9);
  EXPECT_GT(after.all.scaled_jacobian.min, 0.2);
}

TEST_F(ImproveSurface, LeavesAStepOfOneFaceAsItIs) {
  Cells cells;
  const std::uint32_t n = 10;
  const auto floor = cells.patch(n, [](double u, double v) { return Vec3{10 * u - 10, 10 * v, 0}; });
  const auto tread = cells.patch(n, [](double u, double v) { return Vec3{10 * u, 10 * v, 0.2}; });
  for (std::uint32_t j = 0; j < n; ++j)
    cells.face({floor[11 * j + 10], tread[11 * j], tread[11 * j + 11], floor[11 * j + 21]});
  const ImproveResult result = improved(cells);
  EXPECT_EQ(result.invalid, 0U);
  EXPECT_NEAR(summarize_quality(result.mesh).area, 202, 1e-9);
  for (const VertexId v : result.mesh.vertices()) {
    const double z = result.mesh.point3(v).z;
    EXPECT_TRUE(z == 0 || z == 0.2) << z;
  }
}

TEST_F(ImproveSurface, CountsAnEdgeOnceOnWhichAFinStands) {
  Cells cells;
  const auto at = cells.patch(3, [](double u, double v) { return Vec3{3 * u, 3 * v, 0.1 * u * v}; });
  const std::uint32_t a = cells.point({1, 1, 1}), b = cells.point({2, 1, 1});
  cells.face({at[5], at[6], b, a});
  cells.more(fmt::format("g line_7\nl {} {}\n", at[5], at[6]));
  const ImproveResult result = improved(cells);
  const MeshFileTags tags(result.mesh);
  int tagged = 0, rims = 0;
  for (const EdgeId e : result.mesh.edges()) {
    tagged += tags.constraint(e) == 7 ? 1 : 0;
    rims += tags.kind(e) == kOuterBoundary ? 1 : 0;
  }
  EXPECT_EQ(tagged, 1);
  EXPECT_EQ(rims, 12 + 3);
}

TEST_F(ImproveSurface, KeepsBordersOfRegionsThatNoEdgeTells) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const SampleMesh sample{.size = 20, .disorder = 0.6, .seed = seed, .relief = 0.05};
    Mesh before = make_sample_mesh(sample);
    auto region = before.find_tag<FaceId, std::int32_t>("region");
    for (const FaceId f : before.faces()) region[f] = f.value() < 150 ? -1 : 4;
    write_mesh(folder_.file("in.vtu"), before, {});
    const ImproveResult result = improve_mesh({.input = folder_.file("in.vtu")}, {});
    expect_near(areas_by(result.mesh, "region"), areas_by(before, "region"), 0.02);
  }
}

TEST_F(ImproveSurface, PassesOverPointsOfNoFace) {
  const Cells cells = cube(6, 0.5, 1);
  const ImproveResult alone = improved(cells);
  const ImproveResult result =
      improve_mesh({.input = folder_.file("b.obj", cells.text() + "v 1e12 0 0\nv 5 5 5\n")}, {});
  EXPECT_EQ(result.tolerance, alone.tolerance);
  EXPECT_EQ(result.mesh.vertex_slots(), alone.mesh.vertex_slots());
  const ImproveResult flat = improve_mesh(
      {.input = folder_.file("c.obj", "v 0 0\nv 1 0\nv 1 1\nv 0 1\nv 3 3 3\nf 1 2 3 4\n"), .size = 0.5}, {});
  EXPECT_TRUE(flat.mesh.planar());
}

TEST_F(ImproveSurface, RefusesWhatItCannotDoInOneLine) {
  const std::string slope = folder_.file("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 1\nv 0 1 1\nf 1 2 3 4\n");
  expect_improve_error({.input = slope, .size = 0.5}, ErrorKind::kUsage, "--size is for meshes of the plane");
  expect_improve_error({.input = slope, .irregular_price = "distance"}, ErrorKind::kUsage,
                       "--irregular-price");
  expect_improve_error({.input = slope, .mixed_quality = 0.3}, ErrorKind::kUsage, "--elements mixed");
  expect_improve_error(
      {.input = folder_.file("f.obj", "v 0 0\nv 1 0\nv 1 1\nf 1 2 3\n"), .sharp_degrees = 40},
      ErrorKind::kUsage, "--sharp is for meshes in space");
  expect_improve_error(
      {.input = folder_.file("d.obj", "v 0 0 1\nv 2 0 1\nv 0.5 0.5 1\nv 0 2 1\nf 1 2 3 4\n")},
      ErrorKind::kGeometry, "1 faces cannot be made valid");
  expect_improve_error(
      {.input = folder_.file("b.obj", "v 0 0 0\nv 1 0 0\nv 1 0 0\nv 0 0 1\nv 0 0 1\nf 2 3 4 5\n")},
      ErrorKind::kGeometry, "face 1 has fewer than 4 places");
}

}  // namespace
}  // namespace quarry
