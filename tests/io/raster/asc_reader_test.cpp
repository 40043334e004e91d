#include "io/raster/asc_reader.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "tests/io/mesh/temporary_folder.hpp"

namespace quarry {
namespace {

class AscReader : public testing::Test {
 protected:
  [[nodiscard]] Raster read(const std::string& text) const { return read_asc(folder_.file("a.asc", text)); }
  void expect_refused(const std::string& text, const std::string& message) const {
    try {
      (void)read(text);
      ADD_FAILURE() << "accepted: " << text;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kInput);
      EXPECT_NE(error.message().find(message), std::string::npos) << error.message();
      EXPECT_EQ(error.message().find(folder_.file("a.asc")), 0U) << error.message();
    }
  }
  TemporaryFolder folder_;
};

const std::string kHeader = "ncols 3\nnrows 2\nxllcorner 10\nyllcorner 20\ncellsize 2\n";

TEST_F(AscReader, ReadsRowsFromTheTop) {
  const Raster raster = read(kHeader + "1 2 3\n4 5 6\n");
  EXPECT_EQ(raster.columns, 3U);
  EXPECT_EQ(raster.rows, 2U);
  EXPECT_EQ(raster.low, (Vec2{10, 20}));
  EXPECT_EQ(raster.cell, 2);
  EXPECT_EQ(raster.values, (std::vector<double>{1, 2, 3, 4, 5, 6}));
}

TEST_F(AscReader, TakesTheHeaderInAnyOrderAndCaseAndTheCentreOfTheFirstCell) {
  const Raster raster = read(
      "NCOLS 2\r\nNROWS 1\r\nCELLSIZE 2\r\nXLLCENTER 11\r\nyllCenter 21\r\nnodata_value -9999\r\n5\r\n6\r\n");
  EXPECT_EQ(raster.low, (Vec2{10, 20}));
  EXPECT_EQ(raster.values, (std::vector<double>{5, 6}));
}

TEST_F(AscReader, HasNoValueInCellsOfNoData) {
  const Raster raster = read(kHeader + "NODATA_value -9999\n1 -9999 3\n-9999.0 5 6\n");
  EXPECT_TRUE(std::isnan(raster.values[1]));
  EXPECT_TRUE(std::isnan(raster.values[3]));
  EXPECT_EQ(raster.values[4], 5);
  EXPECT_TRUE(std::isnan(read(kHeader + "NODATA_value nan\n1 NaN 3 4 5 6\n").values[1]));
}

TEST_F(AscReader, NamesTheRowAndColumnOfWhatIsNoNumber) {
  expect_refused(kHeader + "1 2 3\n4 x 6\n", "row 2, column 2");
  expect_refused(kHeader + "1 2 3\n4 5 nan\n", "row 2, column 3");
  expect_refused(kHeader + "inf 2 3\n4 5 6\n", "row 1, column 1");
  expect_refused(kHeader + "1 2,5 3\n4 5 6\n", "row 1, column 2");
  expect_refused(kHeader + "1 1e999 3\n4 5 6\n", "row 1, column 2");
}

TEST_F(AscReader, RefusesOtherCountsOfValues) {
  expect_refused(kHeader + "1 2 3\n4 5\n", "5 of 6 values, before row 2, column 3");
  expect_refused(kHeader + "1 2 3\n4 5 6 7\n", "more values than 3 columns times 2 rows");
  expect_refused(kHeader, "the file ends");
  expect_refused("ncols 3000000000\nnrows 3000000000\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2 3\n",
                 "too short");
  expect_refused("ncols 60\nnrows 60\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2 3 4 5 6 7 8 9\n",
                 "too short");
}

TEST_F(AscReader, RefusesAHeaderThatMakesNoSense) {
  expect_refused("", "the file ends");
  expect_refused("PK\x03\x04", "ncols is missing");
  expect_refused("ncols 3\nnrows 2\nxllcorner 10\nyllcorner 20\ndx 2\ndy 2\n1 2 3 4 5 6\n",
                 "its cells are not square");
  expect_refused("ncols 3\nncols 3\n", "ncols stands twice");
  expect_refused("ncols 2.5\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2 3\n", "ncols is 2.5");
  expect_refused("ncols -2\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2 3\n", "ncols is -2");
  expect_refused("ncols nan\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2 3\n", "ncols is nan");
  expect_refused("ncols 1\nnrows 1\nxllcorner 0\nxllcenter 0\nyllcorner 0\ncellsize 1\n1\n",
                 "both xllcorner and xllcenter");
  expect_refused("ncols 1\nnrows 1\nxllcorner inf\nyllcorner 0\ncellsize 1\n1\n", "xllcorner is inf");
  expect_refused("ncols 1\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 0\n1\n", "cellsize is 0");
}

TEST_F(AscReader, RefusesAFileThatIsNotThere) {
  EXPECT_THROW((void)read_asc(folder_.file("none.asc")), Error);
}

}  // namespace
}  // namespace quarry
