// Real maps as published against the same lines in plain GeoJSON.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "io/child_process.hpp"
#include "io/lines/line_reader.hpp"
#include "io/scratch_folder.hpp"

namespace quarry {
namespace {

const std::string kFolder = "../shared/data/";

// Originals whose lines are those of NAME.lines.geojson, in its order.
class RealLines : public testing::TestWithParam<std::string> {};

TEST_P(RealLines, AreReadAsTheyWerePublished) {
  const std::string path = kFolder + GetParam();
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
  const std::string plain = path.substr(0, path.rfind('.')) + ".lines.geojson";
  const LineSet lines = read_lines({path});
  const LineSet expected = read_lines({plain});
  ASSERT_EQ(lines.lines.size(), expected.lines.size());
  for (const LineId id : IdRange<LineId>(expected.lines.size()))
    ASSERT_EQ(lines.lines[id].points, expected.lines[id].points) << id.value();
}

INSTANTIATE_TEST_SUITE_P(
    Originals, RealLines,
    testing::Values("planar/arizona_otherlines.geojson", "planar/getaberget_area.geojson",
                    "planar/getaberget_traces.geojson", "planar/hamersley_faults.geojson",
                    "planar/hamersley_geology.geojson", "planar/hastholmen_area.geojson",
                    "planar/hastholmen_traces.geojson", "planar/kb11_area.geojson",
                    "planar/kb11_traces.geojson", "planar/leftside_faults.txt",
                    "planar/lineaments_200k.geojson", "planar/lineaments_200k_area.geojson",
                    "planar/malawi_faults.geojson", "planar/souter_all.txt", "planar/thinsection_h12z.txt",
                    "ugly/kb10_unfit_traces.geojson", "ugly/mls_traces.geojson",
                    "ugly/stacked_and_v_node.geojson", "ugly/traces_troubling.geojson"),
    [](const auto& each) {
      std::string name = std::filesystem::path(each.param).stem().string();
      std::ranges::replace_if(
          name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
      return name;
    });

// Drawings whose arcs were cut into other steps: as many lines, with the same ends.
class RealDrawings : public testing::TestWithParam<std::string> {};

TEST_P(RealDrawings, HaveTheLinesThatWerePublished) {
  const std::string path = kFolder + GetParam();
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
  const ScratchFolder folder;
  if (!run_program({{"ogr2ogr", "--version"}, folder.file("out"), folder.file("err")}, Progress()))
    GTEST_SKIP() << "ogr2ogr (gdal-bin) is not installed";
  const LineSet lines = read_lines({path});
  const LineSet expected = read_lines({path.substr(0, path.rfind('.')) + ".lines.geojson"});
  ASSERT_EQ(lines.lines.size(), expected.lines.size());
  const double near = 1e-9 * expected.box().longer_side();
  for (const LineId id : IdRange<LineId>(expected.lines.size())) {
    const std::vector<Vec2>& points = lines.lines[id].points;
    const std::vector<Vec2>& wanted = expected.lines[id].points;
    for (const auto& [a, b] :
         {std::pair(points.front(), wanted.front()), std::pair(points.back(), wanted.back())})
      EXPECT_LE(std::hypot(a.x - b.x, a.y - b.y), near) << id.value();
  }
}

INSTANTIATE_TEST_SUITE_P(Dxf, RealDrawings,
                         testing::Values("planar/tray_cad.dxf", "planar/wrench_cad.dxf",
                                         "ugly/broken_loop_cad.dxf"),
                         [](const auto& each) { return std::filesystem::path(each.param).stem().string(); });

// 74 closed lines in 19 vertical planes, of which the plain file has one plane.
TEST(RealPlines, StandInVerticalPlanes) {
  const std::string path = kFolder + "planar/ore_section_closed.pl";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
  const LineSet lines = read_lines({path});
  const LineSet expected = read_lines({kFolder + "planar/ore_section_closed.lines.geojson"});
  EXPECT_EQ(lines.lines.size(), 74U);
  std::size_t next = 0;
  for (const InputLine& line : lines.lines) {
    if (line.points.front().x != 314590) continue;
    std::vector<Vec2> section;
    for (std::size_t i = 0; i < line.points.size(); ++i)
      section.push_back({line.points[i].y, line.heights[i]});
    if (std::ranges::any_of(line.points, [](Vec2 p) { return p.x != 314590; })) continue;
    ASSERT_LT(next, expected.lines.size());
    EXPECT_EQ(section, expected.lines[LineId(next++)].points);
  }
  EXPECT_EQ(next, expected.lines.size());
}

}  // namespace
}  // namespace quarry
