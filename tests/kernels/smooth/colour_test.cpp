#include "engine/operation/colour.hpp"

#include <gtest/gtest.h>

#include "engine/parallel/parallel.hpp"
#include "tests/support/synthetic_mesh.hpp"

namespace quarry {
namespace {

std::vector<std::uint32_t> vertices_where(const Mesh& mesh, const auto& keep) {
  std::vector<std::uint32_t> list;
  for (const VertexId v : mesh.vertices())
    if (keep(v)) list.push_back(v.value());
  return list;
}

TEST(Colouring, GivesTheCornersOfEachFaceDifferentColoursAlsoWhenItGrows) {
  const test::SyntheticMesh made = test::make_synthetic({.columns = 40, .rows = 40});
  VertexColouring colouring(made.mesh);
  // Every third vertex first, then all: those coloured before keep their colours.
  colouring.extend(vertices_where(made.mesh, [](VertexId v) { return v.value() % 3 == 0; }));
  const int kept = colouring.colour(VertexId(300U));
  const auto all = vertices_where(made.mesh, [](VertexId) { return true; });
  colouring.extend(all);
  EXPECT_EQ(colouring.colour(VertexId(300U)), kept);
  for (const FaceId f : made.mesh.faces())
    for (int k = 0; k < 3; ++k)
      EXPECT_NE(colouring.colour(made.mesh.corner(f, k)), colouring.colour(made.mesh.corner(f, (k + 1) % 3)));
  std::size_t members = 0;
  for (const auto& one : colouring.classes(all)) members += one.size();
  EXPECT_EQ(members, all.size());
}

TEST(Colouring, IsTheSameOnAnyNumberOfThreads) {
  const test::SyntheticMesh made = test::make_synthetic({.columns = 90, .rows = 60});
  const auto all = vertices_where(made.mesh, [](VertexId) { return true; });
  std::vector<std::vector<std::uint32_t>> expected;
  for (const int threads : {1, 2, 4, 7}) {
    parallel::with_threads(threads, [&] {
      const parallel::ParticipationProbe probe;
      VertexColouring colouring(made.mesh);
      colouring.extend(all);
      if (threads == 1) {
        expected = colouring.classes(all);
        return;
      }
      EXPECT_GT(probe.chunks_of_other_threads(), 0U);
      EXPECT_EQ(colouring.classes(all), expected);
    });
  }
}

}  // namespace
}  // namespace quarry
