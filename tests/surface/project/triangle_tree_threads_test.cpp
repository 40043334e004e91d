#include <gtest/gtest.h>

#include "engine/parallel/parallel.hpp"
#include "surface/project/triangle_tree.hpp"
#include "tests/surface/project/surface_samples.hpp"

namespace quarry {
namespace {

using namespace test;

TEST(TriangleTreeThreads, BuildAndAnswerTheSameOnAnyNumberOfThreads) {
  const Surface surface = bumpy_sphere(60, 120, 0.1);
  const std::vector<Vec3> points = queries(surface, kSeed, 7000);
  std::vector<Vec3> normals(points.size());
  Draws draws(kSeed);
  for (Vec3& normal : normals) {
    const Vec3 v = draws.in_cube(1);
    normal = (1 / length(v)) * v;
  }
  const ClosestQuery cone{.least_cosine = 0.3};
  std::vector<SurfacePoint> plain, hinted;
  parallel::with_threads(1, [&] {
    const TriangleTree tree(surface.points, surface.triangles);
    plain = tree.closest_all(points);
    hinted = tree.closest_all(points, cone, normals);
    // In the order of the points, and what each alone gives.
    for (std::size_t i = 0; i < points.size(); ++i) {
      ASSERT_TRUE(same(plain[i], tree.closest(points[i]))) << "query " << i;
      ASSERT_TRUE(same(hinted[i], tree.closest(points[i], {.normal = normals[i], .least_cosine = 0.3})));
    }
  });
  for (const int threads : {2, 4, 7}) {
    parallel::with_threads(threads, [&] {
      const TriangleTree tree(surface.points, surface.triangles);
      const parallel::ParticipationProbe probe(200);
      const std::vector<SurfacePoint> again = tree.closest_all(points);
      const std::vector<SurfacePoint> hinted_again = tree.closest_all(points, cone, normals);
      EXPECT_GT(probe.chunks_of_other_threads(), 0U) << threads << " threads";
      for (std::size_t i = 0; i < points.size(); ++i) {
        ASSERT_TRUE(same(again[i], plain[i])) << "query " << i << ", " << threads << " threads";
        ASSERT_TRUE(same(hinted_again[i], hinted[i])) << "query " << i << ", " << threads << " threads";
      }
    });
  }
}

// Embree can be told a number of threads, which then binds the whole process.
TEST(TriangleTreeThreads, AreNotLimitedForOthersWhileATreeLives) {
  const Surface surface = bumpy_sphere(10, 20);
  TriangleTree* kept = nullptr;
  parallel::with_threads(1, [&] { kept = new TriangleTree(surface.points, surface.triangles); });
  const std::unique_ptr<TriangleTree> owner(kept);
  const parallel::ParticipationProbe probe(200);
  parallel::with_threads(4, [] { parallel::for_each(100'000, [](std::size_t) {}); });
  EXPECT_GT(probe.chunks_of_other_threads(), 0U);
}

}  // namespace
}  // namespace quarry
