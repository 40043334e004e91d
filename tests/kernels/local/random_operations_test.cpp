// Thousands of random local operations on meshes with constraints; every invariant is checked after each.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "engine/base/random.hpp"
#include "engine/mesh/validate.hpp"
#include "kernels/local/flip.hpp"
#include "kernels/local/split.hpp"
#include "kernels/quality/element.hpp"
#include "tests/support/charge.hpp"
#include "tests/support/mesh_zoo.hpp"
#include "tests/support/synthetic_mesh.hpp"

namespace quarry {
namespace {

class RandomOperations {
 public:
  RandomOperations(Mesh& mesh, ConstraintTags tags, std::uint64_t seed)
      : mesh_(mesh), tags_(tags), seed_(seed) {}

  // One random operation where it is allowed; true if something was done.
  bool step() {
    const FaceId f(below(mesh_.face_slots()));
    const SideId s(f, static_cast<int>(below(3)));
    switch (below(4)) {
      case 0:
        return split_side(s);
      case 1:
        return split_inside(f);
      default:
        return flip(s);
    }
  }

  std::size_t constrained_splits = 0;
  std::size_t boundary_splits = 0;

 private:
  std::size_t below(std::size_t end) {
    return std::min(end - 1,
                    static_cast<std::size_t>(uniform01(seed_, counter_++) * static_cast<double>(end)));
  }

  bool flip(SideId s) {
    if (!mesh_.neighbour(s).valid() || tags_.constrained(s) || !can_flip(mesh_, s)) return false;
    MeshEditor editor(mesh_);
    const EdgeDiamond before = diamond_of(mesh_, s);
    const SideId made = flip_edge(editor, tags_, s);
    EXPECT_EQ(mesh_.origin(made), before.c);
    EXPECT_EQ(mesh_.target(made), before.d);
    EXPECT_FALSE(mesh_.find_side(before.a, before.b).valid());
    return true;
  }

  bool split_side(SideId s) {
    const double share = 0.25 + 0.5 * uniform01(seed_, counter_++);
    const Vec2 a = mesh_.point(mesh_.origin(s));
    const Vec2 p = a + share * (mesh_.point(mesh_.target(s)) - a);
    if (!can_split_edge(mesh_, s, p)) return false;
    const bool interior = mesh_.neighbour(s).valid();
    const bool constrained = tags_.constrained(s);
    const NewIds ids{mesh_.grow_vertices(1), mesh_.grow_faces(interior ? 2 : 1)};
    MeshEditor editor(mesh_);
    const VertexId m = split_edge(editor, tags_, s, p, Support::fixed(), ids);
    EXPECT_EQ(mesh_.point(m), p);
    EXPECT_EQ(tags_.support[m], Support::fixed());
    EXPECT_EQ(mesh_.on_boundary(m), !interior);
    constrained_splits += constrained ? 1 : 0;
    boundary_splits += interior ? 0 : 1;
    return true;
  }

  bool split_inside(FaceId f) {
    const Vec2 a = mesh_.point(mesh_.corner(f, 0));
    const Vec2 p =
        a + (1.0 / 3) * ((mesh_.point(mesh_.corner(f, 1)) - a) + (mesh_.point(mesh_.corner(f, 2)) - a));
    if (!can_split_face(mesh_, f, p)) return false;
    const NewIds ids{mesh_.grow_vertices(1), mesh_.grow_faces(2)};
    MeshEditor editor(mesh_);
    const VertexId m = split_face(editor, tags_, f, p, Support(), ids);
    EXPECT_TRUE(tags_.support[m].is_free());
    EXPECT_FALSE(mesh_.on_boundary(m));
    return true;
  }

  Mesh& mesh_;
  ConstraintTags tags_;
  std::uint64_t seed_;
  std::uint64_t counter_ = 0;
};

// Edges with the constraint bit on either side; both sides must agree.
std::size_t count_constrained_edges(const Mesh& mesh, const ConstraintTags& tags) {
  std::size_t count = 0;
  for (const FaceId f : mesh.faces()) {
    for (int k = 0; k < 3; ++k) {
      const SideId s(f, k);
      const SideId t = mesh.neighbour(s);
      if (t.valid()) {
        EXPECT_EQ(tags.constrained(s), tags.constrained(t));
      }
      if (tags.constrained(s) && (!t.valid() || s < t)) ++count;
    }
  }
  return count;
}

std::size_t count_boundary_edges(const Mesh& mesh) {
  std::size_t count = 0;
  for (const FaceId f : mesh.faces())
    for (int k = 0; k < 3; ++k) count += mesh.neighbour(SideId(f, k)).valid() ? 0 : 1;
  return count;
}

double area_of(const Mesh& mesh) {
  double area = 0;
  for (const FaceId f : mesh.faces())
    area += signed_area(mesh.point(mesh.corner(f, 0)), mesh.point(mesh.corner(f, 1)),
                        mesh.point(mesh.corner(f, 2)));
  return area;
}

bool all_triangles(const Mesh& mesh) {
  for (const FaceId f : mesh.faces())
    if (mesh.corner_count(f) != 3) return false;
  return true;
}

void try_operations(Mesh& mesh, ConstraintTags tags, std::uint64_t seed, int steps) {
  RandomOperations operations(mesh, tags, seed);
  const std::vector<Support> supports = tags.support.values().raw();
  const int charge = test::charge_of(mesh);
  const double area = area_of(mesh);
  const std::size_t constrained = count_constrained_edges(mesh, tags);
  const std::size_t boundary = count_boundary_edges(mesh);
  int done = 0;
  for (int i = 0; i < steps && !::testing::Test::HasFailure(); ++i) {
    if (!operations.step()) continue;
    ++done;
    ASSERT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
    ASSERT_EQ(test::charge_of(mesh), charge);
    ASSERT_EQ(count_constrained_edges(mesh, tags), constrained + operations.constrained_splits);
    ASSERT_EQ(count_boundary_edges(mesh), boundary + operations.boundary_splits);
  }
  EXPECT_GT(done, steps / 8);
  EXPECT_NEAR(area_of(mesh), area, 1e-9 * area);
  for (std::size_t i = 0; i < supports.size(); ++i) EXPECT_EQ(tags.support[VertexId(i)], supports[i]);
}

TEST(LocalOperations, KeepEveryInvariantOnMeshesWithConstraints) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    test::SyntheticMesh synthetic = test::SyntheticMaker({.columns = 12, .rows = 10, .seed = seed}).make();
    try_operations(synthetic.mesh, synthetic.tags, seed, 1500);
  }
}

TEST(LocalOperations, KeepEveryInvariantOnAwkwardMeshes) {
  for (test::ZooMesh& zoo : test::mesh_zoo()) {
    if (!all_triangles(zoo.mesh)) continue;
    SCOPED_TRACE(zoo.name);
    const auto tags = ConstraintTags::add_to(zoo.mesh);
    try_operations(zoo.mesh, tags, 42, 400);
  }
}

TEST(FlipEdge, TwiceGivesTheSameTriangles) {
  Mesh mesh = test::two_triangles();
  auto tags = ConstraintTags::add_to(mesh);
  tags.set_constrained(SideId(FaceId(0U), 0), true);
  MeshEditor editor(mesh);
  const SideId back =
      flip_edge(editor, tags, flip_edge(editor, tags, mesh.find_side(VertexId(0U), VertexId(2U))));
  EXPECT_TRUE(mesh.find_side(VertexId(0U), VertexId(2U)).valid());
  EXPECT_FALSE(mesh.find_side(VertexId(1U), VertexId(3U)).valid());
  EXPECT_TRUE(tags.constrained(mesh.find_side(VertexId(0U), VertexId(1U))));
  EXPECT_FALSE(tags.constrained(back));
  EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
}

TEST(CanFlip, RefusesADiamondThatIsNotStrictlyConvex) {
  const Mesh flat = test::mesh_of({{0, 0}, {1, 0}, {2, 0}, {1, 1}}, {{0, 1, 3}, {1, 2, 3}});
  EXPECT_FALSE(can_flip(flat, flat.find_side(VertexId(1U), VertexId(3U))));
  const Mesh reflex = test::mesh_of({{0, 0}, {1, 0.5}, {2, 0}, {1, 3}}, {{0, 1, 3}, {1, 2, 3}});
  EXPECT_FALSE(can_flip(reflex, reflex.find_side(VertexId(1U), VertexId(3U))));
}

TEST(CanSplit, RefusesPointsOutsideAndOnTheRim) {
  const Mesh mesh = test::two_triangles();
  EXPECT_FALSE(can_split_face(mesh, FaceId(0U), {0.5, 0}));
  EXPECT_FALSE(can_split_face(mesh, FaceId(0U), {0.2, 0.8}));
  EXPECT_TRUE(can_split_face(mesh, FaceId(0U), {0.8, 0.2}));
  const SideId diagonal = mesh.find_side(VertexId(0U), VertexId(2U));
  EXPECT_TRUE(can_split_edge(mesh, diagonal, {0.5, 0.5}));
  EXPECT_FALSE(can_split_edge(mesh, diagonal, {1, 1}));
  EXPECT_FALSE(can_split_edge(mesh, diagonal, {0.5, 1.5}));
}

}  // namespace
}  // namespace quarry
