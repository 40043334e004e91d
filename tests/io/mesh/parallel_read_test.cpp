// Files that are read in parts at the same time: the same cells, and the same error, on any number of
// threads.
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "engine/base/random.hpp"
#include "engine/parallel/parallel.hpp"
#include "io/mesh/mesh_format.hpp"
#include "tests/io/mesh/byte_text.hpp"
#include "tests/io/mesh/temporary_folder.hpp"

namespace quarry {
namespace {

// A grid of points with triangles over it, in every format that is read in parts. From
// point `broken` on, a coordinate is not a finite number.
class GridFile {
 public:
  static constexpr std::uint32_t kSide = 200;

  explicit GridFile(std::uint32_t broken = 0xffffffff) {
    for (std::uint32_t i = 0; i < kSide * kSide; ++i) {
      const std::uint32_t column = i % kSide;
      const std::uint32_t row = i / kSide;
      points_.push_back(
          {column + uniform01(1, i), row + uniform01(2, i), i >= broken ? NAN : uniform01(3, i)});
    }
    for (std::uint32_t j = 0; j + 1 < kSide; ++j)
      for (std::uint32_t i = 0; i + 1 < kSide; ++i) {
        const std::uint32_t a = j * kSide + i;
        faces_.push_back({a, a + 1, a + kSide + 1});
        faces_.push_back({a, a + kSide + 1, a + kSide});
      }
  }

  [[nodiscard]] std::string obj() const {
    std::string text;
    for (const auto& p : points_) text += fmt::format("v {} {} {}\n", p[0], p[1], p[2]);
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      if (f % 5000 == 0) text += fmt::format("g layer_{}\ng line_{}\nl 1 2 3\n", f / 5000, f);
      text += fmt::format("f {}/1 {}/2 -{}/3\n", faces_[f][0] + 1, faces_[f][1] + 1,
                          points_.size() - faces_[f][2]);
    }
    return text;
  }
  [[nodiscard]] std::string off() const {
    return fmt::format("OFF\n{} {} 0\n", points_.size(), faces_.size()) + lines("# a comment\n\n");
  }
  [[nodiscard]] std::string text_ply() const { return ply_header("ascii") + lines("\n"); }
  [[nodiscard]] std::string binary_ply() const {
    ByteText bytes(std::endian::big);
    for (const auto& p : points_) bytes.add(p[0], p[1], p[2]);
    for (const auto& f : faces_) bytes.add(std::uint8_t{3}, f[0], f[1], f[2]);
    return ply_header("binary_big_endian") + bytes.text();
  }
  [[nodiscard]] std::string text_stl() const {
    std::string text = "solid a\n";
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      if (f % 7000 == 6999) text += fmt::format("endsolid\nsolid part {}\n", f);
      text += "facet normal 0 0 0\nouter loop\n";
      for (const std::uint32_t v : faces_[f])
        text += fmt::format("vertex {} {} {}\n", points_[v][0], points_[v][1], points_[v][2]);
      text += "endloop\nendfacet\n";
    }
    return text + "endsolid\n";
  }
  [[nodiscard]] std::string binary_stl() const {
    ByteText bytes(std::endian::little);
    bytes.add(static_cast<std::uint32_t>(faces_.size()));
    for (const auto& f : faces_) {
      bytes.add(0.0F, 0.0F, 0.0F);
      for (const std::uint32_t v : f)
        for (const double value : points_[v]) bytes.add(static_cast<float>(value));
      bytes.add(std::uint16_t{0});
    }
    return std::string(80, ' ') + bytes.text();
  }

 private:
  [[nodiscard]] std::string lines(const std::string& passed_over) const {
    std::string text;
    for (std::size_t i = 0; i < points_.size(); ++i)
      text += fmt::format("{}{} {} {}\n", i % 100 == 0 ? passed_over : "", points_[i][0], points_[i][1],
                          points_[i][2]);
    for (const auto& f : faces_) text += fmt::format("3 {} {} {}\n", f[0], f[1], f[2]);
    return text;
  }
  [[nodiscard]] std::string ply_header(const char* format) const {
    return fmt::format(
        "ply\nformat {} 1.0\nelement vertex {}\nproperty double x\nproperty double y\nproperty double z\n"
        "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
        format, points_.size(), faces_.size());
  }

  std::vector<std::array<double, 3>> points_;
  std::vector<std::array<std::uint32_t, 3>> faces_;
};

struct PartedFormat {
  const char* name;
  const char* file;
  std::string (GridFile::*content)() const;
};

void PrintTo(const PartedFormat& format, std::ostream* out) { *out << format.name; }

class PartedReading : public testing::TestWithParam<PartedFormat> {
 protected:
  [[nodiscard]] std::string write(const GridFile& grid) const {
    return folder_.file(GetParam().file, (grid.*GetParam().content)());
  }
  // The message, and "" where there is none.
  static std::string message_of(const std::string& path) {
    try {
      static_cast<void>(read_cells(path));
    } catch (const Error& error) {
      return error.message();
    }
    return "";
  }

  TemporaryFolder folder_;
};

void expect_same(const ReadCells& a, const ReadCells& b) {
  EXPECT_TRUE(a.x == b.x && a.y == b.y && a.z == b.z);
  EXPECT_TRUE(a.faces == b.faces);
  EXPECT_TRUE(a.regions == b.regions);
  EXPECT_TRUE(a.edges == b.edges);
  EXPECT_TRUE(a.constraints == b.constraints);
  EXPECT_TRUE(a.names.regions == b.names.regions);
  EXPECT_TRUE(a.names.lines == b.names.lines);
}

TEST_P(PartedReading, GivesTheSameOnAnyNumberOfThreads) {
  const std::string path = write(GridFile());
  ReadCells one;
  parallel::with_threads(1, [&] { one = read_cells(path); });
  EXPECT_EQ(one.x.size(), std::size_t{GridFile::kSide} * GridFile::kSide);
  EXPECT_EQ(one.faces.size(), 2U * (GridFile::kSide - 1) * (GridFile::kSide - 1));
  for (const int threads : {2, 4, 7}) {
    const parallel::ParticipationProbe probe;
    ReadCells cells;
    parallel::with_threads(threads, [&] { cells = read_cells(path); });
    expect_same(cells, one);
    EXPECT_GT(probe.chunks_of_other_threads(), 0U) << threads << " threads";
  }
}

TEST_P(PartedReading, TellsOfTheFirstErrorOnAnyNumberOfThreads) {
  const std::string path = write(GridFile(GridFile::kSide * GridFile::kSide / 3));
  std::string one;
  parallel::with_threads(1, [&] { one = message_of(path); });
  EXPECT_NE(one.find("a coordinate is not a finite number"), std::string::npos) << one;
  for (const int threads : {2, 7}) {
    const parallel::ParticipationProbe probe;
    parallel::with_threads(threads, [&] { EXPECT_EQ(message_of(path), one); });
  }
}

INSTANTIATE_TEST_SUITE_P(All, PartedReading,
                         testing::Values(PartedFormat{"Obj", "a.obj", &GridFile::obj},
                                         PartedFormat{"Off", "a.off", &GridFile::off},
                                         PartedFormat{"TextPly", "a.ply", &GridFile::text_ply},
                                         PartedFormat{"BinaryPly", "a.ply", &GridFile::binary_ply},
                                         PartedFormat{"TextStl", "a.stl", &GridFile::text_stl},
                                         PartedFormat{"BinaryStl", "a.stl", &GridFile::binary_stl}),
                         [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace quarry
