// The section job with --elements mixed: the mesh of quads, in which low quads are cut where that helps.
#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "engine/mesh/validate.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/quality/face.hpp"
#include "kernels/quality/summary.hpp"
#include "pipeline/section/section.hpp"
#include "tests/io/mesh/temporary_folder.hpp"
#include "tests/pipeline/section/sample_lines.hpp"
#include "tests/support/mesh_arrays.hpp"

namespace quarry {
namespace {

// The corners of a face in the order of their places: its name in meshes with other numbers.
using Corners = std::vector<std::pair<double, double>>;

Corners corners_of(const Mesh& mesh, FaceId f) {
  Corners corners;
  for (int k = 0; k < mesh.corner_count(f); ++k)
    corners.emplace_back(mesh.point(mesh.corner(f, k)).x, mesh.point(mesh.corner(f, k)).y);
  std::sort(corners.begin(), corners.end());
  return corners;
}

// The better of the two cuts, by the scaled Jacobian of its worse triangle.
double better_cut(const Mesh& mesh, FaceId f) {
  std::array<Vec2, 4> p;
  for (int k = 0; k < 4; ++k) p[static_cast<std::size_t>(k)] = mesh.point(mesh.corner(f, k));
  return std::max(std::min(scaled_jacobian(p[0], p[1], p[2]), scaled_jacobian(p[0], p[2], p[3])),
                  std::min(scaled_jacobian(p[1], p[2], p[3]), scaled_jacobian(p[1], p[3], p[0])));
}

// How long the edges of each input line are.
std::map<std::int32_t, double> line_lengths(const Mesh& mesh) {
  std::map<std::int32_t, double> lengths;
  const auto constraint = mesh.find_tag<EdgeId, std::int32_t>("constraint");
  for (const EdgeId e : mesh.edges()) {
    const auto [a, b] = mesh.edge_ends(e);
    lengths[constraint[e]] += distance(mesh.point(a), mesh.point(b));
  }
  return lengths;
}

class SectionMixed : public testing::Test {
 protected:
  [[nodiscard]] SectionOptions options(std::uint64_t seed, Elements elements) const {
    SectionOptions options;
    options.inputs = {folder_.file("lines.geojson", geojson_text(random_lines(seed)))};
    options.boundary = "box";
    options.size = 2;
    options.elements = elements;
    return options;
  }
  TemporaryFolder folder_;
};

constexpr double kQuality = 0.5;

void expect_cut_where_it_helps(const Mesh& quads, const Mesh& mixed) {
  std::map<Corners, double> jacobians;
  for (const FaceId f : quads.faces()) jacobians[corners_of(quads, f)] = scaled_jacobian(quads, f);
  std::map<Corners, int> parts;
  for (const FaceId f : mixed.faces()) {
    const Corners corners = corners_of(mixed, f);
    if (corners.size() == 4) {
      ASSERT_TRUE(jacobians.contains(corners)) << "a quad that the mesh of quads lacks";
      const double own = scaled_jacobian(mixed, f);
      EXPECT_TRUE(own >= kQuality || better_cut(mixed, f) < std::min(kQuality, 1.1 * own))
          << own << " and " << better_cut(mixed, f);
      continue;
    }
    ASSERT_EQ(corners.size(), 3U);
    // The fourth corner of the quad that was cut lies across the diagonal.
    for (int k = 0; k < 3; ++k) {
      const SideId across = mixed.neighbour(SideId(f, k));
      if (!across.valid() || mixed.corner_count(across.face()) != 3) continue;
      Corners whole = corners;
      const Vec2 apex = mixed.point(mixed.origin(mixed.previous(across)));
      whole.emplace_back(apex.x, apex.y);
      std::sort(whole.begin(), whole.end());
      const auto found = jacobians.find(whole);
      if (found == jacobians.end()) continue;
      EXPECT_LT(found->second, kQuality);
      EXPECT_GT(scaled_jacobian(mixed, f), found->second);
      ++parts[whole];
    }
  }
  std::size_t triangles = 0;
  for (const auto& [quad, count] : parts) {
    EXPECT_EQ(count, 2);
    triangles += 2;
  }
  EXPECT_EQ(triangles, summarize_quality(mixed).triangles.faces) << "each triangle is half of a low quad";
  EXPECT_EQ(mixed.count_alive_faces(), quads.count_alive_faces() + triangles / 2);
}

TEST_F(SectionMixed, HasTrianglesWhereQuadsWouldBeLowAndNowhereElse) {
  std::size_t triangles = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    const Mesh quads = mesh_section(options(seed, Elements::kQuad), {}).mesh;
    SectionOptions mixed_options = options(seed, Elements::kMixed);
    mixed_options.mixed_quality = kQuality;
    const SectionResult mixed = mesh_section(mixed_options, {});
    EXPECT_EQ(validate(mixed.mesh, GeometryCheck::kPlanarCorners), "");
    expect_cut_where_it_helps(quads, mixed.mesh);
    EXPECT_EQ(2 * mixed.low_quads.cut, summarize_quality(mixed.mesh).triangles.faces);
    const auto before = line_lengths(quads);
    const auto after = line_lengths(mixed.mesh);
    ASSERT_EQ(after.size(), before.size());
    for (const auto& [line, length] : before) EXPECT_NEAR(after.at(line), length, 1e-9 * length) << line;
    triangles += 2 * mixed.low_quads.cut;
  }
  EXPECT_GT(triangles, 40U) << "so many lines have low quads";
}

TEST_F(SectionMixed, HasTheSameMeshOnAnyNumberOfThreads) {
  std::vector<std::uint64_t> expected;
  for (const int threads : {1, 2, 4, 7}) {
    const parallel::ParticipationProbe probe;
    parallel::with_threads(threads, [&] {
      const SectionResult result = mesh_section(options(4, Elements::kMixed), {});
      EXPECT_GT(result.low_quads.cut, 0U);
      if (threads == 1) expected = test::arrays_of(result.mesh);
      EXPECT_EQ(test::arrays_of(result.mesh) == expected, true) << threads << " threads";
    });
    EXPECT_EQ(probe.chunks_of_other_threads() > 0, threads > 1) << threads << " threads";
  }
}

TEST_F(SectionMixed, CutsWhatMatchingLeavesConcave) {
  // Without clean-up a mesh of quads alone is refused wherever one stays concave.
  int quads = 0, mixed = 0;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    for (const Elements elements : {Elements::kQuad, Elements::kMixed}) {
      SectionOptions matched = options(seed, elements);
      matched.start = StartMesh::kDelaunay;
      matched.quads = QuadMethod::kMatching;
      matched.cleanup = CleanUpLevel::kNone;
      matched.size = 3;
      try {
        const SectionResult result = mesh_section(matched, {});
        EXPECT_EQ(validate(result.mesh, GeometryCheck::kPlanarCorners), "");
        ++(elements == Elements::kQuad ? quads : mixed);
      } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::kGeometry) << error.message();
      }
    }
  }
  EXPECT_GT(mixed, quads);
}

}  // namespace
}  // namespace quarry
