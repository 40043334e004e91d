// Whole meshes that are committed: connectivity must be equal, coordinates to 1e-9 of the size. A change that
// alters a mesh on purpose writes them anew: quarry mesh tests/data/demo_section.geojson -o
// tests/data/golden/NAME.vtu ...
#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "engine/mesh/mesh.hpp"
#include "io/mesh/mesh_format.hpp"
#include "pipeline/section/section.hpp"

namespace quarry {
namespace {

constexpr double kSize = 25;

void expect_equal(const Mesh& mesh, const Mesh& golden) {
  ASSERT_EQ(mesh.vertex_slots(), golden.vertex_slots());
  ASSERT_EQ(mesh.face_slots(), golden.face_slots());
  ASSERT_EQ(mesh.edge_slots(), golden.edge_slots());
  for (const FaceId f : mesh.faces())
    for (int k = 0; k < 4; ++k) ASSERT_EQ(mesh.corner(f, k), golden.corner(f, k)) << "face " << f.value();
  for (const EdgeId e : mesh.edges())
    ASSERT_EQ(mesh.edge_ends(e), golden.edge_ends(e)) << "edge " << e.value();
  for (const VertexId v : mesh.vertices()) {
    ASSERT_NEAR(mesh.point(v).x, golden.point(v).x, 1e-9 * kSize) << "vertex " << v.value();
    ASSERT_NEAR(mesh.point(v).y, golden.point(v).y, 1e-9 * kSize) << "vertex " << v.value();
  }
}

SectionOptions demo_at(double size) {
  SectionOptions options;
  options.inputs = {"tests/data/demo_section.geojson"};
  options.size = size;
  return options;
}

TEST(GoldenMesh, DemoInQuads) {
  expect_equal(mesh_section(demo_at(kSize), Progress()).mesh, read_mesh("tests/data/golden/demo_quads.vtu"));
}

TEST(GoldenMesh, DemoInTrianglesFromADelaunayStart) {
  SectionOptions options = demo_at(kSize);
  options.elements = Elements::kTriangle;
  options.start = StartMesh::kDelaunay;
  expect_equal(mesh_section(options, Progress()).mesh, read_mesh("tests/data/golden/demo_triangles.vtu"));
}

}  // namespace
}  // namespace quarry
