#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "engine/mesh/build.hpp"
#include "io/picture/camera.hpp"
#include "io/picture/colour.hpp"
#include "io/picture/paint_order.hpp"
#include "io/picture/picture.hpp"
#include "tests/io/mesh/temporary_folder.hpp"
#include "tests/io/picture/pixels.hpp"

namespace quarry {
namespace {

// Two level squares, the second half as wide and one above the first; the regions 0 and 1. The lower one has
// a feature from left to right through its middle.
Mesh two_levels() {
  const std::vector<double> x = {0, 4, 4, 0, 0, 4, 1, 3, 3, 1}, y = {0, 0, 2, 2, 4, 4, 1, 1, 3, 3},
                            z = {0, 0, 0, 0, 0, 0, 1, 1, 1, 1};
  std::vector<FaceCorners> faces;
  for (const auto& corners : {std::array{0, 1, 2, 3}, std::array{3, 2, 5, 4}, std::array{6, 7, 8, 9}}) {
    FaceCorners face;
    for (std::size_t k = 0; k < 4; ++k) face[k] = VertexId(static_cast<std::uint32_t>(corners[k]));
    faces.push_back(face);
  }
  Mesh mesh = build_mesh(x, y, z, faces);
  auto region = mesh.add_tag<FaceId, std::int32_t>("region", 0);
  region[FaceId(std::size_t{2})] = 1;
  auto constraint = mesh.add_tag<EdgeId, std::int32_t>("constraint", -1);
  constraint[mesh.add_edge(VertexId(std::size_t{3}), VertexId(std::size_t{2}))] = 5;
  return mesh;
}

constexpr ViewDirection kFromAbove{.azimuth = -90, .elevation = 90};

class SpacePicture : public testing::Test {
 protected:
  [[nodiscard]] Pixels drawn(const PictureOptions& options, const Mesh& mesh = two_levels()) const {
    write_picture(folder_.file("picture.png"), mesh, options);
    return Pixels(folder_.file("picture.png"));
  }
  void expect_usage_error(const PictureOptions& options, const Mesh& mesh = two_levels()) const {
    try {
      write_picture(folder_.file("picture.png"), mesh, options);
      FAIL() << "no error";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kUsage) << error.message();
    }
    EXPECT_EQ(folder_.entries(), 0);
  }
  TemporaryFolder folder_;
};

// The same hue, whatever the light.
double hue(Colour c) { return (c.red - c.blue) / (c.red + c.green + c.blue); }

TEST(Camera, LooksAlongTheGivenAngles) {
  const Vec3 right = Camera({.azimuth = -90, .elevation = 0}).seen({1, 0, 0});
  EXPECT_NEAR(right.x, 1, 1e-12);
  const Vec3 up = Camera({.azimuth = 20, .elevation = 0}).seen({0, 0, 1});
  EXPECT_NEAR(up.y, 1, 1e-12);
  const Vec3 towards = Camera({.azimuth = 0, .elevation = 0}).seen({1, 0, 0});
  EXPECT_NEAR(towards.z, 1, 1e-12);
  const Vec3 other_axis = Camera({.azimuth = 20, .elevation = 0, .up = UpAxis::kY}).seen({0, 1, 0});
  EXPECT_NEAR(other_axis.y, 1, 1e-12);
}

TEST(Camera, IsRightHanded) {
  for (const UpAxis up : {UpAxis::kY, UpAxis::kZ}) {
    const Camera camera({.azimuth = 31, .elevation = 17, .up = up});
    const Vec3 x = camera.seen({1, 0, 0}), y = camera.seen({0, 1, 0}), z = camera.seen({0, 0, 1});
    EXPECT_NEAR(dot(cross(x, y), z), 1, 1e-12);
  }
}

TEST_F(SpacePicture, HidesWhatLiesBehind) {
  const Pixels pixels = drawn({.view = kFromAbove});
  EXPECT_NEAR(hue(pixels.at_share(0.5, 0.4)), hue(region_colour(1)), 0.01);
  EXPECT_NEAR(hue(pixels.at_share(0.1, 0.3)), hue(region_colour(0)), 0.01);
}

TEST_F(SpacePicture, CutsFeaturesWhereTheyAreHidden) {
  PictureOptions options;
  options.view = kFromAbove;
  options.colours = PictureColours::kConstraint;
  const Pixels pixels = drawn(options);
  const int middle = 40 + 760;  // margin, and half of the drawing
  expect_colour(pixels.at(40 + 180, middle), line_colour(5));
  EXPECT_GT(lightness(pixels.at(40 + 600, middle)), 0.7);
}

TEST_F(SpacePicture, ShowsTheBackOfASurfaceGreyer) {
  const Colour front = drawn({.view = kFromAbove}).at_share(0.1, 0.3);
  const Colour back = drawn({.view = {.azimuth = -90, .elevation = -90}}).at_share(0.1, 0.3);
  EXPECT_LT(lightness(back), lightness(front) - 0.1);
}

TEST_F(SpacePicture, ShowsOnlyWhatLiesInABall) {
  const Pixels pixels = drawn({.view = kFromAbove, .around = Ball{{2, 2, 1}, 1.9}});
  EXPECT_NEAR(hue(pixels.at_share(0.1, 0.1)), hue(region_colour(1)), 0.01);
}

TEST_F(SpacePicture, LeavesHiddenFacesOutOfADrawing) {
  PictureOptions options;
  options.view = kFromAbove;
  Mesh mesh = two_levels();
  write_picture(folder_.file("all.svg"), mesh, options);
  // The upper square over all of the lower ones.
  for (std::size_t i = 6; i < 10; ++i) {
    const Vec3 p = mesh.point3(VertexId(i));
    mesh.set_point3(VertexId(i), {p.x < 2 ? -1.0 : 5.0, p.y < 2 ? -1.0 : 5.0, 1});
  }
  write_picture(folder_.file("one.svg"), mesh, options);
  EXPECT_LT(file_content(folder_.file("one.svg")).size(), file_content(folder_.file("all.svg")).size());
}

TEST_F(SpacePicture, PaintsWhatIsLeftOfFacesThatAreMostlyHidden) {
  // Of the lower squares a frame is left whose middle and corners do not show.
  Mesh mesh = two_levels();
  const std::array<Vec2, 4> corners = {Vec2{0.1, -1}, {3.9, -1}, {3.9, 5}, {0.1, 5}};
  for (std::size_t i = 0; i < 4; ++i) mesh.set_point3(VertexId(6 + i), {corners[i].x, corners[i].y, 1});
  const Pixels pixels = drawn({.view = kFromAbove}, mesh);
  EXPECT_NEAR(hue(pixels.at(40 + 19, 900)), hue(region_colour(0)), 0.01);
  EXPECT_NEAR(hue(pixels.at(40 + 760, 900)), hue(region_colour(1)), 0.01);
}

TEST_F(SpacePicture, PaintsTheNearerOfTwoFacesLastThoughItsMiddleIsFarther) {
  // A square that leans back far behind the other ones lies above them where they are.
  Mesh mesh = two_levels();
  for (std::size_t i = 6; i < 10; ++i) {
    const Vec3 p = mesh.point3(VertexId(i));
    mesh.set_point3(VertexId(i), {p.x, p.y < 2 ? 3.0 : 8.0, p.y < 2 ? 1.0 : -3.5});
  }
  const Pixels pixels = drawn({.view = kFromAbove}, mesh);
  EXPECT_NEAR(hue(pixels.at(800, 1350)), hue(region_colour(1)), 0.01);
}

TEST(PaintOrder, PutsWhatIsCoveredFirstAndElseGoesByDepth) {
  EXPECT_EQ(paint_order({3, 1, 2}, {}), (std::vector<std::uint32_t>{1, 2, 0}));
  EXPECT_EQ(paint_order({3, 1, 2}, {{0, 1}, {0, 1}}), (std::vector<std::uint32_t>{2, 0, 1}));
}

TEST(PaintOrder, EndsWhereShapesCoverOneAnotherInTurn) {
  EXPECT_EQ(paint_order({3, 1, 2, 0}, {{0, 1}, {1, 2}, {2, 0}, {2, 3}}),
            (std::vector<std::uint32_t>{3, 1, 2, 0}));
}

TEST_F(SpacePicture, HasTheSameBytesEachTime) {
  for (const char* name : {"picture.png", "picture.svg"}) {
    write_picture(folder_.file(name), two_levels(), {});
    const std::string first = file_content(folder_.file(name));
    write_picture(folder_.file(name), two_levels(), {});
    EXPECT_TRUE(file_content(folder_.file(name)) == first) << name;
  }
}

TEST_F(SpacePicture, RefusesWhatItCannotDraw) {
  expect_usage_error({.window = Box2{{0, 0}, {1, 1}}});
  expect_usage_error({.around = Ball{{0, 0, 0}, 0}});
  expect_usage_error({.around = Ball{{50, 0, 0}, 1}});
}

}  // namespace
}  // namespace quarry
