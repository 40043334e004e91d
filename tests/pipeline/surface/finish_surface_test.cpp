#include "pipeline/surface/finish_surface.hpp"

#include <array>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/mesh/build.hpp"
#include "tests/support/modelled_surface.hpp"
#include "tests/support/surface_zoo.hpp"

namespace quarry {
namespace {

constexpr double kHalfThickness = 0.01;

test::ModelledSurface lens() {
  TriangleSurface surface = test::sphere(4);
  for (Vec3& p : surface.points) p.z *= kHalfThickness;
  return test::modelled(std::move(surface));
}

// One square about the middle of the lens that faces up or down.
Mesh square_at(double height, double half_edge, bool up) {
  const double h = half_edge;
  const std::array<FaceCorners, 1> faces = {
      up ? FaceCorners{VertexId(0U), VertexId(1U), VertexId(2U), VertexId(3U)}
         : FaceCorners{VertexId(0U), VertexId(3U), VertexId(2U), VertexId(1U)}};
  return build_mesh({-h, h, h, -h}, {-h, -h, h, h}, std::vector<double>(4, height), faces);
}

// The far side of the wall is nearer than half of the larger face is long.
TEST(InvalidOnSurface, AreFacesOnTheWrongSideOfAThinWallHoweverLarge) {
  const SurfaceModel model = lens().model;
  constexpr double kArea = 2 * std::numbers::pi;
  for (const double half_edge : {0.002, 0.3})
    for (const bool up : {true, false}) {
      EXPECT_TRUE(find_invalid_on_surface(square_at(up ? kHalfThickness : -kHalfThickness, half_edge, up),
                                          model, kArea)
                      .empty());
      EXPECT_EQ(find_invalid_on_surface(square_at(up ? -kHalfThickness : kHalfThickness, half_edge, up),
                                        model, kArea)
                    .size(),
                1U)
          << half_edge;
    }
}

}  // namespace
}  // namespace quarry
