#include "kernels/local/collapse.hpp"

#include <gtest/gtest.h>

#include "engine/base/random.hpp"
#include "engine/mesh/build.hpp"
#include "engine/mesh/validate.hpp"
#include "tests/support/synthetic_mesh.hpp"

namespace quarry {
namespace {

// A grid of n by n cells, two triangles each, one diagonal line of constrained sides through it.
struct Grid {
  explicit Grid(std::uint32_t n) {
    std::vector<double> x, y, z;
    std::vector<FaceCorners> faces;
    for (std::uint32_t j = 0; j <= n; ++j)
      for (std::uint32_t i = 0; i <= n; ++i) {
        x.push_back(i);
        y.push_back(j);
        z.push_back(0.1 * i * j);
      }
    const auto at = [&](std::uint32_t i, std::uint32_t j) { return VertexId(j * (n + 1) + i); };
    for (std::uint32_t j = 0; j < n; ++j)
      for (std::uint32_t i = 0; i < n; ++i) {
        faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), VertexId()});
        faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1), VertexId()});
      }
    mesh = build_mesh(x, y, z, faces);
    tags = ConstraintTags::add_to(mesh);
    for (std::uint32_t i = 0; i < n; ++i) {
      tags.set_constrained(mesh.find_side(at(i, i), at(i + 1, i + 1)), true);
      tags.set_constrained(mesh.find_side(at(i + 1, i + 1), at(i, i)), true);
    }
  }

  Mesh mesh;
  ConstraintTags tags;
};

std::size_t constrained_sides(const Grid& grid) {
  std::size_t count = 0;
  for (const FaceId f : grid.mesh.faces())
    for (int k = 0; k < 3 && grid.mesh.alive(f); ++k) count += grid.tags.constrained(SideId(f, k)) ? 1 : 0;
  return count;
}

TEST(CollapseEdge, TakesTwoFacesInsideAndOneAtTheRim) {
  Grid grid(4);
  MeshEditor editor(grid.mesh);
  const auto at = [](std::uint32_t i, std::uint32_t j) { return VertexId(j * 5 + i); };
  ASSERT_TRUE(can_collapse(grid.mesh, at(1, 2), at(2, 2)));
  collapse_edge(editor, grid.tags, at(1, 2), at(2, 2));
  EXPECT_EQ(validate(grid.mesh, GeometryCheck::kNone), "");
  EXPECT_EQ(grid.mesh.count_alive_faces(), 30U);
  ASSERT_TRUE(can_collapse(grid.mesh, at(3, 0), at(2, 0)));
  collapse_edge(editor, grid.tags, at(3, 0), at(2, 0));
  EXPECT_EQ(validate(grid.mesh, GeometryCheck::kNone), "");
  EXPECT_EQ(grid.mesh.count_alive_faces(), 29U);
  EXPECT_FALSE(grid.mesh.alive(at(3, 0)));
}

TEST(CollapseEdge, KeepsConstraintsAsAChain) {
  Grid grid(4);
  MeshEditor editor(grid.mesh);
  EXPECT_EQ(constrained_sides(grid), 8U);
  const VertexId gone(std::size_t{12}), kept(std::size_t{18});
  ASSERT_TRUE(can_collapse(grid.mesh, gone, kept));
  collapse_edge(editor, grid.tags, gone, kept);
  EXPECT_EQ(constrained_sides(grid), 6U);
  EXPECT_TRUE(grid.tags.constrained(grid.mesh.find_side(VertexId(std::size_t{6}), kept)));
}

TEST(CollapseEdge, RefusesToJoinTwoRims) {
  Grid grid(1);
  EXPECT_FALSE(can_collapse(grid.mesh, VertexId(std::size_t{0}), VertexId(std::size_t{3})));
}

TEST(CollapseEdge, LeavesAValidMeshAfterRandomCollapses) {
  for (const std::uint64_t seed : {1ULL, 2ULL, 3ULL, 4ULL}) {
    SCOPED_TRACE(seed);
    Grid grid(12);
    std::uint64_t counter = 0;
    int done = 0;
    for (int i = 0; i < 2000; ++i) {
      const auto f =
          static_cast<std::size_t>(uniform01(seed, counter++) * static_cast<double>(grid.mesh.face_slots()));
      const SideId s(FaceId(f), static_cast<int>(3 * uniform01(seed, counter++)));
      if (!grid.mesh.alive(s.face())) continue;
      const VertexId a = grid.mesh.origin(s);
      const VertexId b = grid.mesh.target(s);
      if (!can_collapse(grid.mesh, a, b)) continue;
      MeshEditor editor(grid.mesh);
      collapse_edge(editor, grid.tags, a, b);
      ++done;
      ASSERT_EQ(validate(grid.mesh, GeometryCheck::kNone), "") << "collapse " << i;
    }
    EXPECT_GT(done, 100);
  }
}

}  // namespace
}  // namespace quarry
