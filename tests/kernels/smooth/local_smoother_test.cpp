#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "engine/base/random.hpp"
#include "engine/mesh/build.hpp"
#include "engine/mesh/validate.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/quality/face.hpp"
#include "kernels/smooth/local_smoother_code.hpp"

namespace quarry {
namespace {

struct Block {
  std::uint32_t columns = 8, rows = 8;
  double width = 1, height = 1;  // of a cell
  Vec2 origin{466000, 6691000};
  double triangle_share = 0;
};

VertexId at(const Block& block, std::uint32_t i, std::uint32_t j) {
  return VertexId(j * (block.columns + 1) + i);
}

std::vector<VertexId> inner_vertices(const Block& block) {
  std::vector<VertexId> inner;
  for (std::uint32_t j = 1; j < block.rows; ++j)
    for (std::uint32_t i = 1; i < block.columns; ++i) inner.push_back(at(block, i, j));
  return inner;
}

std::vector<FaceCorners> block_faces(const Block& block) {
  std::vector<FaceCorners> faces;
  for (std::uint32_t j = 0; j < block.rows; ++j)
    for (std::uint32_t i = 0; i < block.columns; ++i) {
      const FaceCorners quad = {at(block, i, j), at(block, i + 1, j), at(block, i + 1, j + 1),
                                at(block, i, j + 1)};
      if (uniform01(7, faces.size()) >= block.triangle_share) {
        faces.push_back(quad);
      } else {
        faces.push_back({quad[0], quad[1], quad[2], VertexId()});
        faces.push_back({quad[0], quad[2], quad[3], VertexId()});
      }
    }
  return faces;
}

// Inner vertices are moved by up to `shake` cells along each axis.
Mesh shaken_block(const Block& block, double shake, std::uint64_t seed) {
  std::vector<double> x, y;
  for (std::uint32_t j = 0; j <= block.rows; ++j)
    for (std::uint32_t i = 0; i <= block.columns; ++i) {
      const bool inner = i > 0 && j > 0 && i < block.columns && j < block.rows;
      const auto draw = [&] { return inner ? shake * (2 * uniform01(seed, x.size() + y.size()) - 1) : 0.0; };
      x.push_back(block.origin.x + block.width * (i + draw()));
      y.push_back(block.origin.y + block.height * (j + draw()));
    }
  return build_mesh(std::move(x), std::move(y), block_faces(block));
}

double smooth(Mesh& mesh, const std::vector<VertexId>& movable, const LocalShapeOptions& options = {}) {
  const PlaneModel plane;
  LocalSmoother<PlaneModel> smoother(plane);
  MeshEditor editor(mesh);
  return smoother.run(editor, movable, options);
}

double smallest_scaled_jacobian(const Mesh& mesh) {
  double smallest = 1;
  for (const FaceId f : mesh.faces()) smallest = std::min(smallest, scaled_jacobian(mesh, f));
  return smallest;
}

TEST(LocalSmoother, UntanglesNearlyAllPatchesShakenAtRandom) {
  int untangled = 0;
  std::vector<std::uint64_t> failed;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const Block block{.columns = 4 + static_cast<std::uint32_t>(seed % 9),
                      .rows = 4 + static_cast<std::uint32_t>(seed % 7)};
    Mesh mesh = shaken_block(block, 1.5, seed);
    const double smallest = smooth(mesh, inner_vertices(block));
    const bool valid = validate(mesh, GeometryCheck::kPlanarCorners).empty();
    EXPECT_EQ(smallest > 0, valid) << "seed " << seed;
    untangled += valid ? 1 : 0;
    if (!valid) failed.push_back(seed);
  }
  RecordProperty("untangled", untangled);
  EXPECT_GE(untangled, 195) << "failed with seeds " << testing::PrintToString(failed);
}

TEST(LocalSmoother, ReturnsTheSmallestScaledJacobianOfTheFacesAroundTheVertices) {
  const Block block;
  Mesh mesh = shaken_block(block, 0.3, 3);
  const double smallest = smooth(mesh, inner_vertices(block));
  EXPECT_DOUBLE_EQ(smallest, smallest_scaled_jacobian(mesh));
}

TEST(LocalSmoother, KeepsValidPatchesValidAndLiftsTheirMean) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Block block{.triangle_share = seed % 3 == 0 ? 0.3 : 0.0};
    Mesh mesh = shaken_block(block, 0.35, seed);
    if (!validate(mesh, GeometryCheck::kPlanarCorners).empty()) continue;
    const double before = smallest_scaled_jacobian(mesh);
    smooth(mesh, inner_vertices(block));
    EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
    EXPECT_GT(smallest_scaled_jacobian(mesh), before);
  }
}

TEST(LocalSmoother, KeepsRightAnglesInABlockThatIsThreeTimesAsWideAsHigh) {
  const Block block{.width = 3};
  Mesh mesh = shaken_block(block, 0.2, 5);
  EXPECT_GT(smooth(mesh, inner_vertices(block), {.sweeps = 100}), 0.999);
}

TEST(LocalSmoother, MovesOnlyTheVerticesThatItIsGiven) {
  const Block block;
  Mesh mesh = shaken_block(block, 0.3, 9);
  const Mesh& before_mesh = mesh;
  const std::vector<double> x = before_mesh.xs(), y = before_mesh.ys();
  const std::vector<VertexId> movable = {at(block, 3, 3), at(block, 4, 3), at(block, 4, 4)};
  smooth(mesh, movable);
  for (const VertexId v : mesh.vertices()) {
    const bool moved = !(mesh.point(v) == Vec2{x[v.value()], y[v.value()]});
    EXPECT_EQ(moved, std::find(movable.begin(), movable.end(), v) != movable.end());
  }
}

TEST(LocalSmoother, TellsWhenNoPlaceMakesTheFacesValid) {
  // A rim corner of 270 degrees with one quad: nothing inside can help.
  const Block block{.columns = 2, .rows = 2, .origin = {0, 0}};
  Mesh mesh = shaken_block(block, 0, 1);
  mesh.set_point(at(block, 0, 0), {0.9, 0.9});
  mesh.set_point(at(block, 1, 0), {1.2, -0.5});
  mesh.set_point(at(block, 0, 1), {-0.5, 1.2});
  EXPECT_LE(smooth(mesh, inner_vertices(block)), 0);
}

TEST(LocalSmoother, GivesTheSameBitsOnAnyNumberOfThreads) {
  const Block block{.columns = 70, .rows = 60};
  ASSERT_GE(inner_vertices(block).size(), LocalSmoother<PlaneModel>::kParallel);
  std::vector<double> x, y;
  for (const int threads : {1, 2, 4, 7}) {
    parallel::with_threads(threads, [&] {
      Mesh mesh = shaken_block(block, 0.8, 11);
      const parallel::ParticipationProbe probe;
      EXPECT_GT(smooth(mesh, inner_vertices(block)), 0);
      if (threads == 1) {
        x = mesh.xs();
        y = mesh.ys();
        return;
      }
      EXPECT_GT(probe.chunks_of_other_threads(), 0U);
      EXPECT_EQ(mesh.xs(), x);
      EXPECT_EQ(mesh.ys(), y);
    });
  }
}

TEST(LocalSmoother, ForgetsWhatItDidBefore) {
  const Block block;
  Mesh first = shaken_block(block, 0.9, 4);
  Mesh second = shaken_block(block, 0.9, 4);
  smooth(first, inner_vertices(block));
  const PlaneModel plane;
  LocalSmoother<PlaneModel> smoother(plane);
  const Block other{.columns = 20, .rows = 30};
  Mesh large = shaken_block(other, 0.9, 8);
  MeshEditor large_editor(large);
  smoother.run(large_editor, inner_vertices(other), {});
  MeshEditor editor(second);
  smoother.run(editor, inner_vertices(block), {});
  EXPECT_EQ(first.xs(), second.xs());
  EXPECT_EQ(first.ys(), second.ys());
}

// The sphere around the origin.
class SphereModel : public SpaceModel {
 public:
  explicit SphereModel(double radius) : radius_(radius) {}

  [[nodiscard]] SpacePoint project(const SpacePoint& p) const override {
    const Vec3 up = (1 / length(p.place)) * p.place;
    return {radius_ * up, up};
  }

 private:
  double radius_;
};

// A block bent over a sphere: a sixth of it, with shaken vertices.
Mesh shaken_cap(const Block& block, const SphereModel& sphere, double shake, std::uint64_t seed) {
  const Mesh flat = shaken_block(block, shake, seed);
  std::vector<double> x, y, z;
  for (const VertexId v : flat.vertices()) {
    const Vec2 p = flat.point(v);
    const Vec3 q = sphere.project({{2 * p.x / block.columns - 1, 2 * p.y / block.rows - 1, 1}, {}}).place;
    x.push_back(q.x);
    y.push_back(q.y);
    z.push_back(q.z);
  }
  Mesh mesh = build_mesh(std::move(x), std::move(y), std::move(z), block_faces(block));
  auto normals = mesh.add_normals();
  for (const VertexId v : mesh.vertices()) normals[v] = sphere.project({mesh.point3(v), {}}).up;
  return mesh;
}

TEST(LocalSmoother, UntanglesPatchesOfASphereAndKeepsTheirVerticesOnIt) {
  const SphereModel sphere(10);
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Block block{.columns = 12, .rows = 10, .origin = {0, 0}};
    Mesh mesh = shaken_cap(block, sphere, 1.2, seed);
    LocalSmoother<SpaceModel> smoother(sphere);
    MeshEditor editor(mesh);
    EXPECT_GT(smoother.run(editor, inner_vertices(block), {.sweeps = 20}), 0.4);
    for (const VertexId v : mesh.vertices()) EXPECT_NEAR(length(mesh.point3(v)), 10, 1e-12);
  }
}

}  // namespace
}  // namespace quarry
