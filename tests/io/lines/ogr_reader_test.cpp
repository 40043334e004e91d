// What GDAL's ogr2ogr reads; without it the error is tested alone.
#include "io/lines/ogr_reader.hpp"

#include <cmath>
#include <cstdlib>

#include "io/child_process.hpp"
#include "io/lines/ogr_layers.hpp"
#include "io/scratch_folder.hpp"
#include "tests/io/lines/line_files.hpp"

namespace quarry {
namespace {

bool is_there(const std::string& program) {
  const ScratchFolder folder;
  return run_program({{program, "--version"}, folder.file("out"), folder.file("err")}, Progress())
      .has_value();
}

class Ogr : public LineFiles {
 protected:
  void SetUp() override {
    LineFiles::SetUp();
    if (!is_there("ogr2ogr")) GTEST_SKIP() << "ogr2ogr (gdal-bin) is not installed";
  }
  // Runs ogr2ogr on a file of the folder, and gives the path of what it makes.
  std::string convert(const std::vector<std::string>& options, const std::string& from,
                      const std::string& to) {
    std::vector<std::string> words = {"ogr2ogr"};
    words.insert(words.end(), options.begin(), options.end());
    words.insert(words.end(), {(folder_ / to).string(), from});
    const ScratchFolder folder;
    EXPECT_EQ(run_program({words, folder.file("out"), folder.file("err")}, Progress()), 0);
    return (folder_ / to).string();
  }
};

const std::string kMap =
    R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::3067"}},"features":[)"
    R"({"type":"Feature","properties":{"name":"A","aperture":0.1},"geometry":{"type":"MultiLineString","coordinates":[[[466001.5290999999,6691582.2],[466047.2650000006,6691583.4]],[[466002.7,6691580],[466004,6691583]]]}},)"
    R"({"type":"Feature","properties":{"set":"frame"},"geometry":{"type":"Polygon","coordinates":[[[465990,6691570],[466010,6691570],[466010,6691590],[465990,6691570]]]}}]})";

TEST_F(Ogr, GeopackagesHaveTheSameLinesAsTheirSource) {
  const std::string source = save(kMap, "map.geojson");
  const LineSet expected = read_lines({source});
  const LineSet lines = read_lines({convert({"-f", "GPKG"}, source, "map.gpkg")});
  ASSERT_EQ(lines.lines.size(), expected.lines.size());
  for (const LineId id : IdRange<LineId>(lines.lines.size())) {
    EXPECT_EQ(lines.lines[id].points, expected.lines[id].points);
    EXPECT_EQ(lines.lines[id].polygon_ring, expected.lines[id].polygon_ring);
    EXPECT_EQ(lines.attributes_of(id), expected.attributes_of(id));
  }
  EXPECT_NE(lines.systems[0].definition.find("TM35FIN"), std::string::npos);
  EXPECT_FALSE(lines.systems[0].geographic);
}

TEST_F(Ogr, AllLayersAreRead) {
  const std::string source = save(kMap, "map.geojson");
  (void)convert({"-f", "GPKG", "-nln", "a"}, source, "map.gpkg");
  const std::string path = convert({"-update", "-nln", "b (2)"}, source, "map.gpkg");
  EXPECT_EQ(read_lines({path}).lines.size(), 2 * read_lines({source}).lines.size());
}

// A quarter of a circle of radius 100, and a full one of radius 1.
constexpr const char* kArcs =
    "0\nSECTION\n2\nENTITIES\n0\nARC\n8\nfaults\n10\n0.0\n20\n0.0\n40\n100.0\n50\n0.0\n51\n90.0\n"
    "0\nCIRCLE\n8\nfaults\n10\n5.0\n20\n5.0\n40\n1.0\n0\nENDSEC\n0\nEOF\n";

TEST_F(Ogr, ArcsFollowTheToleranceWhateverTheirRadius) {
  const std::string path = save(kArcs, "arcs.dxf");
  std::size_t points_before = 0;
  for (const double tolerance : {1.0, 0.01, 1e-4}) {
    OgrOptions options;
    options.arc_tolerance = tolerance;
    const LineSet lines = read_lines({path}, options);
    ASSERT_EQ(lines.lines.size(), 2U);
    EXPECT_EQ(lines.attributes_of(LineId(0U)).set, "faults");
    double largest = 0;
    for (std::size_t i = 0; i < 2; ++i) {
      const Vec2 centre = i == 0 ? Vec2{0, 0} : Vec2{5, 5};
      const double radius = i == 0 ? 100 : 1;
      const Points& points = points_of(lines, i);
      for (std::size_t k = 0; k + 1 < points.size(); ++k) {
        const Vec2 middle = 0.5 * (points[k] + points[k + 1]) - centre;
        largest = std::max(largest, radius - std::hypot(middle.x, middle.y));
      }
    }
    EXPECT_LE(largest, tolerance);
    EXPECT_GE(points_of(lines, 0).size(), points_before);
    points_before = points_of(lines, 0).size();
  }
  EXPECT_GT(points_before, 100U);
}

TEST_F(Ogr, LayersMayHoldEverySortOfGeometryAndNone) {
  const std::string source = save(
      R"({"type":"FeatureCollection","features":[)"
      R"({"type":"Feature","properties":{"a;b;c;d":"1,2\n3","name":"say \"A\""},"geometry":{"type":"LineString","coordinates":[[0,0],[1,1]]}},)"
      R"({"type":"Feature","properties":{},"geometry":{"type":"Point","coordinates":[5,5]}},)"
      R"({"type":"Feature","properties":{},"geometry":null},)"
      R"({"type":"Feature","properties":{},"geometry":{"type":"GeometryCollection","geometries":[{"type":"Polygon","coordinates":[[[0,0],[9,0],[9,9],[0,0]]]}]}}]})",
      "map.geojson");
  const LineSet lines = read_lines({convert({"-f", "GPKG"}, source, "map.gpkg")});
  ASSERT_EQ(lines.lines.size(), 2U);
  EXPECT_EQ(lines.attributes_of(LineId(0U)).name, "say \"A\"");
  EXPECT_TRUE(lines.lines[LineId(1U)].polygon_ring);
}

TEST_F(Ogr, WhatItCannotReadIsAnErrorThatSaysWhatCanBe) {
  const std::string message = error_of("no drawing", "in.dxf");
  EXPECT_MESSAGE(message, "cannot read it");
  EXPECT_MESSAGE(message, ".geojson");
  EXPECT_MESSAGE(error_of_path((folder_ / "absent.gpkg").string()), "No such file");
}

TEST_F(Ogr, NamesAreNeverOptionsOrDatabases) {
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder_);
  save(kArcs, "-overwrite.dxf");
  save(kArcs, "PG:dbname=x.dxf");
  EXPECT_EQ(read_lines({"-overwrite.dxf"}).lines.size(), 2U);
  EXPECT_EQ(read_lines({"PG:dbname=x.dxf"}).lines.size(), 2U);
  std::filesystem::current_path(before);
}

TEST_F(LineFiles, WithoutOgrTheErrorSaysWhatToInstall) {
  const std::string path = std::getenv("PATH") == nullptr ? "" : std::getenv("PATH");
  setenv("PATH", folder_.c_str(), 1);
  const std::string message = error_of("x", "in.gpkg");
  setenv("PATH", path.c_str(), 1);
  EXPECT_MESSAGE(message, "gdal-bin");
  EXPECT_MESSAGE(message, ".geojson");
}

TEST(OgrLayers, AreParsedFromWhatOgrinfoPrints) {
  const std::vector<OgrLayer> layers = parse_ogr_layers(
      "INFO: Open of `a.gpkg'\n      using driver `GPKG' successful.\n\nLayer name: faults (2)\nGeometry: "
      "Line String\n"
      "Layer SRS WKT:\nGEOGCRS[\"WGS 84\",\n    ID[\"EPSG\",4326]]\nData axis to CRS axis mapping: "
      "2,1\nname: String (0.0)\n\n"
      "Layer name: table\nGeometry: None\n\nLayer name: plain\nGeometry: Point\nLayer SRS WKT:\n(unknown)\n");
  ASSERT_EQ(layers.size(), 3U);
  EXPECT_EQ(layers[0].name, "faults (2)");
  EXPECT_EQ(layers[0].system, "GEOGCRS[\"WGS 84\",ID[\"EPSG\",4326]]");
  EXPECT_FALSE(layers[1].geometry);
  EXPECT_TRUE(layers[2].geometry);
  EXPECT_EQ(layers[2].system, "");
}

}  // namespace
}  // namespace quarry
