#include "engine/mesh/compact.hpp"

#include <cmath>
#include <set>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "engine/mesh/constraint.hpp"
#include "engine/mesh/validate.hpp"
#include "engine/parallel/parallel.hpp"
#include "tests/support/mesh_arrays.hpp"
#include "tests/support/mesh_zoo.hpp"

namespace quarry {
namespace {

// Takes a face out of a mesh as local operations do: sides across are put on the boundary, fans are kept
// whole.
void remove_face(Mesh& mesh, FaceId f) {
  for (int k = 0; k < mesh.corner_count(f); ++k)
    if (const SideId t = mesh.neighbour(SideId(f, k)); t.valid()) mesh.set_neighbour(t, SideId());
  mesh.delete_face(f);
  rebuild_sides_of_vertices(mesh);
}

// Corner points of each face with a tag value, whatever the numbers of the entities.
std::multiset<std::pair<std::vector<std::pair<double, double>>, int>> described(const Mesh& mesh,
                                                                                Tag<FaceId, int> tag) {
  std::multiset<std::pair<std::vector<std::pair<double, double>>, int>> all;
  for (const FaceId f : mesh.faces()) {
    if (!mesh.alive(f)) continue;
    std::vector<std::pair<double, double>> points;
    for (int k = 0; k < mesh.corner_count(f); ++k)
      points.emplace_back(mesh.point(mesh.corner(f, k)).x, mesh.point(mesh.corner(f, k)).y);
    all.emplace(points, tag[f]);
  }
  return all;
}

class CompactInOrder : public ::testing::TestWithParam<EntityOrder> {};

TEST_P(CompactInOrder, KeepsConnectivityPointsAndTags) {
  for (test::ZooMesh& zoo : test::mesh_zoo()) {
    SCOPED_TRACE(zoo.name);
    Mesh mesh = std::move(zoo.mesh);
    auto number = mesh.add_tag<FaceId, int>("number");
    auto x_of = mesh.add_tag<VertexId, double>("x");
    for (const FaceId f : mesh.faces()) number[f] = static_cast<int>(f.value());
    for (const VertexId v : mesh.vertices()) x_of[v] = mesh.point(v).x;
    if (mesh.face_slots() > 3) remove_face(mesh, FaceId(mesh.face_slots() - 1));
    const auto before = described(mesh, number);
    const Renumbering renumbering = compact(mesh, GetParam());
    EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
    EXPECT_EQ(described(mesh, number), before);
    EXPECT_EQ(mesh.face_slots(), mesh.count_alive_faces());
    EXPECT_EQ(mesh.vertex_slots(), mesh.count_alive_vertices());
    for (const VertexId v : mesh.vertices()) EXPECT_EQ(x_of[v], mesh.point(v).x);
    for (const FaceId f : mesh.faces())
      EXPECT_EQ(renumbering.old_face[f.value()], static_cast<std::uint32_t>(number[f]));
  }
}

TEST_P(CompactInOrder, RenumbersSetsAndDropsDeletedMembers) {
  Mesh mesh = test::triangle_lattice(4, 4);
  const Vec2 kept = mesh.point(VertexId(12U));
  // Both faces at the corner vertex 4 go, and the vertex with them.
  mesh.vertex_sets().push_back({"some", {VertexId(12U), VertexId(4U)}});
  mesh.face_sets().push_back({"faces", {FaceId(6U), FaceId(0U)}});
  mesh.edge_sets().push_back({"edges", {mesh.add_edge(VertexId(12U), VertexId(13U)), EdgeId()}});
  mesh.edge_sets().back().members[1] = mesh.add_edge(VertexId(3U), VertexId(4U));
  auto length_of = mesh.add_tag<EdgeId, double>("length");
  length_of[EdgeId(0U)] = 1.5;
  remove_face(mesh, FaceId(6U));
  if (mesh.alive(VertexId(4U))) remove_face(mesh, mesh.side_of(VertexId(4U)).face());
  const Vec2 face_corner = mesh.point(mesh.corner(FaceId(0U), 0));
  compact(mesh, GetParam());
  ASSERT_EQ(mesh.vertex_sets()[0].members.size(), 1U);
  EXPECT_EQ(mesh.point(mesh.vertex_sets()[0].members[0]), kept);
  ASSERT_EQ(mesh.face_sets()[0].members.size(), 1U);
  EXPECT_EQ(mesh.point(mesh.corner(mesh.face_sets()[0].members[0], 0)), face_corner);
  ASSERT_EQ(mesh.edge_slots(), 1U);
  ASSERT_EQ(mesh.edge_sets()[0].members.size(), 1U);
  EXPECT_EQ(mesh.point(mesh.edge_ends(mesh.edge_sets()[0].members[0]).first), kept);
  EXPECT_EQ(length_of[EdgeId(0U)], 1.5);
  EXPECT_EQ(length_of.values().size(), 1U);
}

INSTANTIATE_TEST_SUITE_P(Orders, CompactInOrder,
                         ::testing::Values(EntityOrder::kKeep, EntityOrder::kHilbert));

TEST(Compact, OfNothingDeletedInTheSameOrderChangesNothing) {
  Mesh mesh = test::triangle_lattice(6, 5);
  const auto before = test::arrays_of(mesh);
  compact(mesh, EntityOrder::kKeep);
  EXPECT_EQ(test::arrays_of(mesh), before);
}

TEST(Compact, AlongTheHilbertCurvePutsNeighboursNearEachOther) {
  Mesh mesh = test::triangle_lattice(64, 64);
  const auto mean_jump = [&] {
    double sum = 0;
    for (std::size_t i = 1; i < mesh.vertex_slots(); ++i)
      sum += distance(mesh.point(VertexId(i - 1)), mesh.point(VertexId(i)));
    return sum / static_cast<double>(mesh.vertex_slots() - 1);
  };
  const double in_rows = mean_jump();
  compact(mesh, EntityOrder::kHilbert);
  EXPECT_LT(mean_jump(), 0.75 * in_rows);
}

TEST(Compact, IsTheSameOnAnyNumberOfThreads) {
  std::vector<std::uint64_t> serial;
  parallel::with_threads(1, [&] {
    Mesh mesh = test::triangle_lattice(150, 150);
    compact(mesh, EntityOrder::kHilbert);
    serial = test::arrays_of(mesh);
  });
  for (const int threads : {2, 4, 7}) {
    const parallel::ParticipationProbe probe;
    parallel::with_threads(threads, [&] {
      Mesh mesh = test::triangle_lattice(150, 150);
      compact(mesh, EntityOrder::kHilbert);
      EXPECT_EQ(test::arrays_of(mesh), serial) << threads << " threads";
    });
    EXPECT_GT(probe.chunks_of_other_threads(), 0U) << threads << " threads";
  }
}

TEST(MeshBytes, AreAtMost64ATriangleWithAllTagsOfAJob) {
  Mesh mesh = test::triangle_lattice(300, 300);
  ConstraintTags::add_to(mesh);
  mesh.add_tag<FaceId, std::int32_t>("region");
  compact(mesh, EntityOrder::kHilbert);
  EXPECT_LE(static_cast<double>(mesh.bytes()), 64.0 * static_cast<double>(mesh.face_slots()));
}

TEST(MeshTags, GrowWithTheMeshAndTakeTheirFirstValue) {
  Mesh mesh = test::two_triangles();
  auto tag = mesh.add_tag<FaceId, int>("number", 7);
  tag[FaceId(0U)] = 1;
  mesh.grow_faces(2);
  EXPECT_EQ(tag[FaceId(0U)], 1);
  EXPECT_EQ(tag[FaceId(3U)], 7);
  auto support = mesh.add_tag<VertexId, Support>("support");
  const VertexId fresh = mesh.grow_vertices(1);
  EXPECT_TRUE(support[fresh].is_free());
  EXPECT_FALSE(mesh.alive(fresh));
  EXPECT_FALSE(mesh.alive(FaceId(3U)));
}

TEST(MeshTags, AreFoundByNameAndTypeAndGoneOnceRemoved) {
  Mesh mesh = test::one_triangle();
  mesh.add_tag<FaceId, int>("number");
  EXPECT_TRUE((mesh.find_tag<FaceId, int>("number").valid()));
  EXPECT_FALSE((mesh.find_tag<FaceId, double>("number").valid()));
  EXPECT_FALSE((mesh.find_tag<VertexId, int>("number").valid()));
  mesh.remove_tag<FaceId>("number");
  EXPECT_FALSE((mesh.find_tag<FaceId, int>("number").valid()));
}

}  // namespace
}  // namespace quarry
