#include <cmath>

#include "tests/io/mesh/byte_text.hpp"
#include "tests/io/mesh/read_error.hpp"

namespace quarry {
namespace {

// Other elements, other properties, lists among them, and the face's list between two numbers.
constexpr const char* kHeaderOfAllSorts =
    "comment made by hand\nobj_info none\n"
    "element vertex 5\nproperty double x\nproperty list uchar short marks\nproperty float y\n"
    "property int16 z\nproperty uchar red\n"
    "element camera 2\nproperty float view\nproperty list uint32 double matrix\n"
    "element face 2\nproperty uchar flags\nproperty list int8 uint vertex_index\nproperty int region\n"
    "element edge 1\nproperty int vertex1\nproperty int vertex2\nproperty short constraint\n"
    "element nothing 4000000000\nend_header\n";

void expect_all_sorts(const ReadCells& cells) {
  EXPECT_EQ(cells.x, (std::vector<double>{0, 1, 1, 0, 2.1}));
  EXPECT_EQ(cells.y, (std::vector<double>{0, 0, 1, 1, 0.5}));
  EXPECT_EQ(cells.z, (std::vector<double>{0, 0, 0, -7, 0}));
  ASSERT_EQ(cells.faces.size(), 2U);
  EXPECT_EQ(cells.faces[0], (FaceCorners{VertexId(0U), VertexId(1U), VertexId(2U), VertexId(3U)}));
  EXPECT_EQ(cells.faces[1], (FaceCorners{VertexId(1U), VertexId(4U), VertexId(2U), VertexId()}));
  EXPECT_EQ(cells.regions, (std::vector<std::int32_t>{4, -1}));
  ASSERT_EQ(cells.edges.size(), 1U);
  EXPECT_EQ(cells.edges[0], std::pair(VertexId(3U), VertexId(0U)));
  EXPECT_EQ(cells.constraints, (std::vector<std::int32_t>{9}));
  EXPECT_TRUE(cells.kinds.empty());
}

TEST(PlyReader, ReadsText) {
  expect_all_sorts(
      read_text_as("a.ply", std::string("ply\nformat ascii 1.0\n") + kHeaderOfAllSorts +
                                "0 0 0 0 255\n1 2 5 -5 0 0 255\n1 0 1 0 0\n\n0 0 1 -7 9\n2.1 1 300 0.5 0 1\n"
                                "1.5 3 nan nan nan\n0 0\n1 4 0 1 2 3 4\n2 3 1 4 2 -1\r\n3 0 9\n"));
}

std::string binary_of_all_sorts(std::endian order) {
  using U8 = std::uint8_t;
  using I16 = std::int16_t;
  using I8 = std::int8_t;
  ByteText bytes(order);
  bytes.add(0.0, U8{0}, 0.0F, I16{0}, U8{255});
  bytes.add(1.0, U8{2}, I16{5}, I16{-5}, 0.0F, I16{0}, U8{255});
  bytes.add(1.0, U8{0}, 1.0F, I16{0}, U8{0});
  bytes.add(0.0, U8{0}, 1.0F, I16{-7}, U8{9});
  bytes.add(2.1, U8{1}, I16{300}, 0.5F, I16{0}, U8{1});
  bytes.add(1.5F, 3U, 1.0, 2.0, 3.0, 0.0F, 0U);
  bytes.add(U8{1}, I8{4}, 0U, 1U, 2U, 3U, 4);
  bytes.add(U8{2}, I8{3}, 1U, 4U, 2U, -1);
  bytes.add(3, 0, I16{9});
  const bool little = order == std::endian::little;
  return std::string("ply\nformat binary_") + (little ? "little" : "big") + "_endian 1.0\n" +
         kHeaderOfAllSorts + bytes.text();
}

TEST(PlyReader, ReadsBinaryInEitherOrderOfBytes) {
  expect_all_sorts(read_text_as("a.ply", binary_of_all_sorts(std::endian::little)));
  expect_all_sorts(read_text_as("a.PLY", binary_of_all_sorts(std::endian::big)));
}

TEST(PlyReader, RefusesABodyThatIsCutAnywhere) {
  const TemporaryFolder folder;
  const std::string whole = binary_of_all_sorts(std::endian::little);
  const std::size_t body = whole.find("end_header\n") + 11;
  for (std::size_t size = 0; size < whole.size(); ++size) {
    try {
      static_cast<void>(read_cells(folder.file("a.ply", whole.substr(0, size))));
      ADD_FAILURE() << size << " of " << whole.size() << " bytes are taken for a whole file";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kInput);
      if (size >= body) {
        EXPECT_NE(error.message().find("the file ends too early"), std::string::npos) << error.message();
      }
    }
  }
}

std::string ply(const std::string& format, const std::string& faces, const std::string& body) {
  return "ply\nformat " + format +
         " 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face " +
         faces + "\nproperty list uchar int vertex_indices\nend_header\n" + body;
}

TEST(PlyReader, NamesTheLineOfAHeaderThatIsWrong) {
  expect_read_error("a.ply", "", "a.ply:1: the file ends too early");
  expect_read_error("a.ply", "plx\n", "a.ply:1: the file does not start with \"ply\"");
  expect_read_error("a.ply", std::string("\0\0\0", 3), "a.ply:1: the file does not start with \"ply\"");
  expect_read_error("a.ply", "ply\nformat ebcdic 1.0\n", "a.ply:2: ascii, binary_little_endian or");
  expect_read_error("a.ply", "ply\nformat ascii 2.0\n", "a.ply:2: version 2.0 is not known");
  expect_read_error("a.ply", "ply\nformat ascii 1.0 x\n", "a.ply:2: the line should end before \"x\"");
  expect_read_error("a.ply", "ply\nend_header\n", "a.ply:2: the header has no format");
  expect_read_error("a.ply", "ply\nformat ascii 1.0\nelements\n", "a.ply:3: \"elements\" is no key");
  expect_read_error("a.ply", "ply\nformat ascii 1.0\nelement vertex -3\n",
                    "a.ply:3: element vertex has -3 rows");
  expect_read_error("a.ply", "ply\nformat ascii 1.0\nelement vertex\n1\n",
                    "a.ply:3: a number of rows is missing");
  expect_read_error("a.ply", "ply\nformat ascii 1.0\nproperty int x\n", "a.ply:3: a property stands before");
  const std::string vertex = "ply\nformat ascii 1.0\nelement vertex 1\n";
  expect_read_error("a.ply", vertex + "property real x\n", "a.ply:4: \"real\" is no type");
  expect_read_error("a.ply", vertex + "property list float int x\n", "a.ply:4: the length of a list is no");
  expect_read_error("a.ply", vertex + "property int x\nproperty int x\n", "a.ply:5: property x stands twice");
  expect_read_error("a.ply", vertex + "element vertex 1\n", "a.ply:4: element vertex stands twice");
  expect_read_error("a.ply", vertex + "property int x\n", "a.ply:4: the file ends too early");
  expect_read_error("a.ply", vertex + "property int x\nend_header\n1\n",
                    "element vertex of the header needs");
  expect_read_error("a.ply", "ply\nformat ascii 1.0\nend_header\n", "the header has no element vertex");
}

TEST(PlyReader, RefusesFacesThatItWouldMiss) {
  const std::string vertex = "ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nproperty int y\n";
  expect_read_error("a.ply",
                    vertex + "element face 1\nproperty list uchar float vertex_indices\nend_header\n",
                    "element face of the header needs a list vertex_indices");
  expect_read_error(
      "a.ply",
      vertex + "element tristrips 1\nproperty list int int vertex_indices\nend_header\n0 0\n3 0 0 0\n",
      "the faces are tristrips, which are not read");
}

TEST(PlyReader, NamesTheLineOfTextThatIsWrong) {
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
  expect_read_error("a.ply", ply("ascii", "1", points),
                    "a.ply:12: the file ends too early: 1 rows of element face");
  expect_read_error("a.ply", ply("ascii", "1", points + "3 0 1 3\n"), "a.ply:13: point 3 does not exist");
  expect_read_error("a.ply", ply("ascii", "1", points + "5 0 1 2 0 1\n"), "a.ply:13: a face has more than 4");
  expect_read_error("a.ply", ply("ascii", "1", points + "3 0 1\n"),
                    "a.ply:13: the number of a point is missing");
  expect_read_error("a.ply", ply("ascii", "1", points + "3 0 1 2 7\n"),
                    "a.ply:13: the line holds more values");
  expect_read_error("a.ply", ply("ascii", "1", points + "3 0 1 2\n3 0 1 2\n"), "a.ply:14: more lines follow");
  expect_read_error("a.ply", ply("ascii", "0", "0 0 0\n1 inf 0\n0 1 0\n"),
                    "a.ply:11: a coordinate is not a finite");
  expect_read_error("a.ply", ply("ascii", "0", "0 0 0\n1 0\n0 1 0\n"), "a.ply:11: a coordinate is missing");
  expect_read_error("a.ply", ply("ascii", "4000000000", points),
                    "4000000000 rows of element face are announced");
}

TEST(PlyReader, NamesTheByteOfBinaryThatIsWrong) {
  const auto file = [](const std::string& faces, float y, std::uint8_t corners, std::int32_t last) {
    ByteText bytes(std::endian::little);
    bytes.add(0.0F, 0.0F, 0.0F, 1.0F, y, 0.0F, 0.0F, 1.0F, 0.0F, corners, 0, 1, last);
    return ply("binary_little_endian", faces, bytes.text());
  };
  const std::size_t body = file("1", 0, 3, 2).size() - 49;
  const auto at = [&](std::size_t byte) { return "a.ply: byte " + std::to_string(body + byte) + ": "; };
  EXPECT_EQ(read_text_as("a.ply", file("1", 0, 3, 2) + "\n").faces.size(), 1U);
  expect_read_error("a.ply", file("1", 0, 3, 3), at(45) + "point 3 does not exist; there are 3 points");
  expect_read_error("a.ply", file("1", 0, 3, -1), at(45) + "point -1 does not exist");
  expect_read_error("a.ply", file("1", NAN, 3, 2), at(16) + "a coordinate is not a finite number");
  expect_read_error("a.ply", file("1", 0, 3, 2) + "x", at(49) + "1 bytes follow after");
  expect_read_error("a.ply", file("1", 0, 4, 2), at(49) + "the file ends too early");
  expect_read_error("a.ply", file("1", 0, 2, 2), at(36) + "a face has 2 corners");
  const std::string body_of_five = file("1", 0, 5, 2) + std::string(8, '\0');
  expect_read_error("a.ply", body_of_five, at(36) + "a face has more than 4 corners");
}

TEST(PlyReader, AsksForNoMemoryOnTheWordOfACount) {
  expect_read_error("a.ply", ply("binary_little_endian", "4000000000", std::string(49, '\0')),
                    "4000000000 rows of element face are announced");
  expect_read_error("a.ply", ply("binary_big_endian", "9223372036854775807", std::string(49, '\0')),
                    "9223372036854775807 rows of element face are announced");
  // A list of 4e9 values in a face's row.
  expect_read_error("a.ply",
                    "ply\nformat binary_little_endian 1.0\nelement vertex 0\nproperty int x\nproperty int y\n"
                    "element face 1\nproperty list uint int vertex_indices\nend_header\n\xff\xff\xff\xff",
                    "the file ends too early");
}

}  // namespace
}  // namespace quarry
