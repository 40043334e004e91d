#include "tests/io/mesh/read_error.hpp"

namespace quarry {
namespace {

TEST(OffReader, ReadsCommentsCountsBesideTheKeywordAndColours) {
  const ReadCells cells = read_text_as(
      "a.off",
      "# made by hand\nCOFF 5 2 # no edges\n\n0 0 0 255 0 0 255\n# a comment\n1 0 0 0.5 0.5 0.5 1\n"
      "  1 1 0.5\n0 1 0\r\n2 0 -1e-3\n4 0 1 2 3 0.1 0.2 0.3\n\n3 1 4 2\n# the end\n\n");
  ASSERT_EQ(cells.x.size(), 5U);
  EXPECT_EQ(cells.z[2], 0.5);
  EXPECT_EQ(cells.z[4], -1e-3);
  ASSERT_EQ(cells.faces.size(), 2U);
  EXPECT_EQ(cells.faces[0][3].value(), 3U);
  EXPECT_EQ(cells.faces[1][1].value(), 4U);
  EXPECT_FALSE(cells.faces[1][3].valid());
  EXPECT_EQ(cells.regions, (std::vector<std::int32_t>{0, 0}));
}

TEST(OffReader, KnowsAllKeywordsOfThreeCoordinates) {
  for (const std::string keyword : {"OFF", "COFF", "NOFF", "CNOFF", "STOFF", "STCNOFF"}) {
    const ReadCells cells = read_text_as("a.OFF", keyword + "\n3 1 3\n0 0 0 1\n1 0 0 1\n0 1 0 1\n3 0 1 2\n");
    EXPECT_EQ(cells.faces.size(), 1U) << keyword;
  }
  expect_read_error("a.off", "4OFF\n1 0 0\n0 0 0 1\n", "a.off:1: 4OFF: only points of three coordinates");
  expect_read_error("a.off", "nOFF\n3\n1 0 0\n0 0 0\n", "only points of three coordinates");
  expect_read_error("a.off", "OFF BINARY\n", "a.off:1: binary OFF is not read");
  expect_read_error("a.off", "POFF\n", "a.off:1: OFF, COFF, NOFF or STOFF is expected, not \"POFF\"");
}

TEST(OffReader, NamesTheLineOfWhatItCannotRead) {
  const std::string points = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
  expect_read_error("a.off", "", "a.off:1: the file ends too early");
  expect_read_error("a.off", std::string("\0\0\0\0", 4), "a.off:1: OFF, COFF, NOFF or STOFF is expected");
  expect_read_error("a.off", "OFF\n", "a.off:1: the file ends too early");
  expect_read_error("a.off", "OFF\n-3 1 0\n", "a.off:2: the number of points is -3");
  expect_read_error("a.off", "OFF\n3 1.5 0\n", "a.off:2: the number of faces is expected, not \"1.5\"");
  expect_read_error("a.off", "OFF\n3 1 0 7\n", "a.off:2: three counts stand on a line");
  expect_read_error("a.off", points, "a.off:5: the file ends too early: 3 points and 1 faces are announced");
  expect_read_error("a.off", points + "3 0 1 3\n", "a.off:6: point 3 does not exist; there are 3 points");
  expect_read_error("a.off", points + "3 0 1 -1\n", "a.off:6: point -1 does not exist");
  expect_read_error("a.off", points + "3 0 1\n", "a.off:6: the number of a point is missing");
  expect_read_error("a.off", points + "5 0 1 2 0 1\n", "a.off:6: a face has more than 4 corners");
  expect_read_error("a.off", points + "2 0 1\n", "a.off:6: a face has 2 corners");
  expect_read_error("a.off", points + "3 0 1 2\n3 0 1 2\n", "a.off:7: more lines follow than the 3 points");
  expect_read_error("a.off", "OFF\n1 0 0\n0 0\n", "a.off:3: a coordinate is missing");
  expect_read_error("a.off", "OFF\n1 0 0\n0 nan 0\n", "a.off:3: a coordinate is not a finite number");
  expect_read_error("a.off", "OFF\n1 0 0\n0 0 -inf\n", "a.off:3: a coordinate is not a finite number");
  expect_read_error("a.off", "OFF\n1 0 0\n0 0 zero\n", "a.off:3: a coordinate is expected, not \"zero\"");
}

TEST(OffReader, AsksForNoMemoryOnTheWordOfACount) {
  expect_read_error("a.off", "OFF\n4000000000 4000000000 0\n0 0 0\n",
                    "the file ends too early: 4000000000 points");
  expect_read_error("a.off", "OFF\n1 9223372036854775807 0\n0 0 0\n",
                    "9223372036854775807 faces are announced");
}

}  // namespace
}  // namespace quarry
