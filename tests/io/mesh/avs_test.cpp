#include "tests/io/mesh/read_error.hpp"
#include "tests/io/mesh/sample_mesh.hpp"

namespace quarry {
namespace {

// Two faces, a line and a point.
constexpr const char* kCells =
    "5 4 1 2 0\n1 0 0 0\n2 1 0 0\n30 1 1 0\n4 0 1 0\n5 0.5 2 0\n"
    "1 6 quad 1 2 30 4\n2 7 tri 4 30 5\n7 8 line 4 30\n9 1 pt 1\n";
constexpr const char* kPointValues = "1 1\nhead, m\n1 0.5\n2 0.5\n30 1e3\n4 2\n5 -1\n";

TEST(AvsReader, TakesMaterialsForGroupsWithoutOurValues) {
  const ReadCells cells = read_text_as("a.avs", std::string("# made by hand\n") + kCells + kPointValues +
                                                    "1 2\nflow, m/s\n1 0 0\n2 0 0\n7 0 0\n9 0 0\n");
  ASSERT_EQ(cells.x.size(), 5U);
  EXPECT_EQ(cells.y[4], 2.0);
  ASSERT_EQ(cells.faces.size(), 2U);
  EXPECT_EQ(cells.faces[0][2].value(), 2U);
  EXPECT_FALSE(cells.faces[1][3].valid());
  EXPECT_EQ(cells.regions, (std::vector<std::int32_t>{6, 7}));
  EXPECT_EQ(cells.constraints, std::vector<std::int32_t>{8});
  EXPECT_TRUE(cells.kinds.empty());
}

TEST(AvsReader, TakesOurValuesByTheNumberOfTheCell) {
  const ReadCells cells =
      read_text_as("a.UCD", std::string(kCells) + kPointValues +
                                "2 1 1\nregion, none\nconstraint\n9 0 0\n7 -1 3\n2 1 -1\n1 0 -1\n");
  EXPECT_EQ(cells.regions, (std::vector<std::int32_t>{0, 1}));
  EXPECT_EQ(cells.constraints, std::vector<std::int32_t>{3});
}

TEST(AvsReader, NamesTheLineOfWhatItCannotRead) {
  expect_read_error("a.avs", "", "a.avs:1: the file ends too early");
  expect_read_error("a.avs", "3 1 0 0\n", "a.avs:1: the file ends too early: 3 points are announced");
  expect_read_error("a.avs", "9000000000000000000 1 0 0 0\n", "points are announced");
  expect_read_error("a.avs", "-3 1 0 0 0\n", "a.avs:1: the number of points is -3");
  const std::string points = "3 1 0 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n";
  expect_read_error("a.avs", points, "a.avs:4: the file ends too early: 1 cells are announced");
  expect_read_error("a.avs", points + "1 1 tri 1 2 4\n", "a.avs:5: point 4 does not exist");
  expect_read_error("a.avs", points + "1 1 hex 1 2 4\n", "a.avs:5: a cell of the type \"hex\"");
  expect_read_error("a.avs", points + "1 1 tri 1 2\n", "a.avs:5: the number of a point is missing");
  expect_read_error("a.avs", points + "1 1 tri 1 2 3\n1 1 tri 1 2 3\n", "a.avs:6: more lines follow");
  expect_read_error("a.avs", "2 0 0 0 0\n1 0 0 0\n1 1 0 0\n", "a.avs:3: point 1 is there twice");
  expect_read_error("a.avs", "1 0 0 0 0\n1 0 nan 0\n", "a.avs:2: a coordinate is not a finite number");
  const std::string valued = "3 1 0 1 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n1 1 tri 1 2 3\n";
  expect_read_error("a.avs", valued + "1 2\n", "a.avs:6: components of more or fewer than 1 values");
  expect_read_error("a.avs", valued + "1 1\nregion, none\n1 0.5\n",
                    "a.avs:8: region is 0.5, no whole number");
  expect_read_error("a.avs", valued + "1 1\nregion, none\n4 0\n", "a.avs:8: cell 4 does not exist");
  expect_read_error("a.avs", valued + "1 1\nregion, none\n", "the file ends too early: 1 values of cells");
}

TEST(AvsWriter, NumbersMaterialsOfRegionsBeforeThoseOfLines) {
  const TemporaryFolder folder;
  write_mesh(folder.file("a.avs"), make_sample_mesh({.size = 7}), {});
  std::string text = file_content(folder.file("a.avs"));
  // Regions 0 and 1 are 1 and 2, edges without a number 3, lines 0, 3 and 5 are 4, 5 and 6.
  for (const char* start : {" 1 quad ", " 2 tri ", " 3 line ", " 4 line ", " 5 line ", " 6 line "})
    EXPECT_NE(text.find(start), std::string::npos) << start;
  EXPECT_EQ(text.find(" 7 line "), std::string::npos);
}

}  // namespace
}  // namespace quarry
