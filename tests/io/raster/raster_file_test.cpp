// Rasters that GDAL reads; where it is not installed the error is tested alone.
#include "io/raster/raster_file.hpp"

#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "io/child_process.hpp"
#include "io/raster/asc_reader.hpp"
#include "io/scratch_folder.hpp"
#include "tests/io/mesh/temporary_folder.hpp"

namespace quarry {
namespace {

constexpr const char* kSizes =
    "ncols 3\nnrows 2\nxllcorner 466000.5\nyllcorner 6691500\ncellsize 40\nNODATA_value -9\n"
    "1 2.123456789012345 4\n3 -9 0.7\n";

std::string error_of(const std::string& path) {
  try {
    (void)read_raster(path);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInput);
    return error.message();
  }
  return "no error";
}

// Runs a program of GDAL; whether it is there.
bool run(const std::vector<std::string>& words) {
  const ScratchFolder folder;
  return run_program({words, folder.file("out"), folder.file("err")}, Progress()) == 0;
}

TEST(RasterFile, GeotiffsHaveTheValuesOfTheirSource) {
  const TemporaryFolder folder;
  const std::string source = folder.file("s.asc", kSizes), image = folder.file("s.tif");
  if (!run({"gdal_translate", "-ot", "Float64", source, image}))
    GTEST_SKIP() << "gdal_translate (gdal-bin) is not installed";
  const Raster text = read_asc(source), read = read_raster(image);
  EXPECT_EQ(read.columns, 3U);
  EXPECT_EQ(read.low, text.low);
  EXPECT_EQ(read.cell, text.cell);
  ASSERT_EQ(read.values.size(), text.values.size());
  // GDAL itself reads texts in single precision.
  for (std::size_t i = 0; i < text.values.size(); ++i) {
    EXPECT_EQ(std::isnan(read.values[i]), std::isnan(text.values[i])) << i;
    if (!std::isnan(text.values[i])) {
      EXPECT_NEAR(read.values[i], text.values[i], 1e-7 * text.values[i]) << i;
    }
  }
}

TEST(RasterFile, CellsThatAreNotSquareAreAnErrorWithTheRemedy) {
  const TemporaryFolder folder;
  const std::string source = folder.file("s.asc", kSizes), image = folder.file("s.tif");
  if (!run({"gdal_translate", "-outsize", "3", "5", source, image}))
    GTEST_SKIP() << "gdal_translate (gdal-bin) is not installed";
  EXPECT_NE(error_of(image).find("gdalwarp -tr"), std::string::npos) << error_of(image);
  EXPECT_EQ(error_of(image).find(image), 0U) << "the user's file, not the one in between";
}

TEST(RasterFile, WhatCannotBeReadIsToldWithWhatCanBe) {
  const TemporaryFolder folder;
  const std::string broken = folder.file("b.tif", "no image");
  EXPECT_NE(error_of(broken).find(".asc"), std::string::npos) << error_of(broken);
  EXPECT_NE(error_of(folder.file("none.tif")).find("No such file"), std::string::npos);
}

TEST(RasterFile, ExtensionsTellRastersFromPoints) {
  for (const char* const name : {"a.asc", "a.ASC", "a.tif", "a.TIFF", "a.vrt"})
    EXPECT_TRUE(is_raster_file(name));
  for (const char* const name : {"a.txt", "a.csv", "asc", "a"}) EXPECT_FALSE(is_raster_file(name));
}

}  // namespace
}  // namespace quarry
