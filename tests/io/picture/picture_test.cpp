#include "io/picture/picture.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "io/picture/colour.hpp"
#include "tests/io/mesh/sample_mesh.hpp"
#include "tests/io/mesh/temporary_folder.hpp"
#include "tests/io/picture/pixels.hpp"

namespace quarry {
namespace {

// Two by two squares; the regions 0 (left) and 1 (right).
Mesh four_squares() { return make_sample_mesh({.size = 2, .disorder = 0, .triangles = false}); }

class Picture : public testing::Test {
 protected:
  [[nodiscard]] Pixels drawn(const Mesh& mesh, const PictureOptions& options) const {
    write_picture(folder_.file("picture.png"), mesh, options);
    return Pixels(folder_.file("picture.png"));
  }
  void expect_error(const std::string& name, const Mesh& mesh, const PictureOptions& options,
                    ErrorKind kind) const {
    try {
      write_picture(folder_.file(name), mesh, options);
      FAIL() << "no error";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), kind) << error.message();
      EXPECT_NE(error.message().find(name), std::string::npos);
    }
    EXPECT_EQ(folder_.entries(), 0);
  }
  TemporaryFolder folder_;
};

TEST_F(Picture, HasTheWidthThatWasAskedFor) {
  const Pixels pixels = drawn(four_squares(), {.width = 500});
  EXPECT_EQ(pixels.width(), 500);
  EXPECT_GT(pixels.height(), 480);
}

TEST_F(Picture, FillsRegionsWithTheirColours) {
  const Pixels pixels = drawn(four_squares(), {});
  expect_colour(pixels.at_share(0.25, 0.25), region_colour(0));
  expect_colour(pixels.at_share(0.75, 0.25), region_colour(1));
  expect_colour(pixels.at(3, 3), {1, 1, 1});
}

TEST_F(Picture, DrawsConstraintsDarkOnTop) {
  const Pixels pixels = drawn(four_squares(), {});
  EXPECT_LT(lightness(pixels.at(pixels.width() / 2, 300)), 0.2);
}

TEST_F(Picture, ColoursFacesByQuality) {
  const std::vector<double> quality = {1.0, 0.25, -0.5, 0.9};
  const Pixels pixels = drawn(four_squares(), {.colours = PictureColours::kQuality, .quality = quality});
  expect_colour(pixels.at_share(0.75, 0.25), quality_colour(57.5 / 64));
  expect_colour(pixels.at_share(0.75, 0.75), quality_colour(16.5 / 64));
  expect_colour(pixels.at_share(0.25, 0.25), {0, 0, 0});
}

TEST_F(Picture, ColoursLinesByConstraint) {
  const Pixels pixels = drawn(four_squares(), {.colours = PictureColours::kConstraint});
  expect_colour(pixels.at(pixels.width() / 2, 300), line_colour(3));
}

TEST_F(Picture, OfAFineMeshIsNotBlack) {
  const Mesh mesh = make_sample_mesh({.size = 400});
  const Pixels pixels = drawn(mesh, {.width = 300});
  double sum = 0;
  for (int x = 60; x < 240; ++x) sum += lightness(pixels.at(x, 150));
  EXPECT_GT(sum / 180, 0.7);
}

TEST_F(Picture, ShowsAWindowAlone) {
  // Inside the lower left square.
  const Pixels pixels = drawn(four_squares(), {.window = Box2{{0.2, 0.2}, {0.8, 0.6}}});
  EXPECT_LT(pixels.height(), pixels.width());
  for (const double x : {0.1, 0.5, 0.9}) expect_colour(pixels.at_share(x, 0.4), region_colour(0));
}

TEST_F(Picture, SurvivesAnExtremeWindow) {
  const Pixels pixels = drawn(make_sample_mesh({.size = 50, .disorder = 0, .corner = {6.7e6, 0}}),
                              {.window = Box2{{6.7e6 + 3.4, 3.4}, {6.7e6 + 3.4001, 3.4001}}});
  expect_colour(pixels.at_share(0.5, 0.5), region_colour(0));
}

TEST_F(Picture, OfAnSvgIsVectors) {
  write_picture(folder_.file("picture.svg"), four_squares(), {.width = 800});
  const std::string text = file_content(folder_.file("picture.svg"));
  EXPECT_EQ(text.find("<?xml"), 0U);
  EXPECT_NE(text.find("width=\"800px\""), std::string::npos);
  EXPECT_EQ(text.find("<image"), std::string::npos);
}

TEST_F(Picture, HasTheSameBytesEachTime) {
  const Mesh mesh = make_sample_mesh({.size = 30});
  for (const char* name : {"picture.png", "picture.svg"}) {
    write_picture(folder_.file(name), mesh, {});
    const std::string first = file_content(folder_.file(name));
    write_picture(folder_.file(name), mesh, {});
    EXPECT_TRUE(file_content(folder_.file(name)) == first) << name;
  }
}

TEST_F(Picture, LeavesOutTombstones) {
  Mesh mesh = four_squares();
  const FaceId upper_left(std::size_t{2});
  for (int k = 0; k < 4; ++k) {
    const SideId across = mesh.neighbour(SideId(upper_left, k));
    if (across.valid()) mesh.set_neighbour(across, SideId());
  }
  mesh.delete_face(upper_left);
  rebuild_sides_of_vertices(mesh);
  const Pixels pixels = drawn(mesh, {});
  expect_colour(pixels.at_share(0.25, 0.25), {1, 1, 1});
  expect_colour(pixels.at_share(0.25, 0.75), region_colour(0));
}

TEST_F(Picture, RefusesWhatItCannotDraw) {
  const Mesh mesh = four_squares();
  expect_error("picture.gif", mesh, {}, ErrorKind::kUsage);
  expect_error("picture.png", mesh, {.width = 3}, ErrorKind::kUsage);
  expect_error("picture.png", Mesh(), {}, ErrorKind::kUsage);
  expect_error("picture.png", mesh, {.window = Box2{{1, 1}, {1, 2}}}, ErrorKind::kUsage);
  expect_error("absent/picture.png", mesh, {}, ErrorKind::kOutput);
}

}  // namespace
}  // namespace quarry
