#include "pipeline/improve/tagged_lines.hpp"

#include <algorithm>
#include <tuple>

#include <gtest/gtest.h>

#include "engine/mesh/build.hpp"
#include "engine/mesh/validate.hpp"
#include "io/mesh/mesh_file.hpp"

namespace quarry {
namespace {

// A square of n by n unit quads; vertex (i, j) has the number j * (n + 1) + i.
class Square {
 public:
  explicit Square(std::uint32_t n) : n_(n) {}

  [[nodiscard]] VertexId at(std::uint32_t i, std::uint32_t j) const { return VertexId(j * (n_ + 1) + i); }
  // region(i, j) of each quad.
  template <class Region>
  [[nodiscard]] Mesh mesh(Region&& region) const {
    std::vector<double> x, y;
    for (std::uint32_t j = 0; j <= n_; ++j)
      for (std::uint32_t i = 0; i <= n_; ++i) {
        x.push_back(i);
        y.push_back(j);
      }
    std::vector<FaceCorners> faces;
    std::vector<std::int32_t> regions;
    for (std::uint32_t j = 0; j < n_; ++j)
      for (std::uint32_t i = 0; i < n_; ++i) {
        faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
        regions.push_back(region(i, j));
      }
    Mesh mesh = build_mesh(std::move(x), std::move(y), faces);
    mesh.add_tag<FaceId, std::int32_t>("region").values().raw() = std::move(regions);
    return mesh;
  }
  [[nodiscard]] Mesh mesh() const {
    return mesh([](std::uint32_t, std::uint32_t) { return 0; });
  }

 private:
  std::uint32_t n_;
};

using Edge = std::tuple<VertexId, VertexId, std::int32_t, std::int32_t>;  // ends, number, kind

std::vector<Edge> edges_of(const Mesh& mesh) {
  const auto constraint = mesh.find_tag<EdgeId, std::int32_t>("constraint");
  const auto kind = mesh.find_tag<EdgeId, std::int32_t>("kind");
  std::vector<Edge> edges;
  for (const EdgeId e : mesh.edges()) {
    const auto [a, b] = mesh.edge_ends(e);
    edges.emplace_back(std::min(a, b), std::max(a, b), constraint[e], kind[e]);
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

std::size_t count_numbered(const Mesh& mesh, std::int32_t number) {
  std::size_t count = 0;
  for (const Edge& edge : edges_of(mesh)) count += std::get<2>(edge) == number ? 1U : 0U;
  return count;
}

TEST(TaggedLines, TheBoundaryOfASquareIsFourPieces) {
  Mesh mesh = Square(4).mesh();
  const TaggedLines lines = bind_lines(mesh, {}, 1e-9);
  EXPECT_EQ(lines.lines.nodes.size(), 4U);
  ASSERT_EQ(lines.lines.pieces.size(), 4U);
  for (const Piece& piece : lines.lines.pieces) EXPECT_EQ(piece.kind, PieceKindOf::kOutline);
  const auto tags = ConstraintTags::of(mesh);
  EXPECT_TRUE(tags.support[Square(4).at(0, 0)].is_node());
  EXPECT_TRUE(tags.support[Square(4).at(2, 0)].slides());
  EXPECT_TRUE(tags.support[Square(4).at(2, 2)].is_free());
}

TEST(TaggedLines, ATaggedLineEndsInNodesAndSlidesBetween) {
  const Square square(4);
  Mesh mesh = square.mesh();
  const TaggedLines lines =
      bind_lines(mesh, {{square.at(1, 2), square.at(2, 2), 7}, {square.at(3, 2), square.at(2, 2), 7}}, 1e-9);
  EXPECT_EQ(lines.lines.pieces.size(), 5U);
  const auto tags = ConstraintTags::of(mesh);
  EXPECT_TRUE(tags.support[square.at(1, 2)].is_node());
  EXPECT_TRUE(tags.support[square.at(2, 2)].slides());
  const PieceId piece = tags.support[square.at(2, 2)].piece();
  EXPECT_EQ(lines.lines.pieces[piece].kind, PieceKindOf::kInterior);
  EXPECT_EQ(lines.lines.numbers(piece).front(), LineId(7U));
}

TEST(TaggedLines, ALineThatChangesItsNumbersHasANodeThere) {
  const Square square(4);
  Mesh mesh = square.mesh();
  (void)bind_lines(mesh,
                   {{square.at(1, 2), square.at(2, 2), 7},
                    {square.at(2, 2), square.at(3, 2), 7},
                    {square.at(2, 2), square.at(3, 2), 8}},
                   1e-9);
  EXPECT_TRUE(ConstraintTags::of(mesh).support[square.at(2, 2)].is_node());
}

TEST(TaggedLines, GiveBackRegionsAndEdges) {
  const Square square(6);
  const auto region = [](std::uint32_t i, std::uint32_t j) { return i < 2 ? 4 : (j < 3 ? 9 : 4); };
  Mesh mesh = square.mesh(region);
  const std::vector<TaggedEdge> tagged = {
      {square.at(2, 0), square.at(2, 1), 3},  {square.at(2, 1), square.at(2, 2), 3},
      {square.at(2, 1), square.at(2, 2), 5},  {square.at(4, 4), square.at(5, 4), -1},
      {square.at(0, 0), square.at(0, 1), 11}, {square.at(5, 0), square.at(6, 0), -1}};
  const TaggedLines lines = bind_lines(mesh, tagged, 1e-9);
  restore_groups(mesh, lines);
  const auto found = mesh.find_tag<FaceId, std::int32_t>("region");
  for (std::uint32_t i = 0; i < 6; ++i)
    for (std::uint32_t j = 0; j < 6; ++j) EXPECT_EQ(found[FaceId(j * 6 + i)], region(i, j)) << i << " " << j;
  const std::vector<Edge> edges = edges_of(mesh);
  EXPECT_EQ(edges.size(), 24U + 4U) << "interfaces that are not tagged are no edges of the file";
  for (const TaggedEdge& e : tagged) {
    const bool outer = e.number == 11 || e.b == square.at(6, 0);
    const Edge wanted{std::min(e.a, e.b), std::max(e.a, e.b), e.number, outer ? 2 : 1};
    EXPECT_TRUE(std::binary_search(edges.begin(), edges.end(), wanted)) << e.number;
  }
}

TEST(TaggedLines, AnEdgeAcrossAFaceIsKeptWithItsEndsFixed) {
  const Square square(4);
  Mesh mesh = square.mesh();
  const TaggedLines lines = bind_lines(mesh, {{square.at(1, 1), square.at(2, 2), 6}}, 1e-9);
  EXPECT_EQ(lines.apart, 1U);
  EXPECT_TRUE(ConstraintTags::of(mesh).support[square.at(1, 1)].is_fixed());
  EXPECT_TRUE(ConstraintTags::of(mesh).support[square.at(2, 2)].is_fixed());
  restore_groups(mesh, lines);
  EXPECT_EQ(count_numbered(mesh, 6), 1U);
}

TEST(TaggedLines, ALongEdgeIsTheChainOfSidesThatCoverIt) {
  const Square square(4);
  Mesh mesh = square.mesh();
  const TaggedLines lines =
      bind_lines(mesh, {{square.at(3, 2), square.at(1, 2), 7}, {square.at(3, 2), square.at(3, 4), 7}}, 1e-9);
  EXPECT_EQ(lines.apart, 0U);
  const auto tags = ConstraintTags::of(mesh);
  EXPECT_TRUE(tags.support[square.at(2, 2)].slides());
  EXPECT_TRUE(tags.support[square.at(3, 3)].slides());
  EXPECT_TRUE(tags.support[square.at(3, 2)].is_node());
  restore_groups(mesh, lines);
  EXPECT_EQ(count_numbered(mesh, 7), 4U) << "each side bears the number";
}

TEST(TaggedLines, AMiddleThatIsRoundedOffItsEdgeStillBelongsToTheChain) {
  const Square square(4);
  Mesh mesh = square.mesh();
  mesh.set_point(square.at(2, 2), {2, 2 + 1e-6});
  const TaggedLines lines = bind_lines(mesh, {{square.at(1, 2), square.at(3, 2), 7}}, 1e-9);
  EXPECT_EQ(lines.apart, 0U);
  EXPECT_TRUE(ConstraintTags::of(mesh).support[square.at(2, 2)].is_node()) << "too far off to slide";
}

TEST(TaggedLines, AChainBesideALongEdgeDoesNotCoverIt) {
  const Square square(4);
  Mesh mesh = square.mesh();
  mesh.set_point(square.at(2, 2), {2, 2.01});
  const TaggedLines lines = bind_lines(mesh, {{square.at(1, 2), square.at(3, 2), 7}}, 0.1);
  EXPECT_EQ(lines.apart, 1U);
  EXPECT_TRUE(ConstraintTags::of(mesh).support[square.at(2, 2)].is_free());
}

TEST(TaggedLines, ARingWithoutANodeIsCutAtItsCorners) {
  const Square square(6);
  Mesh mesh = square.mesh(
      [](std::uint32_t i, std::uint32_t j) { return i >= 2 && i < 4 && j >= 2 && j < 4 ? 1 : 0; });
  const TaggedLines lines = bind_lines(mesh, {}, 1e-9);
  EXPECT_EQ(lines.lines.nodes.size(), 8U);
  EXPECT_EQ(lines.lines.pieces.size(), 8U);
  restore_groups(mesh, lines);
  const auto region = mesh.find_tag<FaceId, std::int32_t>("region");
  EXPECT_EQ(region[FaceId(2U * 6 + 2)], 1);
}

TEST(TaggedLines, GiveEachFanAtAPinchItsVertex) {
  // Two squares that share a corner.
  Mesh mesh = build_mesh({0, 1, 1, 0, 2, 2, 1}, {0, 0, 1, 1, 1, 2, 2},
                         std::vector<FaceCorners>{{VertexId(0U), VertexId(1U), VertexId(2U), VertexId(3U)},
                                                  {VertexId(2U), VertexId(4U), VertexId(5U), VertexId(6U)}});
  mesh.add_tag<FaceId, std::int32_t>("region");
  const TaggedLines lines = bind_lines(mesh, {}, 1e-9);
  EXPECT_EQ(mesh.vertex_slots(), 8U);
  EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
  EXPECT_EQ(lines.lines.pieces.size(), 8U);
  restore_groups(mesh, lines);
  EXPECT_EQ(mesh.edge_slots(), 8U);
}

TEST(TaggedLines, APointOfTheInputIsANodeAndComesBack) {
  const Square square(4);
  Mesh mesh = square.mesh();
  mesh.add_tag<VertexId, std::int32_t>(kPointTag, -1)[square.at(1, 2)] = 6;
  const TaggedLines lines = bind_lines(mesh, {}, 1e-9);
  EXPECT_EQ(lines.lines.nodes.size(), 5U);
  EXPECT_TRUE(ConstraintTags::of(mesh).support[square.at(1, 2)].is_node());
  restore_groups(mesh, lines);
  const auto point = mesh.find_tag<VertexId, std::int32_t>(kPointTag);
  for (const VertexId v : mesh.vertices()) EXPECT_EQ(point[v], v == square.at(1, 2) ? 6 : -1);
}

}  // namespace
}  // namespace quarry
