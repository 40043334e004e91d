// Elements of second order: the same corners and groups, and nodes in the middle that neighbours share.
#include <algorithm>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "engine/parallel/parallel.hpp"
#include "io/mesh/cell_nodes.hpp"
#include "io/mesh/mesh_format.hpp"
#include "tests/io/mesh/mesh_comparison.hpp"
#include "tests/io/mesh/sample_mesh.hpp"
#include "tests/io/mesh/temporary_folder.hpp"

namespace quarry {
namespace {

TEST(CellNodes, HaveOneMiddleForEachEdgeAndOneForEachQuad) {
  const Mesh mesh = make_sample_mesh({.size = 9});
  const LiveNumbering numbering(mesh);
  std::size_t quads = 0, sides = 0, rim = 0;
  for (const FaceId f : mesh.faces()) {
    quads += mesh.corner_count(f) == 4 ? 1 : 0;
    for (int k = 0; k < mesh.corner_count(f); ++k) {
      ++sides;
      rim += mesh.neighbour(SideId(f, k)).valid() ? 0 : 1;
    }
  }
  const std::size_t edges = (sides + rim) / 2;
  EXPECT_EQ(CellNodes(mesh, numbering, ElementOrder::kLinear).count(), mesh.vertex_slots());
  EXPECT_EQ(CellNodes(mesh, numbering, ElementOrder::kQuadratic).count(), mesh.vertex_slots() + edges);
  EXPECT_EQ(CellNodes(mesh, numbering, ElementOrder::kBiquadratic).count(),
            mesh.vertex_slots() + edges + quads);
}

TEST(CellNodes, LieInTheMiddleOfTheEdgesThatTheirElementsShare) {
  const Mesh mesh = make_sample_mesh({.size = 9, .corner = {6.7e6, 0.1}});
  const LiveNumbering numbering(mesh);
  const CellNodes nodes(mesh, numbering, ElementOrder::kBiquadratic);
  std::map<std::uint32_t, std::set<std::pair<VertexId, VertexId>>> edges_of_middle;
  for (const FaceId f : mesh.faces()) {
    const int corners = mesh.corner_count(f);
    for (int k = 0; k < corners; ++k) {
      const VertexId a = mesh.corner(f, k), b = mesh.corner(f, (k + 1) % corners);
      const std::uint32_t middle = nodes.face_node(f, corners + k);
      edges_of_middle[middle].insert({std::min(a, b), std::max(a, b)});
      EXPECT_EQ(nodes.point(middle), 0.5 * (mesh.point3(a) + mesh.point3(b)));
    }
  }
  for (const auto& [middle, edges] : edges_of_middle) EXPECT_EQ(edges.size(), 1U);
  for (std::size_t i = 0; i < numbering.edges().size(); ++i) {
    const auto [a, b] = mesh.edge_ends(numbering.edges()[i]);
    EXPECT_TRUE(edges_of_middle[nodes.edge_node(i, 2)].contains({std::min(a, b), std::max(a, b)}));
  }
}

struct Case {
  const char* extension;
  ElementOrder order;
};

class SecondOrder : public testing::TestWithParam<Case> {};

TEST_P(SecondOrder, ReadsBackAsItsCorners) {
  const TemporaryFolder folder;
  const std::string path = folder.file(std::string("mesh") + GetParam().extension);
  const Mesh mesh = make_sample_mesh({.size = 60});
  write_mesh(path, mesh, {.order = GetParam().order});
  EXPECT_EQ(compared(read_mesh(path)), compared(mesh));
}

TEST_P(SecondOrder, HasTheSameBytesOnAnyNumberOfThreads) {
  const TemporaryFolder folder;
  const std::string one = folder.file(std::string("one") + GetParam().extension);
  const std::string four = folder.file(std::string("four") + GetParam().extension);
  const Mesh mesh = make_sample_mesh({.size = 120});
  parallel::with_threads(1, [&] { write_mesh(one, mesh, {.order = GetParam().order}); });
  parallel::with_threads(4, [&] { write_mesh(four, mesh, {.order = GetParam().order}); });
  EXPECT_TRUE(file_content(one) == file_content(four));
}

INSTANTIATE_TEST_SUITE_P(All, SecondOrder,
                         testing::Values(Case{".vtu", ElementOrder::kQuadratic},
                                         Case{".vtu", ElementOrder::kBiquadratic},
                                         Case{".msh", ElementOrder::kQuadratic},
                                         Case{".msh", ElementOrder::kBiquadratic},
                                         Case{".inp", ElementOrder::kQuadratic}),
                         [](const auto& instance) {
                           return std::string(instance.param.extension + 1) +
                                  (instance.param.order == ElementOrder::kBiquadratic ? "Full" : "");
                         });

TEST(SecondOrderFormats, AreNamedWhereAFormatHasNone) {
  for (const auto& [path, order] : {std::pair("a.obj", ElementOrder::kQuadratic),
                                    {"a.avs", ElementOrder::kQuadratic},
                                    {"a.inp", ElementOrder::kBiquadratic}}) {
    try {
      check_writable_order(path, order);
      FAIL() << "no error";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kUsage);
      EXPECT_NE(error.message().find("has no such elements of second order; write one of .vtu, .msh"),
                std::string::npos)
          << error.message();
    }
  }
}

}  // namespace
}  // namespace quarry
