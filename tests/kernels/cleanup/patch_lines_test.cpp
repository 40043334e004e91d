#include "kernels/cleanup/patch_lines.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/mesh/build.hpp"
#include "engine/mesh/sectors.hpp"
#include "engine/mesh/validate.hpp"
#include "engine/operation/editor.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/cleanup/ideal.hpp"
#include "kernels/cleanup/node_slots.hpp"
#include "kernels/cleanup/patch_placement.hpp"
#include "kernels/cleanup/patch_remesh.hpp"
#include "tests/kernels/cleanup/line_measures.hpp"
#include "tests/kernels/cleanup/patch_meshes.hpp"
#include "tests/support/charge.hpp"
#include "tests/support/mesh_arrays.hpp"
#include "tests/support/synthetic_mesh.hpp"

namespace quarry {
namespace {

// Long lines: each piece has several vertices. Of crooked ones each is an edge.
test::SyntheticMesh cut_lines(std::uint64_t seed, int crooked = 0) {
  return test::cut_network({.columns = 24,
                            .rows = 20,
                            .seed = seed,
                            .jitter = 0.2,
                            .straight_lines = 5,
                            .crooked_lines = crooked,
                            .origin = {0, 0}});
}

// Of a whole mesh, which is cut open afterwards; with_nodes: they go along where they may.
PatchReport remesh_over_lines(Mesh& mesh, const NodedLines& lines, std::size_t largest,
                              bool with_nodes = true) {
  const ConstraintTags tags = ConstraintTags::of(mesh);
  const NodeSlots slots(lines);
  std::vector<std::uint8_t> nodes = find_regular_nodes(mesh, tags, slots);
  if (!with_nodes) nodes.assign(nodes.size(), 0);
  cut_open(mesh, tags);
  sew_pieces(mesh, tags, nodes);
  set_ideal_faces(mesh, PlaneModel());
  PatchOptions options;
  options.largest = largest;
  options.over_lines = &slots;
  PatchMemory memory;
  return remesh_patches(mesh, PlaneModel(), options, memory, Progress());
}

TEST(PatchesOverLines, KeepEveryLineCoveredAndLowerTheEnergy) {
  std::uint64_t won = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    test::SyntheticMesh given = cut_lines(seed, seed % 2 == 0 ? 3 : 0);
    Mesh& mesh = given.mesh;
    sew(mesh, given.tags);
    const auto before = test::covered(mesh, given.tags, given.lines);
    for (const std::size_t largest : {std::size_t{32}, std::size_t{128}}) {
      const int energy = test::energy_by_sectors(mesh);
      const int charge = test::charge_of(mesh);
      const PatchReport report = remesh_over_lines(mesh, given.lines, largest);
      EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
      sew(mesh, given.tags);
      EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
      EXPECT_EQ(test::charge_of(mesh), charge);
      const int now = test::energy_by_sectors(mesh);
      EXPECT_TRUE(report.count_won() > 0 ? now < energy : now == energy) << energy << " and " << now;
      won += report.count_won();
    }
    test::expect_covered(test::covered(mesh, given.tags, given.lines), before);
  }
  EXPECT_GT(won, 12U);
}

TEST(PatchesOverLines, WinMoreWhereNodesGoAlong) {
  std::uint64_t with = 0, without = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    for (const bool nodes : {true, false}) {
      test::SyntheticMesh given = cut_lines(seed);
      sew(given.mesh, given.tags);
      (nodes ? with : without) += remesh_over_lines(given.mesh, given.lines, 128, nodes).count_won();
    }
  }
  EXPECT_GT(with, without);
}

// The upper or, mirrored, the lower half of a rectangle whose middle line has two edges fewer than its other
// long sides: a row ends in each half.
struct Halves {
  static constexpr std::uint32_t kNear = 12, kFar = 14, kRows = 6;

  Mesh make() {
    // From (0, 0) along the line, up, back and down.
    const std::array<std::uint32_t, 4> lengths = {kNear, kRows, kFar, kRows};
    PatchFill fill = *solve_pair(lengths, 0);
    fill.split = kNear / 2;
    const std::array<std::uint32_t, 4> corners = {0, kNear, kNear + kRows, kNear + kRows + kFar};
    PatchLayout layout;
    layout.build(fill, kNear + 2 * kRows + kFar, {}, corners);
    std::vector<Vec2> points;
    const auto side = [&](Vec2 from, Vec2 to, std::uint32_t edges) {
      for (std::uint32_t i = 0; i < edges; ++i)
        points.push_back(from + (static_cast<double>(i) / edges) * (to - from));
    };
    side({0, 0}, {13, 0}, kNear);
    side({13, 0}, {13, 6}, kRows);
    side({13, 6}, {0, 6}, kFar);
    side({0, 6}, {0, 0}, kRows);
    place_layout(layout, points);
    LayoutNeighbours neighbours;
    relax_layout(layout, std::vector<bool>(layout.vertices()), points, neighbours);
    return mirror(layout, points);
  }

 private:
  // The first kNear + 1 vertices, on the line, are those of both halves.
  static Mesh mirror(const PatchLayout& layout, const std::vector<Vec2>& points) {
    const std::uint32_t count = layout.vertices();
    const auto below = [&](std::uint32_t v) { return VertexId(v <= kNear ? v : v + count - kNear - 1); };
    std::vector<double> x, y;
    for (const Vec2 p : points) {
      x.push_back(p.x);
      y.push_back(p.y);
    }
    for (std::uint32_t v = kNear + 1; v < count; ++v) {
      x.push_back(points[v].x);
      y.push_back(-points[v].y);
    }
    std::vector<FaceCorners> faces;
    for (const PatchLayout::Quad& quad : layout.quads()) {
      faces.push_back({VertexId(quad[0]), VertexId(quad[1]), VertexId(quad[2]), VertexId(quad[3])});
      faces.push_back({below(quad[3]), below(quad[2]), below(quad[1]), below(quad[0])});
    }
    return build_mesh(std::move(x), std::move(y), faces);
  }
};

TEST(PatchesOverLines, GiveALineTheEdgesThatBothSidesAskFor) {
  Mesh mesh = Halves().make();
  ConstraintTags tags = ConstraintTags::add_to(mesh);
  for (const VertexId v : mesh.vertices())
    if (mesh.on_boundary(v)) tags.support[v] = Support::fixed();
  for (std::uint32_t i = 0; i < Halves::kNear; ++i) {
    const SideId s = mesh.find_side(VertexId(i), VertexId(i + 1));
    tags.set_constrained(s, true);
    tags.set_constrained(mesh.neighbour(s), true);
    if (i > 0) tags.support[VertexId(i)] = Support::on(PieceId(0U));
  }
  ASSERT_EQ(test::energy_by_sectors(mesh), 4);
  const PatchReport report = remesh_over_lines(mesh, NodedLines(), 128);
  sew(mesh, tags);
  EXPECT_EQ(report.count_won(), 1U);
  EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
  EXPECT_EQ(test::energy_by_sectors(mesh), 0);
  std::size_t on_line = 0;
  for (const VertexId v : mesh.vertices()) {
    if (!mesh.alive(v) || !tags.support[v].slides()) continue;
    ++on_line;
    EXPECT_NEAR(mesh.point(v).y, 0, 1e-12);
  }
  EXPECT_EQ(on_line, Halves::kFar - 1);
}

// The vertices straight on from v, away from `back`, to the boundary.
std::vector<VertexId> straight_on(const Mesh& mesh, VertexId back, VertexId v) {
  std::vector<VertexId> way{v};
  while (!mesh.on_boundary(v)) {
    const SideId left = mesh.next(mesh.find_side(back, v));
    back = v;
    v = mesh.target(mesh.next(mesh.neighbour(left)));
    way.push_back(v);
  }
  return way;
}

// Halves with a node on the middle line beside the rows' ends, where other lines may leave it.
struct CrossedHalves {
  Mesh mesh = Halves().make();
  ConstraintTags tags = ConstraintTags::add_to(mesh);
  NodedLines lines;
  VertexId node{Halves::kNear / 2 - 1};

  CrossedHalves(bool up, bool down) {
    for (const VertexId v : mesh.vertices())
      if (mesh.on_boundary(v)) tags.support[v] = Support::fixed();
    std::vector<VertexId> left, right;
    for (std::uint32_t i = 0; i <= node.value(); ++i) left.push_back(VertexId(node.value() - i));
    for (std::uint32_t i = node.value(); i <= Halves::kNear; ++i) right.push_back(VertexId(i));
    tags.support[node] = Support::at(lines.nodes.push_back(mesh.point(node)));
    const SideId along = mesh.find_side(node, right[1]);
    const VertexId above = mesh.origin(mesh.previous(along));
    const VertexId below = mesh.target(mesh.next(mesh.neighbour(along)));
    add_piece(left);
    add_piece(right);
    if (up) add_piece(from_node(above));
    if (down) add_piece(from_node(below));
  }

  [[nodiscard]] std::vector<VertexId> from_node(VertexId next) const {
    std::vector<VertexId> way = straight_on(mesh, node, next);
    way.insert(way.begin(), node);
    return way;
  }

  // From the node on; its vertices move to the straight line between its ends.
  void add_piece(const std::vector<VertexId>& way) {
    const Vec2 from = mesh.point(node), whole = mesh.point(way.back()) - from;
    const PieceId piece = lines.pieces.push_back({NodeId(0U), lines.nodes.push_back(from + whole)});
    for (std::size_t i = 0; i + 1 < way.size(); ++i) {
      const SideId s = mesh.find_side(way[i], way[i + 1]);
      tags.set_constrained(s, true);
      tags.set_constrained(mesh.neighbour(s), true);
      if (i == 0) continue;
      tags.support[way[i]] = Support::on(piece);
      mesh.set_point(way[i], from + (static_cast<double>(i) / static_cast<double>(way.size() - 1)) * whole);
    }
  }
};

TEST(PatchesOverLines, TakeNodesAlong) {
  for (const auto& [up, down] : {std::pair(false, false), {true, false}, {false, true}, {true, true}}) {
    SCOPED_TRACE("up " + std::to_string(up) + ", down " + std::to_string(down));
    CrossedHalves stays(up, down);
    ASSERT_EQ(validate(stays.mesh, GeometryCheck::kPlanarCorners), "");
    EXPECT_EQ(remesh_over_lines(stays.mesh, stays.lines, 256, false).count_won(), 0U);
    CrossedHalves given(up, down);
    Mesh& mesh = given.mesh;
    ASSERT_EQ(test::energy_by_sectors(mesh), 4);
    const Vec2 place = mesh.point(given.node);
    const auto before = test::covered(mesh, given.tags, given.lines);
    const PatchReport report = remesh_over_lines(mesh, given.lines, 256);
    sew(mesh, given.tags);
    EXPECT_EQ(report.count_won(), 1U);
    EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
    EXPECT_EQ(test::energy_by_sectors(mesh), 0);
    EXPECT_EQ(mesh.point(given.node), place);
    test::expect_covered(test::covered(mesh, given.tags, given.lines), before);
  }
}

TEST(PatchesOverLines, AreTheSameOnAnyNumberOfThreads) {
  const auto remeshed = [] {
    test::SyntheticMesh given = cut_lines(3);
    sew(given.mesh, given.tags);
    remesh_over_lines(given.mesh, given.lines, 128);
    sew(given.mesh, given.tags);
    return test::arrays_of(given.mesh);
  };
  std::vector<std::uint64_t> serial;
  parallel::with_threads(1, [&] { serial = remeshed(); });
  for (const int threads : {2, 4, 7}) {
    std::vector<std::uint64_t> result;
    parallel::with_threads(threads, [&] { result = remeshed(); });
    EXPECT_EQ(result, serial) << threads << " threads";
  }
}

#ifdef QUARRY_CHECK_CLAIMS
TEST(PatchesOverLines, StayInsideTheirClaims) {
  reset_claim_violations();
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    test::SyntheticMesh given = cut_lines(seed);
    sew(given.mesh, given.tags);
    remesh_over_lines(given.mesh, given.lines, 128);
  }
  EXPECT_EQ(claim_violations().count, 0U) << claim_violations().first;
}
#endif

}  // namespace
}  // namespace quarry
