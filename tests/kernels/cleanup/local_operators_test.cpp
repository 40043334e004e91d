// Each local operator alone: what it does to small meshes, and what it leaves as it is on random ones.
#include "kernels/cleanup/local_operators.hpp"

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/mesh/validate.hpp"
#include "kernels/cleanup/local_operation.hpp"
#include "tests/kernels/cleanup/local_meshes.hpp"
#include "tests/support/mesh_arrays.hpp"
#include "tests/support/mesh_zoo.hpp"

namespace quarry {
namespace {

LocalTags count_tags(Mesh& mesh) {
  mesh.remove_tag<VertexId>("faces");
  LocalTags tags{ConstraintTags::of(mesh), set_ideal_faces(mesh, PlaneModel()),
                 mesh.add_tag<VertexId, std::uint16_t>("faces", 0)};
  for (const FaceId f : mesh.faces())
    if (mesh.alive(f))
      for (int k = 0; k < mesh.corner_count(f); ++k) ++tags.faces[mesh.corner(f, k)];
  return tags;
}

int energy_of(const Mesh& mesh, const LocalTags& tags) {
  int energy = 0;
  for (const VertexId v : mesh.vertices())
    if (mesh.alive(v)) energy += valence_energy(tags.faces[v], tags.ideal[v]);
  return energy;
}

template <class Operator>
std::uint64_t run_alone(Mesh& mesh, const LocalTags& tags) {
  const PlaneModel model;
  const LocalOperation<PlaneModel, Operator> operation(model, tags, {}, 2);
  std::vector<typename LocalOperation<PlaneModel, Operator>::Item> work;
  for (const VertexId v : mesh.vertices())
    if (operation.wants(mesh, v)) work.push_back({v, 0});
  run_pass(mesh, operation, std::move(work), {.window = 1024, .cutoff = 2}, Progress());
  return operation.count(Verdict::kWon);
}

template <class Operator>
std::uint64_t run_alone(Mesh& mesh) {
  return run_alone<Operator>(mesh, count_tags(mesh));
}

template <class Operator>
class LocalOperator : public testing::Test {};

using Operators =
    testing::Types<DoubletRemoval, SingletOpening, FaceCollapse, EdgeRotation, VertexSplit, PairWalk>;
TYPED_TEST_SUITE(LocalOperator, Operators);

template <class Operator>
std::uint64_t expect_kept(Mesh mesh) {
  const LocalTags tags = count_tags(mesh);
  const ModelBalance balance = balance_of(mesh, PlaneModel());
  const auto boundary = test::boundary_of(mesh);
  const int energy = energy_of(mesh, tags);
  reset_claim_violations();
  const std::uint64_t won = run_alone<Operator>(mesh, tags);
  EXPECT_EQ(find_imbalance(mesh, PlaneModel(), balance), "");
  EXPECT_EQ(test::boundary_of(mesh), boundary);
  EXPECT_EQ(claim_violations().count, 0U) << claim_violations().first;
  EXPECT_TRUE(Operator::kMends || energy_of(mesh, tags) <= energy - static_cast<int>(won));
  const LocalTags counted = tags;
  for (const VertexId v : mesh.vertices()) {
    if (!mesh.alive(v)) continue;
    int faces = 0;
    for_each_side_around(mesh, v, [&](SideId) { ++faces; });
    EXPECT_EQ(counted.faces[v], faces);
  }
  return won;
}

TYPED_TEST(LocalOperator, KeepsTheBalanceTheBoundaryAndItsClaimsOnRandomMeshes) {
  std::uint64_t won = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    won += expect_kept<TypeParam>(test::open_halved_mesh({.columns = 16, .rows = 12, .seed = seed}));
    won += expect_kept<TypeParam>(test::open_paired_mesh({.columns = 16, .rows = 12, .seed = seed}));
    won += expect_kept<TypeParam>(test::open_split_disk(900, seed));
  }
  EXPECT_GT(won, 0U);
}

TYPED_TEST(LocalOperator, LeavesARegularMeshAlone) {
  Mesh mesh = test::open_halved_mesh({.jitter = 0, .flip_share = 0, .straight_lines = 3, .crooked_lines = 0});
  EXPECT_EQ(run_alone<TypeParam>(mesh), 0U);
}

// Quads on a lattice of unit cells; those with an index in `left_out` are given by the caller.
struct Lattice {
  std::uint32_t columns, rows;
  std::vector<Vec2> points;
  std::vector<std::vector<std::uint32_t>> faces;

  Lattice(std::uint32_t wide, std::uint32_t high, const std::vector<std::uint32_t>& left_out = {})
      : columns(wide), rows(high) {
    for (std::uint32_t row = 0; row <= rows; ++row)
      for (std::uint32_t column = 0; column <= columns; ++column)
        points.push_back({static_cast<double>(column), static_cast<double>(row)});
    for (std::uint32_t i = 0; i < columns * rows; ++i)
      if (std::find(left_out.begin(), left_out.end(), i) == left_out.end()) faces.push_back(cell(i));
  }
  [[nodiscard]] std::vector<std::uint32_t> cell(std::uint32_t i) const {
    const std::uint32_t a = at(i % columns, i / columns);
    return {a, a + 1, a + columns + 2, a + columns + 1};
  }
  [[nodiscard]] std::uint32_t at(std::uint32_t column, std::uint32_t row) const {
    return row * (columns + 1) + column;
  }
  [[nodiscard]] Mesh mesh() const {
    Mesh made = test::mesh_of(points, faces);
    const auto tags = ConstraintTags::add_to(made);
    for (const VertexId v : made.vertices())
      if (made.alive(v) && made.on_boundary(v)) Tag(tags.support)[v] = Support::fixed();
    return made;
  }
};

TEST(DoubletRemoval, MakesOneQuadOfTwo) {
  Lattice lattice(3, 3, {4});
  const auto cell = lattice.cell(4);
  lattice.points.push_back({1.4, 1.6});
  lattice.faces.push_back({cell[0], cell[1], cell[2], 16});
  lattice.faces.push_back({cell[0], 16, cell[2], cell[3]});
  Mesh mesh = lattice.mesh();
  EXPECT_EQ(run_alone<DoubletRemoval>(mesh), 1U);
  EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
  EXPECT_EQ(mesh.count_alive_faces(), 9U);
  EXPECT_FALSE(mesh.alive(VertexId(16U)));
}

TEST(DoubletRemoval, LeavesAVertexThatIsBoundToItsPlace) {
  Lattice lattice(3, 3, {4});
  const auto cell = lattice.cell(4);
  lattice.points.push_back({1.4, 1.6});
  lattice.faces.push_back({cell[0], cell[1], cell[2], 16});
  lattice.faces.push_back({cell[0], 16, cell[2], cell[3]});
  Mesh mesh = lattice.mesh();
  ConstraintTags::of(mesh).support[VertexId(16U)] = Support::fixed();
  EXPECT_EQ(run_alone<DoubletRemoval>(mesh), 0U);
}

TEST(SingletOpening, GivesAFlatVertexASecondFace) {
  // The cell at the middle of the lower side takes in its flat vertex; the one above is as it was.
  Lattice lattice(4, 4, {1, 2});
  lattice.points[lattice.at(2, 1)] = {2, 1.3};
  lattice.points[lattice.at(1, 1)] = {0.7, 1};
  lattice.points[lattice.at(3, 1)] = {3.3, 1};
  lattice.faces.push_back({lattice.at(1, 0), lattice.at(2, 0), lattice.at(3, 0), lattice.at(2, 1)});
  lattice.faces.push_back({lattice.at(1, 0), lattice.at(2, 1), lattice.at(1, 2), lattice.at(1, 1)});
  lattice.faces.push_back({lattice.at(3, 0), lattice.at(3, 1), lattice.at(3, 2), lattice.at(2, 1)});
  lattice.faces.erase(
      std::remove_if(lattice.faces.begin(), lattice.faces.end(),
                     [&](const auto& face) { return face == lattice.cell(5) || face == lattice.cell(6); }),
      lattice.faces.end());
  lattice.faces.push_back({lattice.at(1, 2), lattice.at(2, 1), lattice.at(3, 2), lattice.at(2, 2)});
  Mesh mesh = lattice.mesh();
  ASSERT_NE(validate(mesh, GeometryCheck::kPlanarCorners), "");
  EXPECT_EQ(run_alone<SingletOpening>(mesh), 1U);
  EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
}

TEST(FaceCollapse, ClosesADiamond) {
  // A lattice edge opened: a quad between two vertices of three faces.
  Lattice lattice(4, 4, {5, 6, 9, 10});
  const std::uint32_t left = 25, right = 26;
  lattice.points.push_back({1.7, 2});
  lattice.points.push_back({2.3, 2});
  const auto v = [&](std::uint32_t column, std::uint32_t row) { return lattice.at(column, row); };
  lattice.faces.push_back({v(1, 1), v(2, 1), left, v(1, 2)});
  lattice.faces.push_back({v(2, 1), v(3, 1), v(3, 2), right});
  lattice.faces.push_back({v(1, 2), left, v(2, 3), v(1, 3)});
  lattice.faces.push_back({right, v(3, 2), v(3, 3), v(2, 3)});
  lattice.faces.push_back({v(2, 1), right, v(2, 3), left});
  Mesh mesh = lattice.mesh();
  EXPECT_EQ(run_alone<FaceCollapse>(mesh), 1U);
  EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
  EXPECT_EQ(mesh.count_alive_faces(), 16U);
  EXPECT_EQ(energy_of(mesh, count_tags(mesh)), 0);
}

TEST(EdgeRotation, MakesTwoPairsRegular) {
  Lattice lattice(5, 4, {6, 7});
  // The edge from (2, 1) to (2, 2) turned: (1, 1) - (3, 2).
  lattice.faces.push_back({lattice.at(1, 1), lattice.at(2, 1), lattice.at(3, 1), lattice.at(3, 2)});
  lattice.faces.push_back({lattice.at(1, 1), lattice.at(3, 2), lattice.at(2, 2), lattice.at(1, 2)});
  Mesh mesh = lattice.mesh();
  EXPECT_EQ(run_alone<EdgeRotation>(mesh), 1U);
  EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
  EXPECT_EQ(energy_of(mesh, count_tags(mesh)), 0);
}

TEST(VertexSplit, MakesTwoVerticesOfOneWithSixFaces) {
  // A star of six quads.
  std::vector<Vec2> points{{0, 0}};
  std::vector<std::vector<std::uint32_t>> faces;
  for (std::uint32_t i = 0; i < 6; ++i) {
    const double turn = std::numbers::pi / 3 * i;
    points.push_back({std::cos(turn), std::sin(turn)});
    points.push_back(
        {1.6 * std::cos(turn + std::numbers::pi / 6), 1.6 * std::sin(turn + std::numbers::pi / 6)});
  }
  for (std::uint32_t i = 0; i < 6; ++i) faces.push_back({0, 1 + 2 * i, 2 + 2 * i, 1 + (2 * i + 2) % 12});
  // A ring around it, so that the spokes end inside.
  for (std::uint32_t i = 0; i < 12; ++i) {
    const double turn = std::numbers::pi / 6 * i;
    points.push_back({2.6 * std::cos(turn), 2.6 * std::sin(turn)});
  }
  for (std::uint32_t i = 0; i < 12; ++i)
    faces.push_back({1 + i, 13 + i, 13 + (i + 1) % 12, 1 + (i + 1) % 12});
  Mesh mesh = test::mesh_of(points, faces);
  ConstraintTags::add_to(mesh);
  ASSERT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
  EXPECT_GE(run_alone<VertexSplit>(mesh), 1U);
  EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
  EXPECT_EQ(count_tags(mesh).faces[VertexId(0U)], 4);
}

TEST(PairWalk, CancelsTwoPairsAtTheEndsOfAStrip) {
  // Row 1 of the lattice sheared between its columns 1 and 5: a pair at each end.
  Lattice lattice(8, 4, {9, 10, 11, 12, 13});
  const auto a = [&](std::uint32_t i) { return lattice.at(1 + i, 2); };
  const auto b = [&](std::uint32_t i) { return lattice.at(1 + i, 1); };
  lattice.faces.push_back({a(0), b(0), b(1), b(2)});
  for (std::uint32_t i = 1; i < 4; ++i) lattice.faces.push_back({a(i), a(i - 1), b(i + 1), b(i + 2)});
  lattice.faces.push_back({b(5), a(5), a(4), a(3)});
  Mesh mesh = lattice.mesh();
  EXPECT_EQ(run_alone<EdgeRotation>(mesh), 0U);
  EXPECT_EQ(run_alone<PairWalk>(mesh), 1U);
  EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
  EXPECT_EQ(energy_of(mesh, count_tags(mesh)), 0);
}

TEST(LocalAttempt, PutsEverythingBackWhereAFaceWouldNotBeValid) {
  // A regular lattice with its edge from (2, 1) to (2, 2) turned: (1, 1) - (3, 2) leaves a flat corner, and
  // nothing may move.
  Mesh mesh = Lattice(5, 4).mesh();
  for (const VertexId v : mesh.vertices()) ConstraintTags::of(mesh).support[v] = Support::fixed();
  const LocalTags tags = count_tags(mesh);
  const auto before = test::arrays_of(mesh);
  const PlaneModel model;
  LocalAttempt<PlaneModel> attempt(model);
  attempt.change.clear();
  const SideId rung = mesh.find_side(VertexId(14U), VertexId(8U));
  Strip::build(LocalView{mesh, tags}, {rung, 2, false}, attempt.change);
  MeshEditor editor(mesh);
  EXPECT_EQ(attempt.run(editor, tags, {}, {}), Verdict::kInvalid);
  EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
  EXPECT_EQ(energy_of(mesh, tags), 0);
  // Sides that vertices know may have turned around them.
  for (const VertexId v : mesh.vertices()) mesh.set_side_of(v, SideId());
  rebuild_sides_of_vertices(mesh);
  EXPECT_EQ(test::arrays_of(mesh), before);
}

}  // namespace
}  // namespace quarry
