// Real maps as published against the same lines in plain GeoJSON.
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "io/lines/line_reader.hpp"

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

}  // namespace
}  // namespace quarry
