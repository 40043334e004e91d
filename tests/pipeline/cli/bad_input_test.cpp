// Bad input ends in one line on the standard error stream, the right exit code, and no output touched.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/pipeline/cli/command_run.hpp"

namespace quarry {
namespace {

constexpr const char* kKept = "what was there before";

std::string feature(const std::string& type, const std::string& coordinates) {
  return R"({"type": "Feature", "properties": {}, "geometry": {"type": ")" + type + R"(", "coordinates": )" +
         coordinates + "}}";
}

std::string collection(const std::string& features) {
  return R"({"type": "FeatureCollection", "features": [)" + features + "]}";
}

const std::string kGoodLine = feature("LineString", "[[0, 0], [10, 10]]");

class BadInput : public testing::Test {
 protected:
  // Expects `quarry mesh` to refuse, naming each of the words.
  void expect_refused(int code, std::vector<std::string> arguments,
                      const std::vector<std::string>& words = {}) {
    const std::string output = folder_.write("out.vtu", kKept);
    const std::string report = folder_.write("report.json", kKept);
    const std::vector<std::string> before = folder_.names();
    arguments.insert(arguments.begin(), "mesh");
    arguments.insert(arguments.end(), {"-o", output, "--report", report});
    const CommandResult result = run_quarry(arguments);
    EXPECT_EQ(result.exit_code, code) << result.err;
    EXPECT_EQ(result.error_lines(), 1U) << result.err;
    EXPECT_EQ(result.out, "");
    for (const std::string& word : words)
      EXPECT_NE(result.err.find(word), std::string::npos) << word << " in " << result.err;
    EXPECT_EQ(read_text(output), kKept);
    EXPECT_EQ(read_text(report), kKept);
    EXPECT_EQ(folder_.names(), before) << "a file was left behind";
  }
  void expect_refused_text(int code, const std::string& text, const std::vector<std::string>& words = {}) {
    expect_refused(code, {folder_.write("in.geojson", text), "--size", "1"}, words);
  }

  TestFolder folder_;
};

TEST_F(BadInput, NotANumberIsToldWithItsFeature) {
  expect_refused_text(3, collection(kGoodLine + "," + feature("LineString", "[[0, 1], [NaN, 2]]")),
                      {"in.geojson"});
}

TEST_F(BadInput, AnInfiniteCoordinateIsToldWithItsFeature) {
  expect_refused_text(3, collection(kGoodLine + "," + feature("LineString", "[[0, 1], [1e999, 2]]")),
                      {"in.geojson"});
}

TEST_F(BadInput, ACoordinateTooLargeToWorkWithIsToldWithTheLargest) {
  expect_refused_text(3, collection(feature("LineString", "[[0, 0], [1e41, 7e40]]")),
                      {"in.geojson", "1e+41", "the largest is 1e+30"});
}

TEST_F(BadInput, ATextForACoordinateIsTold) {
  expect_refused_text(3, collection(feature("LineString", R"([[0, 1], ["east", 2]])")),
                      {"in.geojson", "feature 0"});
}

TEST_F(BadInput, AMissingCoordinateIsToldWithItsFeature) {
  expect_refused_text(3, collection(kGoodLine + "," + feature("LineString", "[[0, 1], [2]]")),
                      {"in.geojson", "feature 1"});
}

TEST_F(BadInput, NullForACoordinateIsTold) {
  expect_refused_text(3, collection(feature("LineString", "[[0, 1], [null, 2]]")), {"in.geojson"});
}

TEST_F(BadInput, AnEmptyFileIsTold) { expect_refused_text(3, "", {"in.geojson"}); }

TEST_F(BadInput, ACollectionWithoutLinesIsTold) { expect_refused_text(3, collection(""), {"in.geojson"}); }

TEST_F(BadInput, BrokenJsonIsTold) {
  expect_refused_text(3, R"({"type": "FeatureCollection", "features": [)", {"in.geojson"});
}

TEST_F(BadInput, BytesThatAreNoTextAreTold) {
  expect_refused_text(3, std::string("\x00\xff\xfe\x80garbage", 11), {"in.geojson"});
}

TEST_F(BadInput, ALineOfOnePointIsToldWithItsFeature) {
  expect_refused_text(3, collection(kGoodLine + "," + feature("LineString", "[[3, 4]]")),
                      {"in.geojson", "feature 1"});
}

TEST_F(BadInput, LinesThatAreAllOnePointAreTold) {
  expect_refused_text(3, collection(feature("LineString", "[[3, 4], [3, 4]]")), {"in.geojson", "(3, 4)"});
}

TEST_F(BadInput, ALineOfOnePointTwiceIsToldWithItsFeature) {
  const std::string point = collection(feature("LineString", "[[3, 4], [3, 4]]"));
  for (const std::string boundary : {"box", "hull"})
    expect_refused(3, {folder_.write("in.geojson", point), "--size", "1", "--boundary", boundary},
                   {"in.geojson: feature 0: line 0: ", "(3, 4)"});
}

TEST_F(BadInput, AnEmptyLineIsToldWithItsFeature) {
  for (const std::string boundary : {"box", "hull"})
    expect_refused(3,
                   {folder_.write("in.geojson", collection(feature("LineString", "[]"))), "--size", "1",
                    "--boundary", boundary},
                   {"in.geojson: feature 0: line 0: "});
}

TEST_F(BadInput, AFlatPolygonIsToldWithItsFeature) {
  const std::string flat = collection(feature("Polygon", "[[[2, 2], [6, 2], [10, 2], [2, 2]]]"));
  expect_refused_text(3, flat, {"in.geojson: feature 0: line 0: ", "(2, 2)", "no area"});
  const std::string area = folder_.write("area.geojson", flat);
  expect_refused(3, {folder_.write("in.geojson", collection(kGoodLine)), "--size", "1", "--boundary", area},
                 {"area.geojson: feature 0: line 0: ", "(2, 2)", "no area"});
}

TEST_F(BadInput, ADomainTooSmallForItsLengthsIsToldWithItsFile) {
  expect_refused_text(3, collection(feature("LineString", "[[0, 0], [1e-80, 1e-80]]")), {"in.geojson: "});
}

TEST_F(BadInput, AFileThatIsNotThereIsTold) {
  expect_refused(3, {folder_ / "none.geojson", "--size", "1"}, {"none.geojson"});
}

TEST_F(BadInput, AFolderForAnInputIsTold) { expect_refused(3, {"tests", "--size", "1"}, {"tests"}); }

TEST_F(BadInput, AnUnknownInputExtensionIsTold) {
  expect_refused(3, {folder_.write("lines.xyz", "0 0"), "--size", "1"}, {"lines.xyz"});
}

TEST_F(BadInput, ASelfCrossingOutlineIsToldWithTheCrossing) {
  const std::string area = folder_.write(
      "area.geojson", collection(feature("Polygon", "[[[0, 0], [10, 10], [10, 0], [0, 10], [0, 0]]]")));
  expect_refused(3, {folder_.write("in.geojson", collection(kGoodLine)), "--size", "1", "--boundary", area},
                 {"area.geojson", "(5, 5)"});
}

TEST_F(BadInput, ASelfCrossingPolygonOfTheInputIsTold) {
  expect_refused_text(3, collection(feature("Polygon", "[[[0, 0], [10, 10], [10, 0], [0, 10], [0, 0]]]")),
                      {"in.geojson", "(5, 5)"});
}

TEST_F(BadInput, AnOutlineThatHoldsNoLineIsToldWithBothPlaces) {
  const std::string area = folder_.write(
      "area.geojson", collection(feature("Polygon", "[[[50, 50], [90, 50], [90, 90], [50, 90], [50, 50]]]")));
  expect_refused(3, {folder_.write("in.geojson", collection(kGoodLine)), "--size", "1", "--boundary", area},
                 {"(50, 50)", "(0, 0)"});
}

TEST_F(BadInput, ABoundaryFileWithoutARingIsTold) {
  const std::string area = folder_.write("area.geojson", collection(kGoodLine));
  expect_refused(3, {kDemoSection, "--size", "20", "--boundary", area}, {"area.geojson"});
}

TEST_F(BadInput, ABoundaryFileThatIsNotThereIsTold) {
  expect_refused(3, {kDemoSection, "--size", "20", "--boundary", folder_ / "none.geojson"}, {"none.geojson"});
}

TEST_F(BadInput, AStartMeshThatCannotBeReadIsTold) {
  expect_refused(3, {kDemoSection, "--size", "20", "--start", folder_ / "none.msh", "--quiet"}, {"none.msh"});
}

TEST_F(BadInput, AStartMeshOfAnUnknownFormatIsToldBeforeTheWork) {
  const std::string start = folder_.write("start.xyz", "solid");
  expect_refused(2, {kDemoSection, "--size", "20", "--start", start}, {"start.xyz", ".vtu"});
}

TEST_F(BadInput, AStartMeshWithoutATriangleIsTold) {
  const std::string start = folder_.write("start.obj", "v 0 0\nv 1 0\nv 0 1\n");
  expect_refused(3, {kDemoSection, "--size", "20", "--start", start}, {"start.obj", "no triangle"});
}

TEST_F(BadInput, ASizeOfZeroIsTold) { expect_refused(2, {kDemoSection, "--size", "0"}, {"--size"}); }

TEST_F(BadInput, ANegativeSizeIsTold) { expect_refused(2, {kDemoSection, "--size", "-5"}, {"--size"}); }

TEST_F(BadInput, ASizeThatIsNotANumberIsTold) {
  expect_refused(2, {kDemoSection, "--size", "wide"}, {"--size"});
  expect_refused(2, {kDemoSection, "--size", "nan"}, {"--size"});
  expect_refused(2, {kDemoSection, "--size", "inf"}, {"--size"});
}

TEST_F(BadInput, ASizeBeyondTheBoxIsToldWithItsLongerSide) {
  expect_refused(2, {kDemoSection, "--size", "5000"}, {"5000", "longer side"});
}

TEST_F(BadInput, ASizeAThousandTimesTooSmallIsRefusedBeforeTheWork) {
  expect_refused(5, {kDemoSection, "--size", "0.006"}, {"--max-elements", "GB"});
  expect_refused(5, {kDemoSection, "--size", "1e-300"}, {"--max-elements"});
  expect_refused(5, {kDemoSection, "--count", "1e12"}, {"--max-elements"});
}

TEST_F(BadInput, AJobBeyondItsOwnLimitIsRefused) {
  expect_refused(5, {kDemoSection, "--size", "6", "--max-elements", "1000"}, {"--max-elements 1e+03"});
}

TEST_F(BadInput, SizeAndCountTogetherAreTold) {
  expect_refused(2, {kDemoSection, "--size", "6", "--count", "1000"}, {"--size", "--count"});
  expect_refused(2, {kDemoSection}, {"--size", "--count"});
}

TEST_F(BadInput, NegativeLengthsAreTold) {
  expect_refused(2, {kDemoSection, "--size", "6", "--snap", "-1"}, {"--snap"});
  expect_refused(2, {kDemoSection, "--size", "6", "--min-edge", "nan"}, {"--min-edge"});
  expect_refused(2, {kDemoSection, "--size", "6", "--tolerance", "-0.1"}, {"--tolerance"});
}

}  // namespace
}  // namespace quarry
