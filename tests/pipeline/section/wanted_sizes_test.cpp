// Sizes by place: what the user may say, and that the section job follows it.
#include "pipeline/section/wanted_sizes.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "engine/mesh/validate.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/quality/element.hpp"
#include "kernels/quality/face.hpp"
#include "pipeline/section/section.hpp"
#include "tests/io/mesh/temporary_folder.hpp"
#include "tests/pipeline/section/sample_lines.hpp"
#include "tests/support/mesh_arrays.hpp"

namespace quarry {
namespace {

class Sizes : public testing::Test {
 protected:
  // A square of side 100 with a line across, at a wanted size of 5.
  [[nodiscard]] SectionOptions options() const {
    SectionOptions options;
    options.inputs = {
        folder_.file("faults.geojson",
                     geojson_text({{{0, 0}, {100, 0}, {100, 100}, {0, 100}, {0, 0}}, {{20, 30}, {80, 40}}}))};
    options.size = 5;
    return options;
  }
  // Checks that all faces near p have about the size that is wanted there.
  static void expect_size_near(const Mesh& mesh, Vec2 p, double reach, double wanted) {
    double area = 0;
    int count = 0;
    for (const FaceId f : mesh.faces()) {
      Vec2 middle;
      for (int k = 0; k < mesh.corner_count(f); ++k) middle = middle + mesh.point(mesh.corner(f, k));
      middle = (1.0 / mesh.corner_count(f)) * middle;
      if (distance(middle, p) > reach) continue;
      area += measure_face(mesh, f, [](auto... corners) { return signed_area(corners...); });
      ++count;
    }
    ASSERT_GT(count, 0);
    const double size = std::sqrt(area / count);
    EXPECT_GT(size, wanted / 1.5);
    EXPECT_LT(size, wanted * 1.5);
  }
  void expect_error(const SizeOptions& sizes, ErrorKind kind, const std::string& word) const {
    SectionOptions section = options();
    section.sizes = sizes;
    try {
      (void)mesh_section(section, {});
      ADD_FAILURE() << "accepted";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), kind) << error.message();
      EXPECT_NE(error.message().find(word), std::string::npos) << error.message();
    }
  }
  TemporaryFolder folder_;
};

TEST_F(Sizes, FollowPointsOfAFile) {
  SectionOptions section = options();
  section.sizes.file = folder_.file("sizes.txt", "x y size\n20 80 0.5\n");
  const Mesh mesh = mesh_section(section, {}).mesh;
  EXPECT_EQ(validate(mesh, GeometryCheck::kPlanarCorners), "");
  expect_size_near(mesh, {20, 80}, 1, 0.65);
  expect_size_near(mesh, {80, 80}, 10, 5);
}

TEST_F(Sizes, FollowARaster) {
  SectionOptions section = options();
  section.sizes.file = folder_.file(
      "sizes.asc", "ncols 2\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 100\nNODATA_value -1\n1 -1\n");
  section.inputs = {
      folder_.file("wide.geojson",
                   geojson_text({{{0, 0}, {200, 0}, {200, 100}, {0, 100}, {0, 0}}, {{20, 30}, {180, 40}}}))};
  const Mesh mesh = mesh_section(section, {}).mesh;
  expect_size_near(mesh, {20, 60}, 15, 1);
  expect_size_near(mesh, {185, 60}, 14, 5);
}

TEST_F(Sizes, AreSmallNearTheLinesOfAGroup) {
  SectionOptions section = options();
  section.inputs.push_back(folder_.file("wells.geojson", geojson_text({{{70, 80}, {75, 85}}})));
  section.sizes.near = {"wells:0.5:4"};
  const Mesh mesh = mesh_section(section, {}).mesh;
  expect_size_near(mesh, {72, 84}, 2, 0.5);
  expect_size_near(mesh, {50, 35}, 5, 5);
}

TEST_F(Sizes, KnowFilesByTheNamesThatTheirGroupsHaveInTheMesh) {
  SectionOptions section = options();
  const TemporaryFolder other;
  section.inputs.push_back(other.file("faults.geojson", geojson_text({{{70, 80}, {75, 85}}})));
  section.sizes.near = {"faults_2:0.5:4"};
  const Mesh mesh = mesh_section(section, {}).mesh;
  expect_size_near(mesh, {72, 84}, 2, 0.5);
  expect_size_near(mesh, {50, 35}, 5, 5);
}

TEST_F(Sizes, FollowARasterWhoseNameIsInCapitals) {
  SectionOptions section = options();
  section.sizes.file =
      folder_.file("SIZES.ASC", "ncols 1\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 100\n2\n");
  expect_size_near(mesh_section(section, {}).mesh, {30, 70}, 15, 2);
}

TEST_F(Sizes, LetElementsFitBetweenLinesThatRunClose) {
  SectionOptions section = options();
  section.inputs = {folder_.file(
      "close.geojson",
      geojson_text(
          {{{0, 0}, {100, 0}, {100, 100}, {0, 100}, {0, 0}}, {{10, 50}, {60, 50}}, {{10, 52}, {60, 52}}}))};
  section.sizes.between = 2;
  const Mesh mesh = mesh_section(section, {}).mesh;
  expect_size_near(mesh, {35, 51}, 1.5, 1);
  expect_size_near(mesh, {85, 85}, 10, 5);
}

TEST_F(Sizes, MeetTheCountWhateverTheField) {
  for (const bool quads : {true, false}) {
    SectionOptions section = options();
    section.size.reset();
    section.count = 8000;
    section.elements = quads ? Elements::kQuad : Elements::kTriangle;
    section.sizes.near = {"lines:0.2:0"};
    const SectionResult result = mesh_section(section, {});
    EXPECT_NEAR(static_cast<double>(result.mesh.count_alive_faces()), 8000, 800) << quads;
  }
}

TEST_F(Sizes, GiveTheSameMeshOnAnyNumberOfThreads) {
  SectionOptions section = options();
  section.sizes.file = folder_.file("sizes.txt", "20 80 0.5\n60 60 1\n");
  section.sizes.between = 3;
  section.sizes.near = {"faults:1:2"};
  std::vector<std::uint64_t> serial;
  parallel::with_threads(1, [&] { serial = test::arrays_of(mesh_section(section, {}).mesh); });
  for (const int threads : {2, 4, 7})
    parallel::with_threads(threads, [&] {
      EXPECT_EQ(test::arrays_of(mesh_section(section, {}).mesh), serial) << threads << " threads";
    });
}

TEST_F(Sizes, ThatMakeNoSenseAreRefused) {
  expect_error({.near = {"faults:0:3"}}, ErrorKind::kUsage, "GROUP:SIZE:DISTANCE");
  expect_error({.near = {"faults"}}, ErrorKind::kUsage, "GROUP:SIZE:DISTANCE");
  expect_error({.near = {":1:1"}}, ErrorKind::kUsage, "GROUP:SIZE:DISTANCE");
  expect_error({.near = {"wells:1:3"}}, ErrorKind::kUsage, "wells");
  expect_error({.between = 0}, ErrorKind::kUsage, "--between-lines");
  expect_error({.between = 2, .gradation = 0}, ErrorKind::kUsage, "gradation");
  expect_error({.between = 2, .smallest = 6}, ErrorKind::kUsage, "--smallest");
  expect_error({.file = folder_.file("zero.txt", "1 2 0\n")}, ErrorKind::kInput, "zero.txt");
  expect_error({.file = folder_.file("empty.txt", "")}, ErrorKind::kInput, "no points");
  expect_error({.file = "nowhere.asc"}, ErrorKind::kInput, "nowhere.asc");
}

TEST_F(Sizes, BelowWhatCoordinatesTellApartAreRefusedWithTheLeastThatIsNot) {
  const std::string point = folder_.file("point.txt", "10,10,1e-300\n");
  expect_error({.file = point, .smallest = 1e-16}, ErrorKind::kUsage, "2.220446049250313e-11");
  SectionOptions section = options();
  section.sizes.file = point;  // the smallest wanted is a tenth of the largest
  EXPECT_EQ(validate(mesh_section(section, {}).mesh, GeometryCheck::kPlanarCorners), "");
}

TEST_F(Sizes, TooSmallForTheBudgetAreRefusedBeforeMeshing) {
  SectionOptions section = options();
  section.max_elements = 1e5;
  section.sizes = {.near = {"faults:1e-7:10"}, .smallest = 1e-7};
  section.snap = section.min_edge = section.tolerance = 0.01;
  try {
    (void)mesh_section(section, {});
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kBudget);
  }
}

}  // namespace
}  // namespace quarry
