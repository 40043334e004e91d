#include "engine/mesh/domain.hpp"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/mesh/compact.hpp"
#include "engine/mesh/validate.hpp"
#include "tests/support/mesh_zoo.hpp"

namespace quarry {
namespace {

// A lattice of 8 by 8 cells in which closed or open chains of lattice points become pieces.
class MarkedLattice {
 public:
  MarkedLattice() : mesh(test::triangle_lattice(8, 8)), tags(ConstraintTags::add_to(mesh)) {
    for (const VertexId v : mesh.vertices())
      if (mesh.on_boundary(v)) tags.support[v] = Support::fixed();
  }

  static VertexId at(std::uint32_t column, std::uint32_t row) { return VertexId(row * 9 + column); }

  NodeId node_at(VertexId v) {
    if (!tags.support[v].is_node()) tags.support[v] = Support::at(lines.nodes.push_back(mesh.point(v)));
    return tags.support[v].node();
  }

  // One piece an edge, with the numbers of the lines that run along it.
  void chain(const std::vector<VertexId>& points, PieceKindOf kind,
             const std::vector<std::uint32_t>& numbers) {
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const NodeId a = node_at(points[i]);
      const NodeId b = node_at(points[i + 1]);
      lines.pieces.push_back({a, b, kind});
      lines.line_begin.push_back(static_cast<std::uint32_t>(lines.line_numbers.size()));
      for (const std::uint32_t number : numbers) lines.line_numbers.push_back(LineId(number));
      const SideId s = mesh.find_side(points[i], points[i + 1]);
      const SideId t = mesh.find_side(points[i + 1], points[i]);
      if (s.valid()) tags.set_constrained(s, true);
      if (t.valid()) tags.set_constrained(t, true);
    }
  }

  // A closed chain around the cells from low to high.
  void square(std::uint32_t low, std::uint32_t high, PieceKindOf kind,
              const std::vector<std::uint32_t>& numbers) {
    std::vector<VertexId> points;
    for (std::uint32_t i = low; i < high; ++i) points.push_back(at(i, low));
    for (std::uint32_t i = low; i < high; ++i) points.push_back(at(high, i));
    for (std::uint32_t i = high; i > low; --i) points.push_back(at(i, high));
    for (std::uint32_t i = high; i > low; --i) points.push_back(at(low, i));
    points.push_back(points.front());
    chain(points, kind, numbers);
  }

  const NodedLines& finish() {
    lines.line_begin.push_back(static_cast<std::uint32_t>(lines.line_numbers.size()));
    return lines;
  }

  Mesh mesh;
  ConstraintTags tags;
  NodedLines lines;
};

TEST(RemoveOutside, KeepsWhatTheOutlineEncloses) {
  MarkedLattice lattice;
  lattice.square(1, 7, PieceKindOf::kOutline, {0});
  EXPECT_EQ(remove_outside(lattice.mesh, lattice.tags, lattice.finish()), 2U * (64 - 36));
  EXPECT_EQ(lattice.mesh.count_alive_faces(), 72U);
  EXPECT_EQ(validate(lattice.mesh, GeometryCheck::kPlanarCorners), "");
}

TEST(RemoveOutside, LeavesHolesEmptyAndIslandsInThemFull) {
  MarkedLattice lattice;
  lattice.square(1, 7, PieceKindOf::kOutline, {0});
  lattice.square(2, 6, PieceKindOf::kOutline, {1});
  lattice.square(3, 5, PieceKindOf::kOutline, {2});
  remove_outside(lattice.mesh, lattice.tags, lattice.finish());
  EXPECT_EQ(lattice.mesh.count_alive_faces(), 2U * (36 - 16 + 4));
  EXPECT_EQ(validate(lattice.mesh, GeometryCheck::kPlanarCorners), "");
}

TEST(RemoveOutside, IsNotStoppedByInteriorPieces) {
  MarkedLattice lattice;
  lattice.square(1, 7, PieceKindOf::kOutline, {0});
  lattice.square(3, 5, PieceKindOf::kInterior, {1});
  remove_outside(lattice.mesh, lattice.tags, lattice.finish());
  EXPECT_EQ(lattice.mesh.count_alive_faces(), 72U);
}

TEST(RemoveOutside, TakesTheInsideOfAHullThatIsTheOutline) {
  MarkedLattice lattice;
  lattice.square(0, 8, PieceKindOf::kOutline, {0});
  EXPECT_EQ(remove_outside(lattice.mesh, lattice.tags, lattice.finish()), 0U);
  EXPECT_EQ(lattice.mesh.count_alive_faces(), 128U);
}

TEST(LabelRegions, NumbersWhatConstraintsEncloseFromZeroByFirstFace) {
  MarkedLattice lattice;
  lattice.square(3, 5, PieceKindOf::kInterior, {0});
  EXPECT_EQ(label_regions(lattice.mesh, lattice.tags), 2);
  const auto region = lattice.mesh.find_tag<FaceId, std::int32_t>("region");
  EXPECT_EQ(region[FaceId(0U)], 0);
  EXPECT_EQ(std::count(region.values().begin(), region.values().end(), 1), 8);
}

TEST(LabelRegions, DoesNotSeparateAtADanglingLine) {
  MarkedLattice lattice;
  lattice.chain({MarkedLattice::at(2, 4), MarkedLattice::at(3, 4), MarkedLattice::at(4, 4)},
                PieceKindOf::kInterior, {0});
  EXPECT_EQ(label_regions(lattice.mesh, lattice.tags), 1);
}

TEST(LabelRegions, NumbersComponentsApart) {
  Mesh mesh = test::two_components();
  EXPECT_EQ(label_regions(mesh, ConstraintTags::add_to(mesh)), 2);
}

TEST(LabelRegions, MayBeCalledAgain) {
  MarkedLattice lattice;
  EXPECT_EQ(label_regions(lattice.mesh, lattice.tags), 1);
  lattice.square(3, 5, PieceKindOf::kInterior, {0});
  EXPECT_EQ(label_regions(lattice.mesh, lattice.tags), 2);
}

TEST(ExtractEdges, MakesOneEdgeForEachLineAlongAPiece) {
  MarkedLattice lattice;
  lattice.chain({MarkedLattice::at(2, 4), MarkedLattice::at(3, 4)}, PieceKindOf::kInterior, {4, 9});
  extract_edges(lattice.mesh, lattice.tags, lattice.finish());
  const auto constraint = lattice.mesh.find_tag<EdgeId, std::int32_t>("constraint");
  const auto kind = lattice.mesh.find_tag<EdgeId, std::int32_t>("kind");
  std::multiset<std::int32_t> interior;
  std::size_t boundary = 0;
  for (const EdgeId e : lattice.mesh.edges()) {
    if (kind[e] == kKindInterior) interior.insert(constraint[e]);
    if (kind[e] == kKindBoundary) {
      EXPECT_EQ(constraint[e], -1);
      ++boundary;
    }
  }
  EXPECT_EQ(interior, (std::multiset<std::int32_t>{4, 9}));
  EXPECT_EQ(boundary, 32U);
}

TEST(ExtractEdges, TellsOutlinePiecesThatAreNoInputLine) {
  MarkedLattice lattice;
  lattice.square(1, 7, PieceKindOf::kOutline, {});
  remove_outside(lattice.mesh, lattice.tags, lattice.finish());
  extract_edges(lattice.mesh, lattice.tags, lattice.lines);
  const auto constraint = lattice.mesh.find_tag<EdgeId, std::int32_t>("constraint");
  const auto kind = lattice.mesh.find_tag<EdgeId, std::int32_t>("kind");
  EXPECT_EQ(lattice.mesh.edge_slots(), 24U);
  for (const EdgeId e : lattice.mesh.edges()) {
    EXPECT_EQ(constraint[e], -1);
    EXPECT_EQ(kind[e], kKindBoundary);
  }
}

TEST(PieceFinder, FindsPiecesByTheirEndsInBothDirections) {
  MarkedLattice lattice;
  lattice.chain({MarkedLattice::at(1, 1), MarkedLattice::at(2, 1), MarkedLattice::at(2, 2)},
                PieceKindOf::kInterior, {0});
  const NodedLines& lines = lattice.finish();
  const PieceFinder finder(lines);
  EXPECT_EQ(finder.between(NodeId(0U), NodeId(1U)), PieceId(0U));
  EXPECT_EQ(finder.between(NodeId(1U), NodeId(0U)), PieceId(0U));
  EXPECT_FALSE(finder.between(NodeId(0U), NodeId(2U)).valid());
  EXPECT_EQ(finder.at(NodeId(1U)).size(), 2U);
  EXPECT_EQ(finder.under_edge(Support::on(PieceId(1U)), Support::at(NodeId(2U))), PieceId(1U));
}

TEST(Support, TellsWhatAVertexIsBoundTo) {
  EXPECT_TRUE(Support().is_free());
  EXPECT_FALSE(Support().is_fixed());
  EXPECT_FALSE(Support().slides());
  EXPECT_TRUE(Support::fixed().is_fixed());
  EXPECT_FALSE(Support::fixed().is_node());
  EXPECT_TRUE(Support::at(NodeId(3U)).is_node());
  EXPECT_TRUE(Support::at(NodeId(3U)).is_fixed());
  EXPECT_EQ(Support::at(NodeId(3U)).node(), NodeId(3U));
  EXPECT_TRUE(Support::on(PieceId(5U)).slides());
  EXPECT_EQ(Support::on(PieceId(5U)).piece(), PieceId(5U));
}

}  // namespace
}  // namespace quarry
