// Scans and a thrust fault as published by others, which are not part of this project: skipped where absent.
#include <filesystem>

#include <gtest/gtest.h>

#include "tests/surface/project/surface_samples.hpp"

namespace quarry {
namespace {

using namespace test;

class RealSurfaces : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    const std::string path = kSurfaceFolder + GetParam();
    if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is absent";
    surface_ = read_surface(path);
  }
  Surface surface_;
};

TEST_P(RealSurfaces, GiveWhatLookingAtEveryTriangleGives) {
  const TriangleTree tree(surface_.points, surface_.triangles);
  for (const Vec3 p : queries(surface_, kSeed, 140))
    ASSERT_TRUE(same(tree.closest(p), look_at_all(surface_, p).best)) << p.x << " " << p.y << " " << p.z;
}

INSTANTIATE_TEST_SUITE_P(OfEverySort, RealSurfaces,
                         testing::Values("koala_low.obj", "hammer_scan.obj", "mountain_terrain.obj",
                                         "plane_holes.obj", "fault_oak_ridge_500m.obj",
                                         "fault_ridgecrest_native.obj"));

class RealClosedSurfaces : public RealSurfaces {};

TEST_P(RealClosedSurfaces, LetNoRayThroughTheirCorners) {
  const TriangleTree tree(surface_.points, surface_.triangles);
  Draws draws(kSeed);
  const Box3 box = surface_.box();
  int inside = 0;
  for (int i = 0; i < 20'000 && inside < 10; ++i) {
    const Vec3 p{draws.uniform(box.low.x, box.high.x), draws.uniform(box.low.y, box.high.y),
                 draws.uniform(box.low.z, box.high.z)};
    const bool enclosed = tree.encloses(p);
    inside += enclosed ? 1 : 0;
    for (std::size_t v = static_cast<std::size_t>(i) % 37; v < surface_.points.size(); v += 37) {
      const Vec3 direction = surface_.points[v] - p;
      const CrossingCounts counts = tree.crossings(p, direction);
      ASSERT_EQ((counts.from_front + counts.from_back) % 2, enclosed ? 1U : 0U);
      if (enclosed) {
        ASSERT_TRUE(tree.ray(p, direction).triangle.valid());
      }
    }
  }
  EXPECT_EQ(inside, 10);
}

INSTANTIATE_TEST_SUITE_P(Scans, RealClosedSurfaces,
                         testing::Values("koala_low.obj", "hammer_scan.obj", "skull_low.obj"));

}  // namespace
}  // namespace quarry
