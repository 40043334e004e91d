#include <cmath>

#include "io/mesh/stl_format.hpp"
#include "tests/io/mesh/byte_text.hpp"
#include "tests/io/mesh/read_error.hpp"

namespace quarry {
namespace {

using Corner = std::array<float, 3>;

std::string binary_stl(const std::vector<std::array<Corner, 3>>& facets,
                       const std::string& header = "made by hand") {
  ByteText bytes(std::endian::little);
  bytes.add(static_cast<std::uint32_t>(facets.size()));
  for (const auto& facet : facets) {
    bytes.add(0.0F, 0.0F, 1.0F);
    for (const Corner& p : facet) bytes.add(p[0], p[1], p[2]);
    bytes.add(std::uint16_t{7});
  }
  std::string start = header;
  start.resize(80, ' ');
  return start + bytes.text();
}

std::string text_facet(const std::string& a, const std::string& b, const std::string& c) {
  return "  facet normal 0 0 nan\n    outer loop\n      vertex " + a + "\n      vertex " + b +
         "\n      vertex " + c + "\n    endloop\n  endfacet\n";
}

const std::vector<std::array<Corner, 3>> kTwoFacets = {{Corner{0, 0, 0}, {1, 0, 0}, {1, 1, 0.5F}},
                                                       {Corner{-0.0F, 0, 0}, {1, 1, 0.5F}, {0, 1, -0.0F}}};

void expect_two_facets(const ReadCells& cells) {
  EXPECT_EQ(cells.x, (std::vector<double>{0, 1, 1, 0}));
  EXPECT_EQ(cells.y, (std::vector<double>{0, 0, 1, 1}));
  EXPECT_EQ(cells.z, (std::vector<double>{0, 0, 0.5, 0}));
  for (const double value : cells.z) EXPECT_FALSE(std::signbit(value));
  ASSERT_EQ(cells.faces.size(), 2U);
  EXPECT_EQ(cells.faces[0], (FaceCorners{VertexId(0U), VertexId(1U), VertexId(2U), VertexId()}));
  EXPECT_EQ(cells.faces[1], (FaceCorners{VertexId(0U), VertexId(2U), VertexId(3U), VertexId()}));
}

TEST(StlReader, MakesOnePointOfEqualCornersInOrderOfAppearance) {
  expect_two_facets(read_text_as("a.stl", binary_stl(kTwoFacets)));
  expect_two_facets(read_text_as("a.STL", "solid\n" + text_facet("0 0 0", "1 0 0", "1 1 .5") +
                                              text_facet("-0 0 0", "1 1 0.5", "0 1 -0.0") + "endsolid\n"));
}

TEST(StlReader, KnowsABinaryFileByItsSizeBeforeItsFirstWord) {
  expect_two_facets(read_text_as("a.stl", binary_stl(kTwoFacets, "solid of some CAD program")));
  expect_read_error("a.stl", binary_stl(kTwoFacets, "solid of some CAD program") + "xy",
                    "a.stl: byte 80: the header announces 2 facets, which make a file of 184 bytes, not 186");
}

TEST(StlReader, MakesARegionOfEachSolidInEitherCaseOfLetters) {
  const ReadCells cells = read_text_as(
      "a.stl", "  SOLID  fault 7 north \r\n" + text_facet("0 0 0", "1 0 0", "1 1 0") +
                   "ENDSOLID fault 7 north\nsolid region_5\n" + text_facet("0 0 0", "1 1 0", "0 1 0") +
                   "endsolid\nsolid\n" + text_facet("0 0 0", "0 1 0", "-1 0 0") +
                   "endsolid\nsolid empty\nendsolid\nsolid fault 7 north\n" +
                   text_facet("0 1 0", "1 1 0", "1 2 0") + "endsolid\n\n");
  EXPECT_EQ(cells.regions, (std::vector<std::int32_t>{0, 5, 1, 0}));
  ASSERT_EQ(cells.names.regions.size(), 1U);
  EXPECT_EQ(cells.names.regions.at(0), "fault 7 north");
  EXPECT_EQ(cells.x.size(), 6U);
}

TEST(StlReader, FindsEqualPointsAmongManyThatAreNot) {
  // No point is shared: more than the first table has room for.
  std::vector<std::array<Corner, 3>> facets;
  for (int i = 0; i < 3000; ++i) {
    const auto z = static_cast<float>(i);
    facets.push_back({Corner{0, 0, z}, {1, 0, z}, {0, 1, z}});
  }
  EXPECT_EQ(read_text_as("a.stl", binary_stl(facets)).x.size(), 9000U);
  facets.insert(facets.end(), facets.begin(), facets.end());
  const ReadCells cells = read_text_as("a.stl", binary_stl(facets));
  EXPECT_EQ(cells.x.size(), 9000U);
  for (std::uint32_t f = 0; f < 3000; ++f) {
    ASSERT_EQ(cells.faces[f][0].value(), 3 * f);
    ASSERT_EQ(cells.faces[f + 3000], cells.faces[f]);
  }
}

TEST(StlReader, ReadsAFileWithoutFacets) {
  EXPECT_EQ(read_text_as("a.stl", binary_stl({})).faces.size(), 0U);
  EXPECT_EQ(read_text_as("a.stl", "solid nothing\nendsolid nothing\n").faces.size(), 0U);
}

TEST(StlReader, NamesTheByteOfBinaryThatIsWrong) {
  expect_read_error("a.stl", "", "a.stl: 0 bytes are no STL");
  expect_read_error("a.stl", std::string(83, '\0'), "a.stl: 83 bytes are no STL");
  const std::string whole = binary_stl(kTwoFacets);
  for (std::size_t size = 84; size < whole.size(); ++size)
    expect_read_error("a.stl", whole.substr(0, size), "a.stl: byte 80: the header announces 2 facets");
  std::string absurd = whole;
  absurd.replace(80, 4, "\xff\xff\xff\xff");
  expect_read_error("a.stl", absurd,
                    "the header announces 4294967295 facets, which make a file of 214748364834 bytes");
  std::vector<std::array<Corner, 3>> facets = kTwoFacets;
  facets[1][2][0] = INFINITY;
  expect_read_error("a.stl", binary_stl(facets), "a.stl: byte 170: a coordinate is not a finite number");
}

TEST(StlReader, NamesTheLineOfTextThatIsWrong) {
  const std::string facet = text_facet("0 0 0", "1 0 0", "0 1 0");
  expect_read_error("a.stl", "solid a\n" + facet, "a.stl:8: the file ends too early: endsolid is missing");
  expect_read_error("a.stl", "solid a\n" + facet.substr(0, 60),
                    "a.stl:5: the file ends too early: vertex is");
  expect_read_error("a.stl", "solid a\nfacet normal 0 0 1\nouter loop\n",
                    "a.stl:3: the file ends too early: vertex");
  expect_read_error("a.stl", "solid a\nfacets\n",
                    "a.stl:2: facet, solid or endsolid is expected, not \"facets\"");
  expect_read_error("a.stl", "solid a\n" + text_facet("0 0", "1 0 0", "0 1 0"),
                    "a.stl:4: a coordinate is missing");
  expect_read_error("a.stl", "solid a\n" + text_facet("0 0 x", "1 0 0", "0 1 0"),
                    "a.stl:4: a coordinate is expected, not \"x\"");
  expect_read_error("a.stl", "solid a\n" + text_facet("0 0 0", "1 nan 0", "0 1 0"),
                    "a.stl:5: a coordinate is not a finite number");
  expect_read_error("a.stl", "solid a\n" + text_facet("0 0 0", "1 0 0", "0 1 0\nvertex 0 0 0"),
                    "a.stl:7: endloop is expected, not \"vertex\"");
}

Mesh one_quad(double z_of_first) {
  const std::vector<FaceCorners> faces = {{VertexId(0U), VertexId(1U), VertexId(2U), VertexId(3U)}};
  return build_mesh({0, 3, 4, 1}, {0, 0, 1, 1}, {z_of_first, 0, 0, 0}, faces);
}

TEST(StlWriter, CutsQuadsAlongTheShorterDiagonal) {
  const TemporaryFolder folder;
  write_mesh(folder.file("a.stl"), one_quad(0.5), {});
  const ReadCells cells = read_cells(folder.file("a.stl"));
  EXPECT_EQ(cells.x, (std::vector<double>{0, 3, 1, 4}));
  ASSERT_EQ(cells.faces.size(), 2U);
  EXPECT_EQ(cells.faces[0], (FaceCorners{VertexId(0U), VertexId(1U), VertexId(2U), VertexId()}));
  EXPECT_EQ(cells.faces[1], (FaceCorners{VertexId(1U), VertexId(3U), VertexId(2U), VertexId()}));
  EXPECT_EQ(file_content(folder.file("a.stl")).size(), kStlHeaderBytes + 2 * kStlFacetBytes);
}

TEST(StlWriter, RefusesWhatSinglePrecisionCannotHold) {
  const TemporaryFolder folder;
  const std::vector<FaceCorners> faces = {{VertexId(0U), VertexId(1U), VertexId(2U), VertexId()}};
  for (const double step : {0.01, 1e300}) {
    const Mesh mesh = build_mesh({6.7e6, 6.7e6 + step, 6.7e6}, {0, 0, step}, {0, 0, 1}, faces);
    try {
      write_mesh(folder.file("a.stl"), mesh, {});
      ADD_FAILURE() << "no error";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kOutput);
      EXPECT_NE(error.message().find("single precision"), std::string::npos) << error.message();
    }
  }
  EXPECT_EQ(folder.entries(), 0);
}

}  // namespace
}  // namespace quarry
