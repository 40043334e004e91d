#include "engine/mesh/sectors.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/mesh/domain.hpp"
#include "engine/mesh/validate.hpp"
#include "engine/parallel/parallel.hpp"
#include "tests/support/charge.hpp"
#include "tests/support/mesh_arrays.hpp"
#include "tests/support/mesh_zoo.hpp"
#include "tests/support/synthetic_mesh.hpp"

namespace quarry {
namespace {

struct Constrained {
  Mesh mesh;
  ConstraintTags tags;

  void constrain(std::uint32_t a, std::uint32_t b) {
    for (const SideId s :
         {mesh.find_side(VertexId(a), VertexId(b)), mesh.find_side(VertexId(b), VertexId(a))})
      if (s.valid()) tags.set_constrained(s, true);
  }
  // Along the vertices given.
  void constrain(const std::vector<std::uint32_t>& path) {
    for (std::size_t i = 1; i < path.size(); ++i) constrain(path[i - 1], path[i]);
  }
  [[nodiscard]] std::size_t copies_of(std::uint32_t v) const {
    const auto whole = mesh.find_tag<VertexId, VertexId>(kWholeTag);
    std::size_t count = 0;
    for (const VertexId w : mesh.vertices()) count += whole_of(whole, w) == VertexId(v) ? 1 : 0;
    return count;
  }
};

// Vertices row * 7 + column.
Constrained lattice_of_six() {
  Constrained made{test::triangle_lattice(6, 6), {}};
  made.tags = ConstraintTags::add_to(made.mesh);
  return made;
}

std::vector<std::uint32_t> corners_of(const Mesh& mesh) {
  std::vector<std::uint32_t> corners;
  for (const FaceId f : mesh.faces())
    for (int k = 0; k < 4; ++k) corners.push_back(mesh.corner(f, k).value());
  return corners;
}

std::vector<std::uint32_t> neighbours_of(const Mesh& mesh) {
  std::vector<std::uint32_t> neighbours;
  for (const FaceId f : mesh.faces())
    for (int k = 0; k < 4; ++k) neighbours.push_back(mesh.neighbour(SideId(f, k)).value());
  return neighbours;
}

void expect_round_trip(Mesh& mesh, ConstraintTags tags) {
  const auto corners = corners_of(mesh);
  const auto neighbours = neighbours_of(mesh);
  const std::size_t vertices = mesh.count_alive_vertices();
  const int charge = test::charge_of(mesh);
  cut_open(mesh, tags);
  ASSERT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
  for (const FaceId f : mesh.faces())
    for (int k = 0; k < mesh.corner_count(f); ++k)
      EXPECT_FALSE(tags.constrained(SideId(f, k)) && mesh.neighbour(SideId(f, k)).valid());
  sew(mesh, tags);
  EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
  EXPECT_EQ(corners_of(mesh), corners);
  EXPECT_EQ(neighbours_of(mesh), neighbours);
  EXPECT_EQ(mesh.count_alive_vertices(), vertices);
  EXPECT_EQ(test::charge_of(mesh), charge);
  EXPECT_FALSE((mesh.find_tag<VertexId, VertexId>(kWholeTag).valid()));
}

class CutOpen : public testing::TestWithParam<std::uint64_t> {};

TEST_P(CutOpen, AndSewnGivesTheMeshBack) {
  test::SyntheticMesh made = test::make_synthetic({.seed = GetParam()});
  expect_round_trip(made.mesh, made.tags);
}

TEST_P(CutOpen, GivesEachVertexACopyForEachSector) {
  test::SyntheticMesh made = test::make_synthetic({.seed = GetParam()});
  std::map<VertexId, std::size_t> sectors;
  for (const VertexId v : made.mesh.vertices()) {
    std::size_t constraints = 0;
    for_each_side_around(made.mesh, v, [&](SideId s) { constraints += made.tags.constrained(s) ? 1 : 0; });
    sectors[v] = std::max<std::size_t>(1, constraints);
  }
  cut_open(made.mesh, made.tags);
  const auto whole = made.mesh.find_tag<VertexId, VertexId>(kWholeTag);
  std::map<VertexId, std::size_t> copies;
  for (const VertexId v : made.mesh.vertices()) {
    const VertexId first = whole_of(whole, v);
    ++copies[first];
    EXPECT_EQ(made.mesh.point(v), made.mesh.point(first));
    EXPECT_EQ(made.tags.support[v], made.tags.support[first]);
    EXPECT_EQ(whole_of(whole, first), first);
  }
  EXPECT_EQ(copies, sectors);
}

// The charge and the parity of each part hold for it alone.
TEST_P(CutOpen, LeavesPartsThatKeepTheBalanceOfCharge) {
  test::SyntheticMesh made = test::make_synthetic({.seed = GetParam()});
  cut_open(made.mesh, made.tags);
  const std::int32_t regions = label_regions(made.mesh, made.tags);
  const auto region = made.mesh.find_tag<FaceId, std::int32_t>("region");
  struct Part {
    int faces = 0, vertices = 0, sides = 0, rim = 0, charge = 0;
  };
  std::vector<Part> parts(static_cast<std::size_t>(regions));
  for (const FaceId f : made.mesh.faces()) {
    Part& part = parts[static_cast<std::size_t>(region[f])];
    ++part.faces;
    part.charge += 1;  // a triangle
    part.sides += 3;
    for (int k = 0; k < 3; ++k) part.rim += made.mesh.neighbour(SideId(f, k)).valid() ? 0 : 1;
  }
  for (const VertexId v : made.mesh.vertices()) {
    Part& part = parts[static_cast<std::size_t>(region[made.mesh.side_of(v).face()])];
    ++part.vertices;
    part.charge += made.mesh.on_boundary(v) ? 2 : 4;
    for_each_side_around(made.mesh, v, [&](SideId) { --part.charge; });
  }
  for (const Part& part : parts) {
    EXPECT_EQ(part.charge, 4 * (part.vertices - (part.sides + part.rim) / 2 + part.faces));
    EXPECT_EQ(part.faces % 2, part.rim % 2);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, CutOpen, testing::Range<std::uint64_t>(1, 21));

TEST(CutOpenAlong, ADanglingLineIsASlitWithOneCopyAtEachTip) {
  Constrained made = lattice_of_six();
  made.constrain({15, 16, 17, 18});
  expect_round_trip(made.mesh, made.tags);
  cut_open(made.mesh, made.tags);
  EXPECT_EQ(made.copies_of(15), 1U);
  EXPECT_EQ(made.copies_of(16), 2U);
  EXPECT_EQ(made.copies_of(17), 2U);
  EXPECT_EQ(made.copies_of(18), 1U);
  EXPECT_TRUE(made.mesh.on_boundary(VertexId(15U)));
  EXPECT_EQ(test::charge_of(made.mesh), 0);  // a disk with a hole
}

TEST(CutOpenAlong, ASingleEdgeJoinsTwoTips) {
  Constrained made = lattice_of_six();
  made.constrain(16, 17);
  expect_round_trip(made.mesh, made.tags);
  cut_open(made.mesh, made.tags);
  EXPECT_EQ(made.copies_of(16), 1U);
  EXPECT_EQ(made.copies_of(17), 1U);
  EXPECT_EQ(made.mesh.vertex_slots(), 49U);
}

TEST(CutOpenAlong, AJunctionHasOneCopyForEachArm) {
  Constrained made = lattice_of_six();
  made.constrain({22, 23, 24, 25, 26});
  made.constrain({24, 31, 38});
  made.constrain({24, 17});
  expect_round_trip(made.mesh, made.tags);
  cut_open(made.mesh, made.tags);
  EXPECT_EQ(made.copies_of(24), 4U);
}

TEST(CutOpenAlong, AClosedLoopFreesWhatLiesInside) {
  Constrained made = lattice_of_six();
  made.constrain({16, 17, 18, 25, 32, 31, 30, 23, 16});
  expect_round_trip(made.mesh, made.tags);
  cut_open(made.mesh, made.tags);
  EXPECT_EQ(made.copies_of(17), 2U);
  EXPECT_EQ(made.copies_of(24), 1U);
  EXPECT_EQ(test::charge_of(made.mesh), 4);  // a disk and a ring
}

TEST(CutOpenAlong, ALineFromOutlineToOutlineMakesTwoParts) {
  Constrained made = lattice_of_six();
  made.constrain({21, 22, 23, 24, 25, 26, 27});
  made.constrain({3, 10});       // touches the outline and ends
  made.constrain({42, 43, 44});  // runs along the outline
  expect_round_trip(made.mesh, made.tags);
  cut_open(made.mesh, made.tags);
  EXPECT_EQ(made.copies_of(21), 2U);
  EXPECT_EQ(made.copies_of(24), 2U);
  EXPECT_EQ(made.copies_of(3), 2U);
  EXPECT_EQ(made.copies_of(10), 1U);
  EXPECT_EQ(made.copies_of(43), 1U);
  EXPECT_EQ(test::charge_of(made.mesh), 8);
}

TEST(SewPieces, JoinsTheEdgesBetweenSlidingVerticesAlone) {
  Constrained made = lattice_of_six();
  made.constrain({22, 23, 24, 25, 26});
  for (const std::uint32_t v : {22U, 26U}) made.tags.support[VertexId(v)] = Support::fixed();
  for (const std::uint32_t v : {23U, 24U, 25U}) made.tags.support[VertexId(v)] = Support::on(PieceId(0U));
  const std::vector<std::uint8_t> no_nodes(made.mesh.vertex_slots(), 0);
  cut_open(made.mesh, made.tags);
  sew_pieces(made.mesh, made.tags, no_nodes);
  EXPECT_EQ(validate(made.mesh, GeometryCheck::kNone), "");
  const auto joined = [&](std::uint32_t a, std::uint32_t b) {
    const SideId s = made.mesh.find_side(VertexId(a), VertexId(b));
    EXPECT_TRUE(made.tags.constrained(s));
    return made.mesh.neighbour(s).valid();
  };
  EXPECT_FALSE(joined(22, 23));
  EXPECT_TRUE(joined(23, 24));
  EXPECT_TRUE(joined(24, 25));
  EXPECT_FALSE(joined(25, 26));
  EXPECT_TRUE(made.mesh.on_boundary(VertexId(23U)));
  EXPECT_FALSE(made.mesh.on_boundary(VertexId(24U)));
  sew(made.mesh, made.tags);
  EXPECT_EQ(neighbours_of(made.mesh), neighbours_of(lattice_of_six().mesh));
  EXPECT_EQ(corners_of(made.mesh), corners_of(lattice_of_six().mesh));
}

// The nodes at the other ends of constrained edges at v.
std::vector<VertexId> joined_nodes(const test::SyntheticMesh& made, VertexId v) {
  std::vector<VertexId> nodes;
  for_each_constrained_neighbour(made.mesh, made.tags, v, [&](VertexId w) {
    if (!made.tags.support[w].slides()) nodes.push_back(w);
  });
  return nodes;
}

TEST(SewPieces, LeavesWhatSewMakesWhole) {
  int tips = 0, inside = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    test::SyntheticMesh made = test::make_synthetic({.columns = 24, .rows = 20, .seed = seed});
    const auto corners = corners_of(made.mesh);
    const auto neighbours = neighbours_of(made.mesh);
    // In one piece is each inner node with a sliding neighbour and at most one that is a node.
    std::vector<std::uint8_t> nodes(made.mesh.vertex_slots(), 0), open(nodes.size(), 0);
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
      const VertexId v(i);
      std::size_t lines = 0;
      for_each_constrained_neighbour(made.mesh, made.tags, v, [&](VertexId) { ++lines; });
      const std::size_t others = joined_nodes(made, v).size();
      const bool inner = made.tags.support[v].is_node() && !made.mesh.on_boundary(v);
      nodes[i] = inner && lines > others && others <= 1 ? 1 : 0;
    }
    // It is the tip of a slit if that one is not.
    for (std::uint32_t i = 0; i < nodes.size(); ++i)
      for (const VertexId w : joined_nodes(made, VertexId(i)))
        open[i] = nodes[i] != 0 && nodes[w.value()] == 0 ? 1 : 0;
    cut_open(made.mesh, made.tags);
    sew_pieces(made.mesh, made.tags, nodes);
    EXPECT_EQ(validate(made.mesh, GeometryCheck::kNone), "");
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
      if (nodes[i] == 0) continue;
      EXPECT_EQ(made.mesh.on_boundary(VertexId(i)), open[i] != 0) << "vertex " << i;
      ++(open[i] != 0 ? tips : inside);
    }
    sew(made.mesh, made.tags);
    EXPECT_EQ(corners_of(made.mesh), corners);
    EXPECT_EQ(neighbours_of(made.mesh), neighbours);
  }
  EXPECT_GT(tips, 0);
  EXPECT_GT(inside, 10);
}

TEST(CutOpen, GivesTheSameMeshOnAnyNumberOfThreads) {
  std::vector<std::uint64_t> cut, sewn;
  for (const int threads : {1, 2, 4, 7}) {
    parallel::with_threads(threads, [&] {
      test::SyntheticMesh made = test::make_synthetic(
          {.columns = 60, .rows = 50, .seed = 5, .straight_lines = 30, .crooked_lines = 30});
      const parallel::ParticipationProbe probe;
      cut_open(made.mesh, made.tags);
      const auto open = test::arrays_of(made.mesh);
      sew(made.mesh, made.tags);
      if (threads == 1) {
        cut = open;
        sewn = test::arrays_of(made.mesh);
        return;
      }
      EXPECT_GT(probe.chunks_of_other_threads(), 0U);
      EXPECT_EQ(open, cut);
      EXPECT_EQ(test::arrays_of(made.mesh), sewn);
    });
  }
}

}  // namespace
}  // namespace quarry
