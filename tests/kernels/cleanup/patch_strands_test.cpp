// Lines on a lattice of squares, seen from a patch in its middle, and traced through a grid as large.
#include "kernels/cleanup/patch_strands.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/mesh/build.hpp"
#include "engine/mesh/sectors.hpp"
#include "kernels/cleanup/ideal.hpp"
#include "kernels/cleanup/patch_lines.hpp"
#include "kernels/cleanup/patch_placement.hpp"

namespace quarry {
namespace {

using Place = std::pair<int, int>;  // column and row

class LinesOnLattice : public testing::Test {
 protected:
  static constexpr int kSide = 8;

  LinesOnLattice() {
    std::vector<double> x, y;
    for (int row = 0; row <= kSide; ++row) {
      for (int column = 0; column <= kSide; ++column) {
        x.push_back(column);
        y.push_back(row);
      }
    }
    std::vector<FaceCorners> faces;
    for (int row = 0; row < kSide; ++row)
      for (int column = 0; column < kSide; ++column)
        faces.push_back(
            {at({column, row}), at({column + 1, row}), at({column + 1, row + 1}), at({column, row + 1})});
    mesh_ = build_mesh(std::move(x), std::move(y), faces);
    tags_ = ConstraintTags::add_to(mesh_);
  }

  static VertexId at(Place place) {
    return VertexId(static_cast<std::uint32_t>(place.second * (kSide + 1) + place.first));
  }

  NodeId node_at(Place place) {
    const auto [found, is_new] = nodes_.try_emplace(place, NodeId());
    if (is_new) found->second = lines_.nodes.push_back(mesh_.point(at(place)));
    tags_.support[at(place)] = Support::at(found->second);
    return found->second;
  }

  // A straight piece along a column or a row.
  void add_piece(Place from, Place to) {
    const PieceId piece = lines_.pieces.push_back({node_at(from), node_at(to)});
    const auto step = [](int a, int b) { return a < b ? 1 : (a > b ? -1 : 0); };
    for (Place v = from; v != to;) {
      const Place w{v.first + step(v.first, to.first), v.second + step(v.second, to.second)};
      const SideId s = mesh_.find_side(at(v), at(w));
      tags_.set_constrained(s, true);
      tags_.set_constrained(mesh_.neighbour(s), true);
      if (w != to) tags_.support[at(w)] = Support::on(piece);
      v = w;
    }
  }

  // Sews the mesh, grows a patch of all squares but those on the boundary, and finds its strands.
  bool find() {
    slots_.emplace(lines_);
    const auto nodes = find_regular_nodes(mesh_, tags_, *slots_);
    cut_open(mesh_, tags_);
    sew_pieces(mesh_, tags_, nodes);
    set_ideal_faces(mesh_, PlaneModel());
    stars_.emplace(mesh_, IrregularPrice(), &*slots_);
    growth_.begin(mesh_, *stars_, 64);
    for (int row = 2; row < kSide - 1; ++row)
      for (int column = 2; column < kSide - 1; ++column) EXPECT_TRUE(growth_.add_star(at({column, row})));
    EXPECT_TRUE(growth_.make_convex());
    growth_.walk_rim(rim_);
    return strands_.find(mesh_, *stars_, growth_, rim_);
  }

  // Through the grid that is there: every node and every vertex of a line must come to lie where it was.
  void expect_traced(std::size_t lines, std::size_t nodes) {
    constexpr std::uint32_t kEdges = kSide - 2;
    ASSERT_EQ(rim_.size(), 4 * kEdges);
    PatchLayout layout;
    layout.build(*solve_fill(std::array{kEdges, kEdges, kEdges, kEdges}), 4 * kEdges, {},
                 std::array{0U, kEdges, 2 * kEdges, 3 * kEdges});
    std::vector<Vec2> points;
    for (const VertexId v : rim_) points.push_back(mesh_.point(v));
    place_layout(layout, points);
    ASSERT_TRUE(traced_.trace(layout, strands_));
    EXPECT_EQ(traced_.lines().size(), lines);
    EXPECT_EQ(traced_.nodes().size(), nodes);
    for (const PatchNode& node : traced_.nodes()) EXPECT_EQ(points[node.place], mesh_.point(node.vertex));
    for (const PatchLine& line : traced_.lines()) {
      for (std::size_t i = 1; i + 1 < line.trace.size(); ++i) {
        const Vec2 p = points[line.trace[i]];
        EXPECT_EQ(tags_.support[at({static_cast<int>(p.x), static_cast<int>(p.y)})], line.support);
      }
    }
  }

  Mesh mesh_;
  ConstraintTags tags_;
  NodedLines lines_;
  std::map<Place, NodeId> nodes_;
  std::optional<NodeSlots> slots_;
  std::optional<PatchStars> stars_;
  PatchGrowth growth_;
  std::vector<VertexId> rim_;
  PatchStrands strands_;
  PatchLines traced_;
};

TEST_F(LinesOnLattice, GoStraightOnWhereTheyCross) {
  for (const Place& end : {Place{0, 3}, {8, 3}, {4, 0}, {4, 8}}) add_piece({4, 3}, end);
  ASSERT_TRUE(find());
  EXPECT_EQ(strands_.strands().size(), 2U);
  expect_traced(4, 1);
}

TEST_F(LinesOnLattice, EndOnAnother) {
  for (const Place& end : {Place{0, 3}, {8, 3}, {4, 8}}) add_piece({4, 3}, end);
  ASSERT_TRUE(find());
  expect_traced(3, 1);
}

TEST_F(LinesOnLattice, TurnRoundACornerEitherWay) {
  add_piece({3, 0}, {3, 3});
  add_piece({3, 3}, {0, 3});
  add_piece({5, 0}, {5, 5});
  add_piece({5, 5}, {8, 5});
  ASSERT_TRUE(find());
  EXPECT_EQ(strands_.strands().size(), 4U);
  expect_traced(4, 2);
}

TEST_F(LinesOnLattice, KeepSeveralNodesAndADeadEnd) {
  add_piece({0, 4}, {2, 4});
  add_piece({2, 4}, {3, 4});
  add_piece({3, 4}, {5, 4});
  ASSERT_TRUE(find());
  EXPECT_EQ(strands_.strands().size(), 1U);
  expect_traced(3, 3);
}

TEST_F(LinesOnLattice, MayNotLieInsideAlone) {
  add_piece({0, 2}, {8, 2});
  add_piece({3, 4}, {5, 4});
  EXPECT_FALSE(find());
}

TEST_F(LinesOnLattice, MayNotJoinTwoOthersInside) {
  for (const int row : {2, 6}) {
    add_piece({0, row}, {4, row});
    add_piece({4, row}, {8, row});
  }
  add_piece({4, 2}, {4, 6});
  EXPECT_FALSE(find());
}

TEST_F(LinesOnLattice, AreFoundOnlyWhereThereIsOne) { EXPECT_FALSE(find()); }

TEST_F(LinesOnLattice, DoNotPassThroughAGridThatShiftsThem) {
  for (const Place& end : {Place{0, 3}, {8, 3}, {4, 0}, {4, 8}}) add_piece({4, 3}, end);
  ASSERT_TRUE(find());
  // Its corners lie one place further along the rim.
  PatchLayout layout;
  layout.build(*solve_fill(std::array{6U, 6U, 6U, 6U}), 24, {}, std::array{1U, 7U, 13U, 19U});
  EXPECT_FALSE(traced_.trace(layout, strands_));
}

}  // namespace
}  // namespace quarry
