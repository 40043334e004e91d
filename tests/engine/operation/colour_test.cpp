#include "engine/operation/colour.hpp"

#include <numeric>

#include <gtest/gtest.h>

#include "engine/parallel/parallel.hpp"
#include "tests/support/mesh_zoo.hpp"

namespace quarry {
namespace {

std::vector<std::uint32_t> all_vertices(const Mesh& mesh) {
  std::vector<std::uint32_t> vertices(mesh.vertex_slots());
  std::iota(vertices.begin(), vertices.end(), 0U);
  return vertices;
}

TEST(VertexColouring, GivesTheCornersOfAFaceDifferentColours) {
  for (const test::ZooMesh& zoo : test::mesh_zoo()) {
    SCOPED_TRACE(zoo.name);
    VertexColouring colouring(zoo.mesh);
    colouring.extend(all_vertices(zoo.mesh));
    for (const FaceId f : zoo.mesh.faces())
      for (int i = 0; i < zoo.mesh.corner_count(f); ++i)
        for (int j = 0; j < i; ++j)
          EXPECT_NE(colouring.colour(zoo.mesh.corner(f, i)), colouring.colour(zoo.mesh.corner(f, j)));
  }
}

TEST(VertexColouring, SortsVerticesIntoClassesInOrder) {
  const Mesh mesh = test::triangle_lattice(10, 10);
  VertexColouring colouring(mesh);
  const auto vertices = all_vertices(mesh);
  colouring.extend(vertices);
  std::size_t count = 0;
  for (const auto& members : colouring.classes(vertices)) {
    EXPECT_TRUE(std::is_sorted(members.begin(), members.end()));
    count += members.size();
  }
  EXPECT_EQ(count, vertices.size());
}

TEST(VertexColouring, IsTheSameOnAnyNumberOfThreads) {
  const Mesh mesh = test::triangle_lattice(120, 120);
  const auto colours = [&] {
    VertexColouring colouring(mesh);
    colouring.extend(all_vertices(mesh));
    std::vector<int> result;
    for (const VertexId v : mesh.vertices()) result.push_back(colouring.colour(v));
    return result;
  };
  std::vector<int> serial;
  parallel::with_threads(1, [&] { serial = colours(); });
  for (const int threads : {2, 4, 7}) {
    const parallel::ParticipationProbe probe;
    parallel::with_threads(threads, [&] { EXPECT_EQ(colours(), serial) << threads << " threads"; });
    EXPECT_GT(probe.chunks_of_other_threads(), 0U) << threads << " threads";
  }
}

}  // namespace
}  // namespace quarry
