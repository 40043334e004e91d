#include "io/raster/point_values.hpp"

#include <string>

#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "tests/io/mesh/temporary_folder.hpp"

namespace quarry {
namespace {

std::string message_of(const std::string& text) {
  const TemporaryFolder folder;
  try {
    (void)read_point_values(folder.file("points.csv", text));
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInput);
    return error.message();
  }
  return "";
}

TEST(PointValues, AreReadWithHeadingsCommentsAndAnySeparator) {
  const TemporaryFolder folder;
  const std::string path =
      folder.file("points.csv", "x,y,size\n# wells\n1,2,0.5\n3;4;6 # last\n\n -5e1\t6 7\r\n");
  const std::vector<PointValue> points = read_point_values(path);
  ASSERT_EQ(points.size(), 3U);
  EXPECT_EQ(points[0].at, (Vec2{1, 2}));
  EXPECT_EQ(points[0].value, 0.5);
  EXPECT_EQ(points[1].at, (Vec2{3, 4}));
  EXPECT_EQ(points[2].at, (Vec2{-50, 6}));
  EXPECT_EQ(points[2].value, 7);
}

TEST(PointValues, AreRefusedWithTheLineThatIsWrong) {
  EXPECT_NE(message_of("x y s\n1 2 3\n1 2\n").find(":3:"), std::string::npos);
  EXPECT_NE(message_of("1 2 3\n1 2 three\n").find(":2:"), std::string::npos);
  EXPECT_NE(message_of("1 nan 3\n").find("finite"), std::string::npos);
  EXPECT_NE(message_of("1 2 inf\n").find("finite"), std::string::npos);
  EXPECT_NE(message_of("1 2 3 4\n").find("nothing more"), std::string::npos);
  EXPECT_NE(message_of("").find("no points"), std::string::npos);
  EXPECT_NE(message_of("x,y,size\n").find("no points"), std::string::npos);
}

}  // namespace
}  // namespace quarry
