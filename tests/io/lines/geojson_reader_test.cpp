#include "tests/io/lines/line_files.hpp"

namespace quarry {
namespace {

class GeojsonReader : public LineFiles {
 protected:
  std::string save(const std::string& text, const std::string& name = "in.geojson") {
    return LineFiles::save(text, name);
  }
  LineSet read(const std::string& text) { return read_lines({save(text)}); }
  std::string error_of(const std::string& text) { return error_of_path(save(text)); }
  static std::string feature(const std::string& geometry) {
    return R"({"type":"Feature","properties":{"a":[1,{"b":null}]},"geometry":)" + geometry + "}";
  }
  static std::string collection(const std::string& features) {
    return R"({"type":"FeatureCollection","features":[)" + features + "]}";
  }
};

TEST_F(GeojsonReader, ReadsABareLineStringAndIgnoresHeights) {
  const LineSet lines = read(R"({"type":"LineString","coordinates":[[1,2,99],[3.5,-4e1,98]]})");
  ASSERT_EQ(lines.lines.size(), 1U);
  EXPECT_EQ(lines.lines[LineId(0U)].points, (std::vector<Vec2>{{1, 2}, {3.5, -40}}));
}

TEST_F(GeojsonReader, TakesKeysInAnyOrder) {
  const LineSet lines = read(
      R"({"features":[{"geometry":{"coordinates":[[[0,0],[1,0]],[[2,0],[3,0]]],"type":"MultiLineString"},"type":"Feature"}],"type":"FeatureCollection"})");
  ASSERT_EQ(lines.lines.size(), 2U);
  EXPECT_EQ(lines.lines[LineId(1U)].points[1], (Vec2{3, 0}));
}

TEST_F(GeojsonReader, NumbersPartsAndRingsInReadingOrderAcrossFiles) {
  const std::string first = save(
      collection(feature(R"({"type":"MultiLineString","coordinates":[[[0,0],[1,0]],[],[[2,0],[3,0]]]})") +
                 "," + feature("null") + "," + feature(R"({"type":"Point","coordinates":[1,1]})")),
      "a.geojson");
  const std::string second = save(
      feature(
          R"({"type":"MultiPolygon","coordinates":[[[[0,0],[9,0],[9,9],[0,0]],[[1,1],[2,1],[2,2],[1,1]]],[[[20,0],[29,0],[29,9],[20,0]]]]})"),
      "b.JSON");
  const LineSet lines = read_lines({first, second});
  ASSERT_EQ(lines.lines.size(), 6U);
  EXPECT_TRUE(lines.lines[LineId(1U)].points.empty());
  const bool holes[] = {false, false, false, false, true, false};
  for (std::uint32_t i = 0; i < 6; ++i) {
    EXPECT_EQ(lines.lines[LineId(i)].hole, holes[i]) << i;
    EXPECT_EQ(lines.lines[LineId(i)].polygon_ring, i >= 3) << i;
    EXPECT_EQ(lines.lines[LineId(i)].file, i >= 3 ? 1U : 0U) << i;
  }
}

TEST_F(GeojsonReader, ReadsNestedGeometryCollections) {
  const LineSet lines = read(collection(feature(
      R"({"type":"GeometryCollection","geometries":[{"type":"GeometryCollection","geometries":[{"type":"LineString","coordinates":[[0,0],[1,1]]}]},{"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1]]]}]})")));
  ASSERT_EQ(lines.lines.size(), 2U);
  EXPECT_TRUE(lines.lines[LineId(1U)].closed());
}

TEST_F(GeojsonReader, PassesOverGeometriesInProperties) {
  const LineSet lines = read(
      R"({"type":"Feature","properties":{"geometry":{"type":"LineString","coordinates":[[5,5],["x"]]}},"geometry":{"type":"LineString","coordinates":[[0,0],[1,1]]}})");
  EXPECT_EQ(lines.lines.size(), 1U);
}

TEST_F(GeojsonReader, RemembersTheFeatureOfALine) {
  const LineSet lines = read(
      collection(feature("null") + "," + feature(R"({"type":"LineString","coordinates":[[0,0],[1,1]]})")));
  EXPECT_EQ(lines.lines[LineId(0U)].feature, 1U);
}

TEST_F(GeojsonReader, TakesWhatTravelsFromPropertiesBeforeAndAfterTheGeometry) {
  const LineSet lines = read(collection(
      R"({"type":"Feature","geometry":{"type":"MultiLineString","coordinates":[[[0,0],[1,1]],[[2,0],[3,1]]]},"properties":{"NAME":"A","set":2,"aperture":"0.25","x":[{"name":"no"}],"material":null}},)"
      R"({"type":"Feature","properties":{"aperture":-1},"geometry":{"type":"LineString","coordinates":[[0,0],[1,1]]}})"));
  EXPECT_EQ(lines.attributes_of(LineId(0U)), (LineAttributes{"A", "2", "", 0.25}));
  EXPECT_EQ(lines.attributes_of(LineId(1U)), (LineAttributes{"A", "2", "", 0.25}));
  EXPECT_TRUE(lines.attributes_of(LineId(2U)).empty());
}

TEST_F(GeojsonReader, KeepsTheCoordinateSystemAndKnowsDegrees) {
  const auto system = [&](const std::string& name) {
    return read(R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":")" + name +
                R"("}},"features":[)" + feature(R"({"type":"LineString","coordinates":[[0,0],[1,1]]})") +
                "]}")
        .systems.at(0);
  };
  EXPECT_EQ(system("urn:ogc:def:crs:EPSG::3067"), (CoordinateSystem{"urn:ogc:def:crs:EPSG::3067", false}));
  EXPECT_TRUE(system("urn:ogc:def:crs:OGC:1.3:CRS84").geographic);
  EXPECT_TRUE(system("EPSG:4258").geographic);
  EXPECT_FALSE(system("a grid of our own").geographic);
}

TEST_F(GeojsonReader, NamesAFileThatCannotBeRead) {
  EXPECT_MESSAGE(error_of_path((folder_ / "absent.geojson").string()), "No such file");
  std::filesystem::create_directory(folder_ / "folder.geojson");
  EXPECT_MESSAGE(error_of_path((folder_ / "folder.geojson").string()), "directory");
}

TEST_F(GeojsonReader, RefusesAnUnknownExtensionAndNamesTheKnownOnes) {
  EXPECT_MESSAGE(error_of_path(save("x", "in.unknown")), ".geojson");
}

TEST_F(GeojsonReader, RefusesEmptyFiles) {
  EXPECT_MESSAGE(error_of(""), "empty");
  EXPECT_MESSAGE(error_of(" \n\t"), "empty");
}

TEST_F(GeojsonReader, NamesTheByteOfBrokenJson) {
  EXPECT_MESSAGE(error_of(R"({"type":"LineString")"), "byte 21");
  EXPECT_MESSAGE(error_of("[1,2]"), "not GeoJSON");
  EXPECT_MESSAGE(error_of("\"text\""), "not GeoJSON");
  EXPECT_MESSAGE(error_of("{} {}"), "broken JSON");
}

TEST_F(GeojsonReader, RefusesInputWithoutLines) {
  EXPECT_MESSAGE(error_of(collection("")), "no lines");
  EXPECT_MESSAGE(error_of(collection(feature("null"))), "no lines");
}

TEST_F(GeojsonReader, NamesFeatureAndPositionOfABadCoordinate) {
  const auto line = [](const std::string& position) {
    return collection(feature("null") + "," +
                      feature(R"({"type":"LineString","coordinates":[[7,8],)" + position + ",[1,1]]}"));
  };
  for (const char* bad : {"[null,1]", "[\"2\",1]", "[true,1]", "[1e999,1]", "[1e200,1]", "[NaN,1]",
                          "[-Infinity,1]", "[1]", "[]", "[{},1]", "[3,[1,2]]", "5"}) {
    const std::string message = error_of(line(bad));
    EXPECT_MESSAGE(message, "feature 1") << bad;
    const std::string place = std::string(bad) == "5" ? "position 2" : "(7, 8)";
    EXPECT_MESSAGE(message, place) << bad;
  }
}

TEST_F(GeojsonReader, RefusesALineOfOnePoint) {
  EXPECT_MESSAGE(error_of(feature(R"({"type":"LineString","coordinates":[[7,8]]})")), "one point at (7, 8)");
}

TEST_F(GeojsonReader, RefusesMissingOrWronglyNestedCoordinates) {
  EXPECT_MESSAGE(error_of(feature(R"({"type":"LineString"})")), "without coordinates");
  EXPECT_MESSAGE(error_of(feature(R"({"type":"LineString","coordinates":null})")), "without coordinates");
  EXPECT_MESSAGE(error_of(feature(R"({"type":"LineString","coordinates":[1,2]})")), "single position");
  EXPECT_MESSAGE(error_of(feature(R"({"type":"LineString","coordinates":[[[0,0],[1,1]]]})")), "nested");
  EXPECT_MESSAGE(error_of(feature(R"({"type":"Polygon","coordinates":[[0,0],[1,1]]})")), "nested");
}

TEST_F(GeojsonReader, SurvivesEveryTruncationAndEveryFlippedByte) {
  const std::string whole =
      collection(feature(R"({"type":"Polygon","coordinates":[[[0,0],[9,0],[9,9],[0,0]]]})"));
  for (std::size_t i = 0; i < whole.size(); ++i) {
    EXPECT_FALSE(error_of(whole.substr(0, i)).empty());
    for (const char byte : {'[', ']', '{', '}', '"', ',', '9', '-', '\0', '\xff'}) {
      std::string changed = whole;
      changed[i] = byte;
      try {
        (void)read(changed);
      } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::kInput);
      }
    }
  }
}

}  // namespace
}  // namespace quarry
