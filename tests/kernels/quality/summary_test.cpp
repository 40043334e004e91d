#include "kernels/quality/summary.hpp"

#include <cstring>

#include <gtest/gtest.h>

#include "engine/parallel/parallel.hpp"
#include "kernels/quality/face.hpp"
#include "tests/io/mesh/sample_mesh.hpp"

namespace quarry {
namespace {

TEST(QualitySummary, OfAPlainGridIsPerfect) {
  const Mesh mesh = make_sample_mesh({.size = 8, .disorder = 0, .triangles = false});
  const QualitySummary summary = summarize_quality(mesh);
  EXPECT_EQ(summary.vertices, 81U);
  EXPECT_EQ(summary.quads.faces, 64U);
  EXPECT_EQ(summary.triangles.faces, 0U);
  EXPECT_DOUBLE_EQ(summary.area, 64.0);
  EXPECT_DOUBLE_EQ(summary.boundary_length, 32.0);
  EXPECT_DOUBLE_EQ(summary.quads.scaled_jacobian.min, 1.0);
  EXPECT_EQ(summary.quads.min_angle_histogram[8], 64U);
  EXPECT_EQ(summary.quads.lo_histogram[9], 64U);
  EXPECT_DOUBLE_EQ(summary.quads.aspect.max, 1.0);
  EXPECT_DOUBLE_EQ(summary.quads.shortest_edge, 1.0);
  EXPECT_EQ(summary.valence.interior, 49U);
  EXPECT_EQ(summary.valence.irregular, 0U);
  EXPECT_EQ(summary.valence.free, 42U);
  EXPECT_EQ(summary.valence.histogram.at(4), 49U);
}

TEST(QualitySummary, CountsFacesThatAreNotPositive) {
  // The inner corner of four unit squares is pulled beyond the corner of one of them.
  Mesh mesh = make_sample_mesh({.size = 2, .disorder = 0, .triangles = false});
  mesh.set_point(VertexId(std::size_t{4}), {2.5, 2.5});
  const QualitySummary summary = summarize_quality(mesh);
  EXPECT_GT(summary.all.scaled_jacobian_not_positive, 0U);
  EXPECT_LE(summary.all.scaled_jacobian.min, 0.0);
  EXPECT_DOUBLE_EQ(summary.area, 4.0);
}

TEST(QualitySummary, TakesTheOrientationOfMostOfTheArea) {
  const std::vector<FaceCorners> clockwise = {{VertexId(std::size_t{0}), VertexId(std::size_t{3}),
                                               VertexId(std::size_t{2}), VertexId(std::size_t{1})}};
  const QualitySummary summary = summarize_quality(build_mesh({0, 1, 1, 0}, {0, 0, 1, 1}, clockwise));
  EXPECT_DOUBLE_EQ(summary.area, 1.0);
  EXPECT_DOUBLE_EQ(summary.quads.scaled_jacobian.min, 1.0);
}

TEST(QualitySummary, LeavesOutOnePercentOfTheFacesAtEachEndOfTheSizes) {
  // A row of 101 rectangles of height 1 whose widths are 1 to 101.
  std::vector<double> x, y;
  std::vector<FaceCorners> faces;
  for (std::size_t i = 0; i <= 101; ++i) {
    const double at = 0.5 * static_cast<double>(i * (i + 1));
    x.insert(x.end(), {at, at});
    y.insert(y.end(), {0, 1});
    if (i > 0)
      faces.push_back({VertexId(2 * i - 2), VertexId(2 * i), VertexId(2 * i + 1), VertexId(2 * i - 1)});
  }
  const AreaPercentiles area = summarize_quality(build_mesh(x, y, faces)).face_area;
  EXPECT_DOUBLE_EQ(area.first, 2);
  EXPECT_DOUBLE_EQ(area.last, 100);
  EXPECT_DOUBLE_EQ(area.ratio(), 50);
}

TEST(QualitySummary, OfAnEmptyMeshIsZero) {
  const QualitySummary summary = summarize_quality(Mesh());
  EXPECT_EQ(summary.all.faces, 0U);
  EXPECT_DOUBLE_EQ(summary.all.scaled_jacobian.min, 0.0);
  EXPECT_DOUBLE_EQ(summary.valence.irregular_share(), 0.0);
}

TEST(QualitySummary, SkipsTombstones) {
  Mesh mesh = make_sample_mesh({.size = 4, .triangles = false});
  mesh.delete_face(FaceId(std::size_t{5}));
  EXPECT_EQ(summarize_quality(mesh).quads.faces, 15U);
  EXPECT_TRUE(std::isnan(scaled_jacobians(mesh)[5]));
}

// The bits that depend on an order of summing.
std::array<double, 7> sums(const QualitySummary& summary) {
  return {summary.area,
          summary.boundary_length,
          summary.all.scaled_jacobian.mean,
          summary.all.min_angle.mean,
          summary.all.lo_measure.mean,
          summary.all.aspect.mean,
          summary.valence.irregular_share()};
}

TEST(QualitySummary, HasTheSameBitsOnAnyNumberOfThreads) {
  const Mesh mesh = make_sample_mesh({.size = 200});
  std::array<double, 7> one{};
  parallel::with_threads(1, [&] { one = sums(summarize_quality(mesh)); });
  for (const int threads : {2, 4, 7}) {
    const parallel::ParticipationProbe probe;
    std::array<double, 7> many{};
    parallel::with_threads(threads, [&] { many = sums(summarize_quality(mesh)); });
    EXPECT_EQ(std::memcmp(one.data(), many.data(), sizeof one), 0) << threads << " threads";
    EXPECT_GT(probe.chunks_of_other_threads(), 0U) << threads << " threads";
  }
}

}  // namespace
}  // namespace quarry
