// Points of the input (wells, sensors) in each format that has them.
#include <shapefil.h>

#include "io/lines/geojson_writer.hpp"
#include "tests/io/lines/line_files.hpp"

namespace quarry {
namespace {

class InputPoints : public LineFiles {
 protected:
  LineSet read(const std::string& text, const std::string& name) { return read_lines({save(text, name)}); }
  static Vec2 place(const LineSet& lines, std::size_t i) { return lines.points[PointId(i)].place; }
  static std::string name(const LineSet& lines, std::size_t i) {
    return lines.attributes_of(PointId(i)).name;
  }
};

TEST_F(InputPoints, OfGeojsonKeepTheirHeightFeatureAndName) {
  const LineSet lines = read(
      R"({"type":"FeatureCollection","features":[
      {"type":"Feature","properties":{},"geometry":{"type":"LineString","coordinates":[[0,0],[1,1]]}},
      {"type":"Feature","properties":{"name":"W"},"geometry":{"type":"Point","coordinates":[1,2,-30]}},
      {"type":"Feature","properties":{},"geometry":{"type":"MultiPoint","coordinates":[[3,4],[5,6]]}},
      {"type":"Feature","properties":{},"geometry":{"type":"MultiPoint","coordinates":[]}}]})",
      "a.geojson");
  ASSERT_EQ(lines.points.size(), 3U);
  EXPECT_EQ(lines.lines.size(), 1U);
  EXPECT_EQ(place(lines, 0), (Vec2{1, 2}));
  EXPECT_EQ(lines.points[PointId(0U)].height, -30);
  EXPECT_FALSE(lines.points[PointId(1U)].height.has_value());
  EXPECT_EQ(place(lines, 2), (Vec2{5, 6}));
  EXPECT_EQ(lines.points[PointId(2U)].feature, 2U);
  EXPECT_EQ(name(lines, 0), "W");
  EXPECT_EQ(name(lines, 1), "");
  EXPECT_TRUE(lines.attributes_of(LineId(0U)).empty());
}

TEST_F(InputPoints, NestedTooDeepAreAnError) {
  EXPECT_MESSAGE(error_of(R"({"type":"MultiPoint","coordinates":[[[3,4]]]})", "a.geojson"),
                 "nested too deep");
  EXPECT_MESSAGE(error_of(R"({"type":"Point","coordinates":[3]})", "a.geojson"), "a position needs two");
}

TEST_F(InputPoints, OfWellKnownTextAreReadWithAndWithoutBrackets) {
  const LineSet lines = read("POINT (1 2)\nMULTIPOINT (3 4, (5 6))\nPOINT Z (7 8 9)\nPOINT EMPTY\n", "a.wkt");
  ASSERT_EQ(lines.points.size(), 4U);
  EXPECT_EQ(place(lines, 0), (Vec2{1, 2}));
  EXPECT_EQ(place(lines, 2), (Vec2{5, 6}));
  EXPECT_EQ(lines.points[PointId(3U)].height, 9);
}

TEST_F(InputPoints, OfTablesStandInRowsWithTheNameOfAWell) {
  const LineSet lines = read("Well,x,y,z,set\nA-1,10,20,,observed\nA-2,30,40,5,\n", "wells.csv");
  ASSERT_EQ(lines.points.size(), 2U);
  EXPECT_TRUE(lines.lines.empty());
  EXPECT_EQ(place(lines, 1), (Vec2{30, 40}));
  EXPECT_EQ(name(lines, 0), "A-1");
  EXPECT_EQ(lines.attributes_of(PointId(0U)).set, "observed");
  EXPECT_EQ(lines.points[PointId(1U)].height, 5);
}

TEST_F(InputPoints, OfPolyFilesAreVerticesOfNoSegment) {
  const LineSet lines = read("4 2 0 0\n1 0 0\n2 5 5\n3 9 1\n4 2 8\n1 0\n1 1 2\n0\n", "a.poly");
  ASSERT_EQ(lines.points.size(), 2U);
  EXPECT_EQ(place(lines, 0), (Vec2{9, 1}));
  EXPECT_EQ(place(lines, 1), (Vec2{2, 8}));
  const std::string path = (folder_ / "a.poly").string();
  EXPECT_EQ(read_lines({path, path}).points[PointId(3U)].feature, 2U) << "counted anew in each file";
}

TEST_F(InputPoints, OfShapefilesAreRead) {
  const std::string path = (folder_ / "map").string();
  const SHPHandle file = SHPCreate(path.c_str(), SHPT_MULTIPOINTZ);
  const double x[] = {1, 2}, y[] = {3, 4}, z[] = {5, -1e39};
  SHPObject* object = SHPCreateObject(SHPT_MULTIPOINTZ, -1, 0, nullptr, nullptr, 2, x, y, z, nullptr);
  SHPWriteObject(file, -1, object);
  SHPDestroyObject(object);
  SHPClose(file);
  const LineSet lines = read_lines({path + ".shp"});
  ASSERT_EQ(lines.points.size(), 2U);
  EXPECT_EQ(place(lines, 1), (Vec2{2, 4}));
  EXPECT_EQ(lines.points[PointId(0U)].height, 5);
  EXPECT_FALSE(lines.points[PointId(1U)].height.has_value()) << "no data";
}

TEST_F(InputPoints, OfCleanedLinesComeBackAtTheirNodes) {
  LineSet input;
  input.attributes = {{"W", "", "", {}}};
  for (int i = 0; i < 3; ++i) input.points.push_back({});
  input.points[PointId(2U)].attributes = 0;
  NodedLines lines;
  for (const Vec2 p : {Vec2{0, 0}, Vec2{1, 0}, Vec2{0.1, 7}}) lines.nodes.push_back(p);
  lines.pieces.push_back({NodeId(0U), NodeId(1U)});
  lines.line_begin = {0, 0};
  GeojsonWriteOptions options{&input, "", {}};
  for (const NodeId node : {NodeId(2U), NodeId(), NodeId(2U)}) options.points.push_back(node);
  const std::string path = (folder_ / "out.geojson").string();
  write_lines_geojson(path, lines, options);
  const LineSet read = read_lines({path});
  ASSERT_EQ(read.points.size(), 1U);
  EXPECT_EQ(place(read, 0), (Vec2{0.1, 7}));
  EXPECT_EQ(name(read, 0), "W");
  EXPECT_EQ(read.lines.size(), 1U);
}

}  // namespace
}  // namespace quarry
