#include "tests/io/mesh/read_error.hpp"

namespace quarry {
namespace {

constexpr const char* kSurface =
    "GOCAD TSurf 1\nHEADER {\nname: fault 7 north\n*visible:true\n}\n"
    "GOCAD_ORIGINAL_COORDINATE_SYSTEM\nNAME Default\nAXIS_NAME \"X\" \"Y\" \"Z\"\nZPOSITIVE Elevation\n"
    "END_ORIGINAL_COORDINATE_SYSTEM\nPROPERTY_CLASS_HEADER Z {\nis_z:on\n}\n# a comment\nTFACE\n"
    "VRTX 10 0 0 5\nPVRTX 20 1 0 5 0.25 -99999\nVRTX 30 0 1 5 CNXYZ\nTRGL 10 20 30\nTFACE\n"
    "ATOM 41 20\nPATOM 42 30 0.5\nVRTX 43 1 1 6\nTRGL 41 43 42\nBSTONE 10\nBORDER 50 10 20\nEND\n";

TEST(GocadReader, ReadsAllSortsOfPointsAndNamesTheSurface) {
  const ReadCells cells = read_text_as("a.ts", kSurface);
  EXPECT_EQ(cells.x, (std::vector<double>{0, 1, 0, 1}));
  EXPECT_EQ(cells.z, (std::vector<double>{5, 5, 5, 6}));
  ASSERT_EQ(cells.faces.size(), 2U);
  EXPECT_EQ(cells.faces[1], (FaceCorners{VertexId(1U), VertexId(3U), VertexId(2U), VertexId()}));
  EXPECT_EQ(cells.regions, (std::vector<std::int32_t>{0, 0}));
  EXPECT_EQ(cells.names.regions.at(0), "fault 7 north");
}

TEST(GocadReader, TurnsOverTheZOfDepths) {
  std::string text = kSurface;
  text.replace(text.find("Elevation"), 9, "Depth");
  EXPECT_EQ(read_text_as("a.ts", text).z, (std::vector<double>{-5, -5, -5, -6}));
}

TEST(GocadReader, ReadsTheSurfacesOfAModelAndPassesOverTheRest) {
  const ReadCells cells = read_text_as(
      "a.ml",
      std::string("GOCAD Model3d 1\nHEADER {\nname:model\n}\nTSURF upper\nTFACE 1 top upper\n  0 0 0\n"
                  "  1 0 0\nREGION 2 Universe\n  -1 0\nEND\n\nGOCAD PLine 1\nVRTX 1 9 9 9\nEND\n"
                  "GOCAD TSurf 1\nHEADER {name:region_3}\nVRTX 1 0 0 0\nVRTX 2 1 0 0\nVRTX 3 0 1 0\n"
                  "TRGL 1 2 3\nEND\nGOCAD TSurf 1\nHDR name:lower\nVRTX 1 7 0 0\nVRTX 2 8 0 0\n"
                  "VRTX 3 7 1 0\nTRGL 3 1 2\nEND\n") +
          kSurface);
  EXPECT_EQ(cells.regions, (std::vector<std::int32_t>{3, 0, 1, 1}));
  EXPECT_EQ(cells.names.regions.at(0), "lower");
  EXPECT_EQ(cells.names.regions.at(1), "fault 7 north");
  EXPECT_EQ(cells.x.size(), 10U);
  EXPECT_EQ(cells.faces[1], (FaceCorners{VertexId(5U), VertexId(3U), VertexId(4U), VertexId()}));
}

TEST(GocadReader, NamesTheLineOfWhatItCannotRead) {
  const std::string points = "GOCAD TSurf 1\nVRTX 1 0 0 0\nVRTX 2 1 0 0\nVRTX 3 0 1 0\n";
  expect_read_error("a.ts", "", "a.ts: no TSurf is in it");
  expect_read_error("a.ts", "GOCAD PLine 1\nEND\n", "a.ts: no TSurf is in it");
  expect_read_error("a.ts", std::string("\0\0", 2), "a.ts:1: GOCAD and the sort of an object are expected");
  expect_read_error("a.ts", "VRTX 1 0 0 0\n",
                    "a.ts:1: GOCAD and the sort of an object are expected, not \"VRTX\"");
  expect_read_error("a.ts", "GOCAD\nTSurf\n", "a.ts:1: the sort of an object is missing");
  expect_read_error("a.ts", points + "TRGL 1 2 3\n", "a.ts:5: the file ends too early: END is missing");
  expect_read_error("a.ts", "GOCAD TSurf 1\nHEADER {\nname:a\n",
                    "a.ts:3: the file ends too early: } is missing");
  expect_read_error("a.ts", points + "TRGL 1 2\nEND\n", "a.ts:5: the number of a point is missing");
  expect_read_error("a.ts", points + "TRGL 1 2 4\nEND\n", "a.ts:5: point 4 does not exist in this surface");
  expect_read_error("a.ts", points + "VRTX 3 1 1 1\nEND\n", "a.ts:5: point 3 is given twice");
  expect_read_error("a.ts", points + "ATOM 4 9\nEND\n", "a.ts:5: point 9 does not exist");
  expect_read_error("a.ts", points + "VRTX 4 1 1\nEND\n", "a.ts:5: a coordinate is missing");
  expect_read_error("a.ts", points + "VRTX 4 1 nan 1\nEND\n", "a.ts:5: a coordinate is not a finite number");
  expect_read_error("a.ts", points + "\1\2\3\nEND\n", "a.ts:5: a key is expected");
  expect_read_error("a.ts", "GOCAD TSurf 1\nZPOSITIVE Down\n",
                    "a.ts:2: Elevation or Depth is expected, not \"Down\"");
}

}  // namespace
}  // namespace quarry
