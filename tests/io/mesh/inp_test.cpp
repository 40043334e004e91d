#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "io/mesh/mesh_format.hpp"
#include "tests/io/mesh/temporary_folder.hpp"

namespace quarry {
namespace {

// Six nodes, two quads in a row and a triangle on top of the first.
constexpr const char* kNodes =
    "*HEADING\n two quads, a triangle\n** a comment\n*Node, NSET=all\n"
    "10, 0., 0.\n20, 1., 0., 0.\n 30 ,2.0D+0, 0\n40, 0, 1\n50, 1, 1\n60, 2, 1\n70, .5, 2\n";
constexpr const char* kFaces =
    "*ELEMENT, TYPE=CPS4R, ELSET=rock\n1, 10, 20, 50, 40\n2, 20, 30,\n 60, 50\n"
    "*Element, type=CPS3, elset=Ore\n7, 40, 50, 70\n";

class Inp : public testing::Test {
 protected:
  [[nodiscard]] ReadCells read(const std::string& text) const {
    return read_cells(folder_.file("a.inp", text));
  }
  void expect_error(const std::string& text, const std::string& message) const {
    try {
      static_cast<void>(read(text));
      FAIL() << "no error";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kInput);
      EXPECT_NE(error.message().find(message), std::string::npos) << error.message();
    }
  }
  TemporaryFolder folder_;
};

TEST_F(Inp, ReadsNodesAndElementsWhateverTheyAreCalled) {
  const ReadCells cells = read(std::string(kNodes) + kFaces);
  ASSERT_EQ(cells.x.size(), 7U);
  EXPECT_EQ(cells.x[2], 2.0);
  EXPECT_EQ(cells.y[6], 2.0);
  ASSERT_EQ(cells.faces.size(), 3U);
  EXPECT_EQ(cells.faces[1][2].value(), 5U) << "numbers go on after a comma at the end of a line";
  EXPECT_FALSE(cells.faces[2][3].valid());
  EXPECT_EQ(cells.regions, (std::vector<std::int32_t>{0, 0, 1}));
  EXPECT_EQ(cells.names.regions.at(0), "rock");
  EXPECT_EQ(cells.names.regions.at(1), "Ore");
}

TEST_F(Inp, TakesTheSetsOfSectionsForRegions) {
  const ReadCells cells = read(std::string(kNodes) + kFaces +
                               "*ELSET, ELSET=upper\n7\n*Elset, elset=lower, generate\n1, 2, 1\n"
                               "*Elset, elset=both\n1, 7\n*SOLID SECTION, ELSET=Both, MATERIAL=m\n1.,\n"
                               "*Solid Section, elset=region_5\n*ELSET, ELSET=REGION_5\n2\n");
  EXPECT_EQ(cells.regions, (std::vector<std::int32_t>{0, 5, 0}));
  EXPECT_EQ(cells.names.regions.at(0), "both");
}

TEST_F(Inp, TakesTheFirstSetThatDoesNotHoldAllForARegion) {
  const ReadCells cells = read(std::string(kNodes) + kFaces +
                               "*ELSET, ELSET=all\nrest, 7\n*ELSET, ELSET=rest, GENERATE\n1, 2\n"
                               "*ELSET, ELSET=tip\n7,\n*Elset, elset=late, internal\n1, 2, 7\n");
  EXPECT_EQ(cells.names.regions.at(cells.regions[0]), "rest");
  EXPECT_EQ(cells.names.regions.at(cells.regions[2]), "tip");
}

TEST_F(Inp, ReadsLineElementsOncePerSet) {
  const ReadCells cells = read(std::string(kNodes) + kFaces +
                               "*ELEMENT, TYPE=T3D2, ELSET=Line1\n11, 20, 50\n12, 40, 50\n"
                               "*ELSET, ELSET=line_4\n11\n*ELSET, ELSET=LINE_9\n11\n");
  ASSERT_EQ(cells.edges.size(), 3U);
  EXPECT_EQ(cells.constraints, (std::vector<std::int32_t>{4, 9, 0}));
  EXPECT_EQ(cells.names.lines.at(0), "Line1");
}

TEST_F(Inp, ReadsSurfacesAsTheEdgesOfTheirElements) {
  const ReadCells cells = read(std::string(kNodes) + kFaces +
                               "*ELSET, ELSET=bottom\n1, 2\n*SURFACE, NAME=base, TYPE=ELEMENT\nbottom, S1\n"
                               "*Surface, name=outer_boundary\n7, S3\n*SURFACE, NAME=skin\nbottom, SPOS\n"
                               "*SURFACE, NAME=points, TYPE=NODE\nall, 1.\n");
  ASSERT_EQ(cells.edges.size(), 3U);
  EXPECT_EQ(cells.edges[1], std::pair(VertexId(1U), VertexId(2U)));
  EXPECT_EQ(cells.edges[2], std::pair(VertexId(6U), VertexId(3U)));
  EXPECT_EQ(cells.constraints, (std::vector<std::int32_t>{0, 0, -1}));
  EXPECT_EQ(cells.names.lines.at(0), "base");
}

TEST_F(Inp, FindsNodesUnderNumbersOfAnySize) {
  const ReadCells cells = read(
      "*NODE\n4000000000, 0, 0\n7, 1, 0\n2000000000, 0, 1\n"
      "*ELEMENT, TYPE=S3\n9999999999, 4000000000, 7, 2000000000\n");
  ASSERT_EQ(cells.faces.size(), 1U);
  EXPECT_EQ(cells.faces[0][2].value(), 2U);
}

TEST_F(Inp, NamesTheLineOfWhatItCannotRead) {
  const std::string mesh = std::string(kNodes) + kFaces;
  expect_error("*NODE\n1, 0, 0\n2, x, 0\n", "a.inp:3: a coordinate is expected, not \"x\"");
  expect_error("*NODE\n1, 0, 0\n1, 1, 0\n", "a.inp:3: node 1 is given twice");
  expect_error("*NODE\n1, 0, 0\n*ELEMENT, TYPE=CPS3\n5, 1, 2, 3\n", "a.inp:4: node 2 does not exist");
  expect_error(mesh + "7, 10, 20, 50\n", "a.inp:18: element 7 is given twice");
  expect_error(mesh + "8, 10, 20, 50, 40, 60\n", "element 8 of type CPS3 has 5 nodes");
  expect_error(mesh + "*ELEMENT, TYPE=B22\n8, 10, 20, 50\n", "element 8 of type B22 has 3 nodes");
  expect_error(mesh + "*ELEMENT, TYPE=C3D4\n8, 10, 20, 50, 70\n",
               "a.inp:18: elements of type C3D4 are solids");
  expect_error("*INCLUDE, INPUT=b.inp\n", "a.inp:1: *INCLUDE is not supported");
  expect_error("*NODE, INPUT=b.inp\n", "a.inp:1: *NODE with INPUT or SYSTEM is not supported");
  expect_error(mesh + "*ELSET, ELSET=a, GENERATE\n9, 1\n", "9 to 1 in steps of 1 is no range");
  expect_error("*PART, NAME=a\n*NODE\n1, 0, 0\n*END PART\n*PART, NAME=b\n*NODE\n",
               "a second *PART with nodes");
}

TEST_F(Inp, TakesNodeSetsOfOneNodeForPoints) {
  const ReadCells cells = read(std::string(kNodes) + kFaces +
                               "*NSET, NSET=POINT_4\n30,\n*Nset, nset=Well\n50\n*NSET, NSET=edge\n10, 20\n"
                               "*NSET, NSET=of_a_set\nWell\n*NSET, NSET=elsewhere\n99\n"
                               "*NSET, NSET=some, GENERATE\n10, 30, 10\n");
  EXPECT_EQ(cells.points, (std::vector<VertexId>{VertexId(2U), VertexId(4U)}));
  EXPECT_EQ(cells.point_numbers, (std::vector<std::int32_t>{4, 0}));
  EXPECT_EQ(cells.names.points.at(0), "Well");
}

}  // namespace
}  // namespace quarry
