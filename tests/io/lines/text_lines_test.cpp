// FracPaQ, WKT, CSV, Triangle and GOCAD files, in small texts.
#include "tests/io/lines/line_files.hpp"

namespace quarry {
namespace {

class TextLines : public LineFiles {};

TEST_F(TextLines, FracpaqRowsAreTracesWithAnyLineEndAndPadding) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    const LineSet lines = read("1\t2\t3.5\t-4e1\t\t" + end + end + "  0  0\t 5 5\t6\t6" + end, "map.txt");
    ASSERT_EQ(lines.lines.size(), 2U) << end.size();
    EXPECT_EQ(points_of(lines, 0), (Points{{1, 2}, {3.5, -40}}));
    EXPECT_EQ(points_of(lines, 1), (Points{{0, 0}, {5, 5}, {6, 6}}));
    EXPECT_EQ(lines.lines[LineId(1U)].feature, 1U);
  }
}

TEST_F(TextLines, FracpaqRowsOfCommasAreToldByTheirContent) {
  const LineSet lines = read("0,0,1,1,NaN,NaN\n2,2,3,3,4,4\n", "map.csv");
  ASSERT_EQ(lines.lines.size(), 2U);
  EXPECT_EQ(points_of(lines, 0), (Points{{0, 0}, {1, 1}}));
}

TEST_F(TextLines, FracpaqErrorsNameTheRow) {
  EXPECT_MESSAGE(error_of("0 0 1 1\n\n0 0 1\n", "a.txt"), ":3: 3 numbers");
  EXPECT_MESSAGE(error_of("0 0 1 1\n0 0 x 1\n", "a.txt"), ":2: a number is expected, not \"x\"");
  EXPECT_MESSAGE(error_of("0\t0\t1\t1\r5\t\t6\t7\r", "a.txt"), ":2: a number is missing before 6");
  EXPECT_MESSAGE(error_of("0 0 1 1\n7 8\n", "a.txt"), ":2: a line of one point at (7, 8)");
  EXPECT_MESSAGE(error_of("0 0 1 1\n0 0 1e999 8\n", "a.txt"), ":2: coordinate 1e999");
  EXPECT_MESSAGE(error_of("0 0 1 1\n0 0 inf 8\n", "a.txt"), ":2: coordinate inf");
  EXPECT_MESSAGE(error_of("0 0 1 1\n0 0 nan 8\n", "a.txt"), ":2: a number is missing");
}

TEST_F(TextLines, WktHasOneGeometryAfterTheOther) {
  const LineSet lines = read(
      "# traces\nLINESTRING (0 0, 1 1)\nlinestring z(2 2 7,3 3 8);\n"
      "MULTILINESTRING M ((0 0 5,\n 1 0 6), EMPTY, (2 0 7, 3 0 8))\nPOINT (1 1)\nMULTIPOINT ((1 1), 2 2)\n"
      "SRID=3067;GEOMETRYCOLLECTION (POLYGON ((0 0, 9 0, 9 9), (1 1, 2 1, 2 2, 1 1)), LINESTRING EMPTY)\n",
      "map.wkt");
  ASSERT_EQ(lines.lines.size(), 8U);
  EXPECT_EQ(points_of(lines, 0), (Points{{0, 0}, {1, 1}}));
  EXPECT_EQ(lines.lines[LineId(1U)].heights, (std::vector<double>{7, 8}));
  EXPECT_TRUE(lines.lines[LineId(2U)].heights.empty());
  EXPECT_TRUE(points_of(lines, 3).empty());
  EXPECT_TRUE(lines.lines[LineId(5U)].closed());
  EXPECT_TRUE(lines.lines[LineId(6U)].hole);
  EXPECT_EQ(lines.lines[LineId(6U)].feature, 5U);
  EXPECT_EQ(lines.systems[0].definition, "EPSG:3067");
  EXPECT_FALSE(lines.systems[0].geographic);
}

TEST_F(TextLines, WktErrorsNameTheRow) {
  EXPECT_MESSAGE(error_of("LINESTRING (0 0, 1 1)\nLINESTRING (0 0,\n 1 x)", "a.wkt"), ":3: position 2");
  EXPECT_MESSAGE(error_of("LINESTRING (0 0, 1 1", "a.wkt"), "is expected");
  EXPECT_MESSAGE(error_of("CIRCULARSTRING (0 0, 1 1, 2 0)", "a.wkt"), "no geometry of straight lines");
  EXPECT_MESSAGE(error_of("LINESTRING (0 0, 1)", "a.wkt"), "coordinate is missing");
  EXPECT_MESSAGE(error_of("LINESTRING (0 0, 1 1e400)", "a.wkt"), "too large");
  EXPECT_MESSAGE(error_of("LINESTRING (4 5)", "a.wkt"), "one point at (4, 5)");
  EXPECT_MESSAGE(error_of("POLYGON (0 0, 1 1)", "a.wkt"), "( is expected");
  std::string deep;
  for (int i = 0; i < 100'000; ++i) deep += "GEOMETRYCOLLECTION (";
  EXPECT_MESSAGE(error_of(deep, "a.wkt"), "too deep");
}

TEST_F(TextLines, CsvHasAPointARowAndALineANumber) {
  const LineSet lines = read(
      "\xEF\xBB\xBFLine_ID, X ,Y,Z,Name,set,aperture,other\r\n1,0,0,5,\"Main, "
      "north\",A,0.5,x\r\n1,1,1,6,,,,\r\n"
      "7,2,2,,\"say \"\"hi\"\"\",B,,\r\n7,3,3,,,,,\r\n",
      "map.csv");
  ASSERT_EQ(lines.lines.size(), 2U);
  EXPECT_EQ(points_of(lines, 0), (Points{{0, 0}, {1, 1}}));
  EXPECT_EQ(lines.lines[LineId(0U)].heights, (std::vector<double>{5, 6}));
  EXPECT_TRUE(lines.lines[LineId(1U)].heights.empty());
  EXPECT_EQ(lines.attributes_of(LineId(0U)), (LineAttributes{"Main, north", "A", "", 0.5}));
  EXPECT_EQ(lines.attributes_of(LineId(1U)), (LineAttributes{"say \"hi\"", "B", "", {}}));
}

TEST_F(TextLines, CsvOfSemicolonsHasDecimalCommas) {
  const LineSet lines = read("easting;northing;id\n1,5;2;a\n3;4,25;a\n", "map.csv");
  EXPECT_EQ(points_of(lines, 0), (Points{{1.5, 2}, {3, 4.25}}));
}

TEST_F(TextLines, CsvHasWellKnownText) {
  const LineSet lines =
      read("id\tgeom\tmaterial\n1\tLINESTRING (0 0, 1 1)\tcalcite\n2\t\"POLYGON ((0 0, 5 0, 5 5, 0 0))\"\t\n",
           "map.tsv");
  ASSERT_EQ(lines.lines.size(), 2U);
  EXPECT_EQ(lines.attributes_of(LineId(0U)).material, "calcite");
  EXPECT_TRUE(lines.lines[LineId(1U)].polygon_ring);
  EXPECT_TRUE(lines.attributes_of(LineId(1U)).empty());
  EXPECT_EQ(read("wkt\n\"LINESTRING (0 0, 1 1)\"\n", "b.csv").lines.size(), 1U);
}

TEST_F(TextLines, CsvWithoutNamesIsPointsWithBlankRowsBetweenLines) {
  const LineSet lines = read("0 0\n1 1\n\n2 2 5\n3 3 5\n", "map.xy");
  ASSERT_EQ(lines.lines.size(), 2U);
  EXPECT_EQ(points_of(lines, 1), (Points{{2, 2}, {3, 3}}));
  EXPECT_EQ(lines.lines[LineId(1U)].heights, (std::vector<double>{5, 5}));
}

TEST_F(TextLines, TablesMayHaveBlanksBetweenTheirColumns) {
  const LineSet lines =
      read("  X   Y  ID name\n 1.5  2   7 A \n\t3 \t4  7 A\n 5  6  8 \"B C\"\n 7  8  8 B\n", "map.txt");
  ASSERT_EQ(lines.lines.size(), 2U);
  EXPECT_EQ(points_of(lines, 0), (Points{{1.5, 2}, {3, 4}}));
  EXPECT_EQ(lines.attributes_of(LineId(1U)).name, "B C");
}

TEST_F(TextLines, CsvErrorsNameTheRow) {
  EXPECT_MESSAGE(error_of("x,y,line\n0,0,1\n1,,1\n", "a.csv"), ":3: y is missing");
  EXPECT_MESSAGE(error_of("x,y,line\n0,0,1\nabc,1,1\n", "a.csv"), ":3: x is expected, not \"abc\"");
  EXPECT_MESSAGE(error_of("x,y,line\n0,0,1\nnan,1,1\n", "a.csv"), ":3: coordinate nan");
  EXPECT_MESSAGE(error_of("x,y,line\n0,0,1\n1,1,1\n2,2,2\n3,3,2\n4,4,1\n5,5,1\n", "a.csv"),
                 ":6: line 1 comes again");
  EXPECT_MESSAGE(error_of("a,b\n0,0\n", "a.csv"), ":1: no column is called x and y");
  EXPECT_MESSAGE(error_of("x,y,line\n0,0,1\n1,1,\"1\n", "a.csv"), ":3: a quote does not end");
  EXPECT_MESSAGE(error_of("x,y,line\n0,0,1\n", "a.csv"), ":2: a line of one point");
  EXPECT_MESSAGE(error_of("wkt,id\n\"LINESTRING (0 0, 1 1) x\",1\n", "a.csv"), ":2: \"x\" after a geometry");
  EXPECT_MESSAGE(error_of("id,wkt\n1,LINESTRING (0 0, 1 1)\n", "a.csv"), "in quotes");
  EXPECT_MESSAGE(error_of("1,5;2,5\n", "a.csv"), "name the columns");
}

TEST_F(TextLines, ColumnsOfLongitudeAndLatitudeAreDegrees) {
  EXPECT_TRUE(read("lon,lat,id\n33.1,-10.2,1\n33.2,-10.3,1\n", "a.csv").systems[0].geographic);
  EXPECT_FALSE(read("x,y,id\n33.1,-10.2,1\n33.2,-10.3,1\n", "a.csv").systems[0].geographic);
}

TEST_F(TextLines, PolySegmentsBecomeChainsWithTheirMarkerAsSet) {
  const LineSet lines = read(
      "# a square with a fault\n6 2 1 1\n1 0 0 .5 1\n2 4 0 .5 1\n3 4 4 .5 1\n4 0 4 .5 1 # corner\n5 1 2 .5 "
      "0\n6 3 2 .5 0\n"
      "5 1\n1 1 2 3\n2 2 3 3\n3 3 4 3\n4 4 1 3\n5 5 6 0\n0\n",
      "a.poly");
  ASSERT_EQ(lines.lines.size(), 2U);
  EXPECT_EQ(points_of(lines, 0), (Points{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}}));
  EXPECT_EQ(lines.attributes_of(LineId(0U)).set, "3");
  EXPECT_EQ(points_of(lines, 1), (Points{{1, 2}, {3, 2}}));
  EXPECT_FALSE(lines.lines[LineId(0U)].polygon_ring);
}

TEST_F(TextLines, PolyHolesAreHolesOfTheOutline) {
  const LineSet lines = read(
      "8 2 0 0\n0 0 0\n1 9 0\n2 9 9\n3 0 9\n4 2 2\n5 3 2\n6 3 3\n7 2 3\n"
      "8 0\n0 4 5\n1 5 6\n2 6 7\n3 7 4\n4 0 1\n5 1 2\n6 2 3\n7 3 0\n1\n0 2.5 2.5\n",
      "a.poly");
  ASSERT_EQ(lines.lines.size(), 2U);
  EXPECT_EQ(points_of(lines, 0)[1], (Vec2{9, 0}));
  EXPECT_TRUE(lines.lines[LineId(0U)].polygon_ring);
  EXPECT_TRUE(lines.lines[LineId(1U)].hole);
}

TEST_F(TextLines, PolyVerticesMayLieInANodeFile) {
  save("2 2 0 0\n1 0 0\n2 5 5\n", "a.node");
  EXPECT_EQ(points_of(read("0 2 0 0\n1 0\n1 1 2\n0\n", "a.poly"), 0), (Points{{0, 0}, {5, 5}}));
  EXPECT_MESSAGE(error_of("0 2 0 0\n1 0\n1 1 2\n0\n", "b.poly"), "b.node");
}

TEST_F(TextLines, PolyErrorsNameTheRow) {
  EXPECT_MESSAGE(error_of("2 2 0 0\n1 0 0\n2 1 1\n1 0\n1 1 3\n0\n", "a.poly"), ":5: vertex 3 does not exist");
  EXPECT_MESSAGE(error_of("2 2 0 0\n1 0 0\n1 1 1\n", "a.poly"), "vertex 1 is given twice");
  EXPECT_MESSAGE(error_of("2 3 0 0\n1 0 0 0\n", "a.poly"), "the dimension is 3");
  EXPECT_MESSAGE(error_of("9000000000 2 0 0\n1 0 0\n", "a.poly"), "ends too early");
  EXPECT_MESSAGE(error_of("-4 2 0 0\n1 0 0\n", "a.poly"), "is -4");
  EXPECT_MESSAGE(error_of("2 2 0 0\n1 0 nan\n", "a.poly"), ":2: coordinate nan");
}

constexpr const char* kPlines =
    "GOCAD PLine 1\nHEADER {\nname: Fault A\n}\nZPOSITIVE Depth\nILINE\nVRTX 1 0 0 5\nVRTX 2 1 0 6\nPVRTX 3 "
    "1 1 7 99\n"
    "SEG 1 2\nSEG 2 3\nSEG 3 1\nILINE\nVRTX 4 5 5 1\nVRTX 5 6 6 2\nEND\n"
    "GOCAD VSet 1\nVRTX 1 0 0 0\nEND\n";

TEST_F(TextLines, GocadPlinesHaveNamesAndHeights) {
  const LineSet lines = read(kPlines, "a.pl");
  ASSERT_EQ(lines.lines.size(), 2U);
  EXPECT_EQ(points_of(lines, 0), (Points{{0, 0}, {1, 0}, {1, 1}, {0, 0}}));
  EXPECT_EQ(lines.lines[LineId(0U)].heights, (std::vector<double>{-5, -6, -7, -5}));
  EXPECT_EQ(points_of(lines, 1), (Points{{5, 5}, {6, 6}}));
  EXPECT_EQ(lines.attributes_of(LineId(1U)).name, "Fault A");
}

TEST_F(TextLines, GocadErrorsNameTheRow) {
  EXPECT_MESSAGE(error_of("GOCAD PLine 1\nVRTX 1 0 0 0\nSEG 1 2\nEND\n", "a.pl"),
                 ":3: point 2 does not exist");
  EXPECT_MESSAGE(error_of("GOCAD PLine 1\nVRTX 1 0 0\nEND\n", "a.pl"), ":2: a coordinate is missing");
  EXPECT_MESSAGE(error_of("GOCAD PLine 1\nVRTX 1 0 0 0\n", "a.pl"), "END is missing");
}

TEST_F(TextLines, TheContentTellsTheFormatOfATextFile) {
  const std::string wanted[] = {R"( {"type":"LineString","coordinates":[[0,0],[1,1]]})",
                                "LINESTRING (0 0, 1 1)",
                                "x,y\n0,0\n1,1\n",
                                "0 0 1 1\n",
                                "2 2 0 0\n1 0 0\n2 1 1\n1 0\n1 1 2\n0\n",
                                "GOCAD PLine 1\nVRTX 1 0 0 0\nVRTX 2 1 1 0\nSEG 1 2\nEND\n"};
  for (const std::string& text : wanted) {
    const LineSet lines = read(text, "in.txt");
    ASSERT_EQ(lines.lines.size(), 1U) << text;
    EXPECT_EQ(points_of(lines, 0), (Points{{0, 0}, {1, 1}})) << text;
    EXPECT_EQ(read(text, "in").lines.size(), 1U) << text;
  }
  EXPECT_MESSAGE(error_of("what is this\n", "in.txt"), "no format of lines that is known");
  EXPECT_MESSAGE(error_of(std::string("a,b\0c\n", 6), "in.txt"), "no format of lines that is known");
  EXPECT_MESSAGE(error_of(" \r\n", "in.txt"), "empty");
}

TEST_F(TextLines, SurviveEveryTruncationAndChangedByte) {
  expect_survival("0 0\t1 1\t\n2,3,4,5\n", "a.txt");
  expect_survival("LINESTRING Z (0 0 1, 1 1 2)\nMULTIPOLYGON (((0 0,1 0,1 1)))", "a.wkt");
  expect_survival("x,y,line,aperture\n0,0,\"a\",1\n1,1,\"a\",\n\n2,2,b,\n3,3,b,\n", "a.csv");
  expect_survival("3 2 1 1\n1 0 0 9 1\n2 1 0 9 1\n3 1 1 9 1\n3 1\n1 1 2 4\n2 2 3 4\n3 3 1 4\n1\n1 .9 .1\n",
                  "a.poly");
  expect_survival(kPlines, "a.pl");
}

}  // namespace
}  // namespace quarry
