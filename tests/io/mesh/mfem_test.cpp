#include <map>

#include "engine/parallel/parallel.hpp"
#include "tests/io/mesh/mesh_comparison.hpp"
#include "tests/io/mesh/read_error.hpp"
#include "tests/io/mesh/sample_mesh.hpp"

namespace quarry {
namespace {

TEST(Mfem, GivesBackTheMeshThatWasWrittenWithEachEdgeOnce) {
  const TemporaryFolder folder;
  for (const std::uint32_t size : {5U, 260U}) {
    const Mesh mesh = make_sample_mesh({.size = size, .corner = {6.7e6, 0.1}});
    write_mesh(folder.file("a.mesh"), mesh, {.fields = {{"options", "size=2"}}});
    ComparedMesh expected = compared(mesh);
    // Sorted by number: the first of those with the same ends has the smallest.
    std::map<std::pair<ComparedPoint, ComparedPoint>, bool> seen;
    std::erase_if(expected.edges, [&](const auto& edge) {
      return std::exchange(seen[{std::get<2>(edge), std::get<3>(edge)}], true);
    });
    EXPECT_EQ(compared(read_mesh(folder.file("a.mesh"))), expected);
  }
}

TEST(Mfem, GivesBackASurface) {
  const TemporaryFolder folder;
  const std::vector<FaceCorners> faces = {{VertexId(std::size_t{0}), VertexId(std::size_t{1}),
                                           VertexId(std::size_t{2}), VertexId(std::size_t{3})}};
  const Mesh mesh = build_mesh({0, 1, 1, 0}, {0, 0, 1, 1}, {0, 0.5, 1, 0.5}, faces);
  write_mesh(folder.file("a.mesh"), mesh, {});
  EXPECT_EQ(compared(read_mesh(folder.file("a.mesh"))), compared(mesh));
}

TEST(Mfem, HasTheSameBytesOnAnyNumberOfThreads) {
  const TemporaryFolder folder;
  const Mesh mesh = make_sample_mesh({.size = 150});
  parallel::with_threads(1, [&] { write_mesh(folder.file("a.mesh"), mesh, {}); });
  parallel::with_threads(4, [&] { write_mesh(folder.file("b.mesh"), mesh, {}); });
  EXPECT_TRUE(file_content(folder.file("a.mesh")) == file_content(folder.file("b.mesh")));
}

TEST(Mfem, ReadsAttributesAsRegionsAndLines) {
  const ReadCells cells =
      read_text_as("a.mesh",
                   "MFEM mesh v1.0\r\n\n#\n# a comment\ndimension\n2\n\nelements\n2\n1 3 0 1 2 3\n"
                   "5 2 3 2 4\n\nboundary\n2\n1 1 0 1\n4 1 3 2\n\nvertices\n5\n2\n0 0\n1 0\n1 1\n"
                   "0 1\n0.5 2\n");
  ASSERT_EQ(cells.faces.size(), 2U);
  EXPECT_EQ(cells.regions, (std::vector<std::int32_t>{0, 4}));
  EXPECT_EQ(cells.constraints, (std::vector<std::int32_t>{-1, 2}));
  EXPECT_EQ(cells.x[4], 0.5);
  EXPECT_EQ(cells.faces[1][2].value(), 4U);
}

TEST(Mfem, NamesTheLineOfWhatItCannotRead) {
  expect_read_error("a.mesh", "", "\"MFEM mesh v1.0\" is expected");
  expect_read_error("a.mesh", "MeshVersionFormatted 2\n", "a.mesh:1: \"MFEM mesh v1.0\" is expected");
  expect_read_error("a.mesh", "MFEM NURBS mesh v1.0\n", "is expected, not \"MFEM NURBS mesh v1.0\"");
  const std::string start = "MFEM mesh v1.0\ndimension\n2\n";
  expect_read_error("a.mesh", "MFEM mesh v1.0\ndimension\n3\n", "a.mesh:3: a mesh of dimension 3");
  expect_read_error("a.mesh", start + "elements\n", "a.mesh:4: the file ends too early: a count is missing");
  expect_read_error("a.mesh", start + "elements\n9223372036854775807\n",
                    "elements are announced, 0 lines follow");
  expect_read_error("a.mesh", start + "elements\n1\n1 3 0 1 2 3\n", "a.mesh:6: point 0 does not exist");
  expect_read_error("a.mesh", start + "elements\n1\n1 5 0 1 2 3\n", "a.mesh:6: an element of geometry 5");
  expect_read_error("a.mesh", start + "elements\n1\n0 3 0 1 2 3\n", "a.mesh:6: an attribute of 0");
  expect_read_error("a.mesh", start + "boundary\n1\n1 3 0 1 2 3\n",
                    "a.mesh:6: a boundary element of geometry 3");
  expect_read_error("a.mesh", start + "vertices\n1\n\nnodes\nFiniteElementSpace\n",
                    "a.mesh:7: a curved mesh");
  expect_read_error("a.mesh", start + "vertices\n2\n2\n0 0\n",
                    "the file ends too early: 2 vertices are announced");
  expect_read_error("a.mesh", start + "vertices\n1\n2\n0 inf\n",
                    "a.mesh:7: a coordinate is not a finite number");
  expect_read_error("a.mesh", start + "hexes\n",
                    "a.mesh:4: dimension, elements, boundary or vertices is expected");
}

}  // namespace
}  // namespace quarry
