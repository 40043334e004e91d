#include "pipeline/improve/input_size.hpp"

#include <gtest/gtest.h>

#include "engine/mesh/build.hpp"

namespace quarry {
namespace {

// Columns of unit squares up to x = 32, and of squares of half that from there to x = 48.
Mesh two_sizes() {
  std::vector<double> x, y;
  std::vector<FaceCorners> faces;
  const auto add = [&](double left, double low, double size) {
    const std::size_t first = x.size();
    for (const Vec2 p :
         {Vec2{left, low}, Vec2{left + size, low}, Vec2{left + size, low + size}, Vec2{left, low + size}}) {
      x.push_back(p.x);
      y.push_back(p.y);
    }
    faces.push_back({VertexId(first), VertexId(first + 1), VertexId(first + 2), VertexId(first + 3)});
  };
  for (int i = 0; i < 32; ++i)
    for (int j = 0; j < 32; ++j) add(i, j, 1);
  for (int i = 0; i < 32; ++i)
    for (int j = 0; j < 64; ++j) add(32 + 0.5 * i, 0.5 * j, 0.5);
  return build_mesh(std::move(x), std::move(y), faces);
}

TEST(InputSize, IsThatOfTheFacesNearby) {
  const InputSize size(two_sizes());
  EXPECT_NEAR(size.at({5, 17}), 1, 1e-9);
  EXPECT_NEAR(size.at({27, 3}), 1, 1e-9);
  EXPECT_NEAR(size.at({44, 29}), 0.5, 1e-9);
  EXPECT_NEAR(size.at({40, 2}), 0.5, 1e-9);
}

TEST(InputSize, OutsideIsThatOfTheNearestFaces) {
  const InputSize size(two_sizes());
  EXPECT_NEAR(size.at({-100, 10}), 1, 1e-9);
  EXPECT_NEAR(size.at({47, 300}), 0.5, 0.1);
}

TEST(InputSize, OfOneFaceIsItsOwn) {
  const InputSize size(
      build_mesh({0, 3, 3, 0}, {0, 0, 3, 3},
                 std::vector<FaceCorners>{{VertexId(0U), VertexId(1U), VertexId(2U), VertexId(3U)}}));
  EXPECT_NEAR(size.at({1, 1}), 3, 1e-12);
}

TEST(InputSize, CountsTwoTrianglesAsOneQuad) {
  const InputSize size(
      build_mesh({0, 3, 3, 0}, {0, 0, 3, 3},
                 std::vector<FaceCorners>{{VertexId(0U), VertexId(1U), VertexId(2U), VertexId()},
                                          {VertexId(0U), VertexId(2U), VertexId(3U), VertexId()}}));
  EXPECT_NEAR(size.at({1, 1}), 3, 1e-12);
}

}  // namespace
}  // namespace quarry
