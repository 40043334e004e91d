#include "kernels/initial/delaunay.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "engine/mesh/validate.hpp"
#include "kernels/quality/element.hpp"

namespace quarry {
namespace {

TEST(MakeDelaunay, KeepsTheHullAwayFromTheBoxAtAnyAngle) {
  const Box2 box{{465'000.25, 6'691'000.75}, {465'060.25, 6'691'020.25}};
  for (const double angle : {0.0, 7.0, -29.0, 30.0, 45.0, 100.0}) {
    SCOPED_TRACE(angle);
    const Mesh mesh = make_delaunay(box, {.spacing = 1, .angle_degrees = angle});
    EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
    for (const VertexId v : mesh.vertices())
      if (mesh.on_boundary(v)) {
        EXPECT_FALSE(box.grown(0.5).contains(mesh.point(v)));
      }
    EXPECT_LT(mesh.box().low.x, box.low.x - 0.5);
    EXPECT_GT(mesh.box().high.y, box.high.y + 0.5);
  }
}

TEST(MakeDelaunay, MakesNearlyEquilateralTrianglesInTheBox) {
  const Box2 box{{0, 0}, {100, 70}};
  const Mesh mesh = make_delaunay(box, {.spacing = 1, .seed = 5});
  for (const FaceId f : mesh.faces()) {
    const Vec2 a = mesh.point(mesh.corner(f, 0)), b = mesh.point(mesh.corner(f, 1)),
               c = mesh.point(mesh.corner(f, 2));
    if (!box.contains(a) || !box.contains(b) || !box.contains(c)) continue;
    EXPECT_GT(lo_measure(a, b, c), 0.6);
  }
}

TEST(MakeDelaunay, PutsRowsOnTheLowerAndTheUpperSideOfTheBox) {
  const Box2 box{{1, 2}, {11, 9}};
  const std::vector<Vec2> points = make_spaced_points(box, {.spacing = 0.7, .jitter = 0});
  const auto on = [&](double y) {
    return std::count_if(points.begin(), points.end(), [&](Vec2 p) { return std::abs(p.y - y) < 1e-12; });
  };
  EXPECT_GT(on(box.low.y), 10);
  EXPECT_GT(on(box.high.y), 10);
}

TEST(MakeDelaunay, FollowsTheSeed) {
  const Box2 box{{0, 0}, {10, 10}};
  EXPECT_EQ(make_spaced_points(box, {.seed = 1}), make_spaced_points(box, {.seed = 1}));
  EXPECT_NE(make_spaced_points(box, {.seed = 1}), make_spaced_points(box, {.seed = 2}));
}

TEST(MakeDelaunay, TellsHowManyTrianglesToExpect) {
  const Box2 box{{0, 0}, {100, 70}};
  const auto made = static_cast<double>(make_delaunay(box, {.spacing = 1}).face_slots());
  EXPECT_NEAR(count_delaunay_triangles(box, {.spacing = 1}), made, 0.05 * made);
}

TEST(MakeDelaunay, CoversABoxSmallerThanTheSpacing) {
  const Box2 box{{5, 5}, {5.1, 5.2}};
  const Mesh mesh = make_delaunay(box, {.spacing = 1});
  EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
}

}  // namespace
}  // namespace quarry
