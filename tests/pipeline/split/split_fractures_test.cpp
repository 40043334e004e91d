// Meshes that are split along their lines: what is doubled, and what stays one.
#include "pipeline/split/split_fractures.hpp"

#include <algorithm>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "engine/mesh/validate.hpp"
#include "io/mesh/cell_nodes.hpp"
#include "io/mesh/mesh_format.hpp"
#include "pipeline/section/section.hpp"
#include "tests/io/mesh/mesh_comparison.hpp"
#include "tests/io/mesh/temporary_folder.hpp"

namespace quarry {
namespace {

// Squares of edge 1 over [0, size]^2, and lines along their edges.
class Squares {
 public:
  explicit Squares(std::uint32_t size) : size_(size) {
    std::vector<double> x, y;
    std::vector<FaceCorners> faces;
    for (std::uint32_t j = 0; j <= size; ++j)
      for (std::uint32_t i = 0; i <= size; ++i) {
        x.push_back(i);
        y.push_back(j);
        if (i < size && j < size) faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
      }
    mesh_ = build_mesh(x, y, faces);
    constraint_ = mesh_.add_tag<EdgeId, std::int32_t>("constraint", -1);
  }

  // From one point to another on the same row or column, in steps that may go against the line.
  void add_line(std::int32_t number, std::uint32_t i, std::uint32_t j, std::uint32_t to_i,
                std::uint32_t to_j) {
    for (bool turn = false; i != to_i || j != to_j; turn = !turn) {
      const VertexId from = at(i, j);
      i += i < to_i ? 1 : 0;
      j += j < to_j ? 1 : 0;
      const EdgeId e = turn ? mesh_.add_edge(at(i, j), from) : mesh_.add_edge(from, at(i, j));
      constraint_[e] = number;
    }
  }

  Mesh split(SplitReport& report) { return split_fractures(std::move(mesh_), report); }

 private:
  [[nodiscard]] VertexId at(std::uint32_t i, std::uint32_t j) const { return VertexId(j * (size_ + 1) + i); }

  std::uint32_t size_;
  Mesh mesh_;
  Tag<EdgeId, std::int32_t> constraint_;
};

std::map<std::pair<double, double>, int> copies_of(const Mesh& mesh) {
  std::map<std::pair<double, double>, int> copies;
  for (const VertexId v : mesh.vertices())
    if (mesh.alive(v)) ++copies[{mesh.point(v).x, mesh.point(v).y}];
  return copies;
}

TEST(SplitFractures, DoubleALineButNotItsTips) {
  Squares squares(6);
  squares.add_line(0, 1, 3, 5, 3);
  SplitReport report;
  const Mesh mesh = squares.split(report);
  EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
  EXPECT_EQ(report.edges, 4U);
  EXPECT_EQ(report.new_nodes, 3U);
  const auto copies = copies_of(mesh);
  for (const auto& [point, count] : copies)
    EXPECT_EQ(count, point.second == 3 && point.first > 1 && point.first < 5 ? 2 : 1) << point.first;
}

TEST(SplitFractures, GiveEachSectorOfACrossingItsNode) {
  Squares squares(6);
  squares.add_line(0, 1, 3, 5, 3);
  squares.add_line(1, 3, 1, 3, 5);
  SplitReport report;
  const Mesh mesh = squares.split(report);
  EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
  auto copies = copies_of(mesh);
  EXPECT_EQ((copies[{3, 3}]), 4);
  EXPECT_EQ((copies[{2, 3}]), 2);
  EXPECT_EQ((copies[{3, 4}]), 2);
  EXPECT_EQ((copies[{5, 3}]), 1);
}

TEST(SplitFractures, GiveEachSectorOfAJunctionItsNode) {
  Squares squares(6);
  squares.add_line(0, 1, 3, 5, 3);
  squares.add_line(1, 3, 3, 3, 5);
  SplitReport report;
  auto copies = copies_of(squares.split(report));
  EXPECT_EQ((copies[{3, 3}]), 3);
}

TEST(SplitFractures, OpenTheBoundaryWhereALineEndsOnIt) {
  Squares squares(4);
  squares.add_line(0, 0, 2, 4, 2);
  squares.add_line(1, 0, 0, 4, 0);
  SplitReport report;
  const Mesh mesh = squares.split(report);
  EXPECT_EQ(report.edges, 4U) << "an edge of the boundary has one side";
  auto copies = copies_of(mesh);
  EXPECT_EQ((copies[{0, 2}]), 2);
  EXPECT_EQ((copies[{4, 2}]), 2);
  EXPECT_EQ((copies[{0, 0}]), 1);
}

TEST(SplitFractures, HaveLeftAndRightAllAlongALine) {
  Squares squares(6);
  squares.add_line(0, 1, 3, 5, 3);
  squares.add_line(0, 5, 3, 5, 5);  // the same line, around a corner
  SplitReport report;
  const Mesh mesh = squares.split(report);
  const MeshFileTags tags(mesh);
  ASSERT_EQ(mesh.edge_slots(), 12U);
  for (std::size_t i = 0; i < 12; i += 2) {
    const EdgeId left(i), right(i + 1);
    EXPECT_EQ(tags.side(left), kLeftSide);
    EXPECT_EQ(tags.side(right), kRightSide);
    const auto [a, b] = mesh.edge_ends(left);
    const auto [c, d] = mesh.edge_ends(right);
    EXPECT_EQ(mesh.point(a), mesh.point(c));
    EXPECT_EQ(mesh.point(b), mesh.point(d));
    EXPECT_TRUE(mesh.find_side(a, b).valid()) << "the face of the left edge is on its left";
    EXPECT_TRUE(mesh.find_side(d, c).valid());
    EXPECT_FALSE(mesh.neighbour(mesh.find_side(a, b)).valid());
    // Either along the whole line or against all of it.
    const Vec2 along = mesh.point(b) - mesh.point(a);
    const auto [first, second] = mesh.edge_ends(EdgeId(std::size_t{0}));
    EXPECT_EQ(along.x + along.y, mesh.point(second).x - mesh.point(first).x);
  }
}

TEST(SplitFractures, HaveMiddlesOfTheirOwnOnBothSides) {
  Squares squares(6);
  squares.add_line(0, 1, 3, 5, 3);
  SplitReport report;
  const Mesh mesh = squares.split(report);
  const LiveNumbering numbering(mesh);
  const CellNodes nodes(mesh, numbering, ElementOrder::kQuadratic);
  for (std::size_t i = 0; i < 8; i += 2) {
    EXPECT_NE(nodes.edge_node(i, 2), nodes.edge_node(i + 1, 2));
    EXPECT_EQ(nodes.point(nodes.edge_node(i, 2)), nodes.point(nodes.edge_node(i + 1, 2)));
  }
}

TEST(SplitFractures, ReadBackSplit) {
  const TemporaryFolder folder;
  for (const char* name : {"a.vtu", "a.msh", "a.inp", "a.avs", "a.mesh"}) {
    Squares squares(6);
    squares.add_line(4, 1, 3, 5, 3);
    squares.add_line(7, 3, 1, 3, 5);
    SplitReport report;
    const Mesh mesh = squares.split(report);
    write_mesh(folder.file(name), mesh, {});
    const Mesh back = read_mesh(folder.file(name));
    EXPECT_EQ(copies_of(back), copies_of(mesh)) << name;
    EXPECT_EQ(compared(back).faces, compared(mesh).faces) << name;
    std::multiset<std::int32_t> numbers;
    const MeshFileTags tags(back);
    for (const EdgeId e : back.edges()) numbers.insert(tags.constraint(e));
    EXPECT_EQ(numbers.count(4), 8U) << name;
    EXPECT_EQ(numbers.count(7), 8U) << name;
  }
}

TEST(SplitFractures, KeepFacesAreaAndLinesOfASection) {
  SectionOptions options;
  options.inputs = {"tests/data/demo_section.geojson"};
  options.size = 20;
  SectionResult result = mesh_section(options, {});
  const MeshFileTags before(result.mesh);
  std::size_t faces = result.mesh.count_alive_faces(), interior = 0, rest = 0;
  for (const EdgeId e : result.mesh.edges()) (before.kind(e) == kInteriorConstraint ? interior : rest) += 1;
  const auto faces_before = compared(result.mesh).faces;
  SplitReport report;
  const Mesh mesh = split_fractures(std::move(result.mesh), report);
  EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
  EXPECT_EQ(mesh.count_alive_faces(), faces);
  EXPECT_EQ(compared(mesh).faces, faces_before);
  EXPECT_EQ(mesh.edge_slots(), 2 * interior + rest);
  EXPECT_GT(report.new_nodes, interior / 2);
  const MeshFileTags tags(mesh);
  for (const EdgeId e : mesh.edges()) {
    const auto [a, b] = mesh.edge_ends(e);
    EXPECT_TRUE(mesh.find_side(a, b).valid() || mesh.find_side(b, a).valid());
    EXPECT_TRUE(tags.side(e) != kLeftSide || !mesh.neighbour(mesh.find_side(a, b)).valid());
  }
}

}  // namespace
}  // namespace quarry
