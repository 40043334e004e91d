#include "io/lines/geojson_writer.hpp"

#include <filesystem>

#include <gtest/gtest.h>
#include <unistd.h>

#include "io/lines/line_reader.hpp"

namespace quarry {
namespace {

NodedLines make_lines(std::vector<Vec2> nodes,
                      const std::vector<std::pair<std::uint32_t, std::uint32_t>>& pieces,
                      const std::vector<std::vector<std::uint32_t>>& numbers) {
  NodedLines lines;
  lines.nodes = IdVector<NodeId, Vec2>(std::move(nodes));
  for (const auto& [from, to] : pieces) lines.pieces.push_back({NodeId(from), NodeId(to)});
  lines.line_begin.push_back(0);
  for (const auto& row : numbers) {
    for (const std::uint32_t number : row) lines.line_numbers.push_back(LineId(number));
    lines.line_begin.push_back(static_cast<std::uint32_t>(lines.line_numbers.size()));
  }
  return lines;
}

LineSet written_and_read(const NodedLines& lines) {
  std::string name = (std::filesystem::temp_directory_path() / "quarry_lines_XXXXXX").string();
  const std::filesystem::path folder = mkdtemp(name.data());
  const std::string path = (folder / "out.geojson").string();
  write_lines_geojson(path, lines);
  LineSet read = read_lines({path});
  std::filesystem::remove_all(folder);
  return read;
}

TEST(GeojsonWriter, JoinsPiecesOfTheSameLineIntoOneChainWithTheSameBits) {
  const double third = 6'691'599.0 + 1.0 / 3.0;
  const LineSet read =
      written_and_read(make_lines({{0.1, third}, {1, 0}, {2, 0}}, {{1, 2}, {0, 1}}, {{4}, {4}}));
  ASSERT_EQ(read.lines.size(), 1U);
  EXPECT_EQ(read.lines[LineId(0U)].points, (std::vector<Vec2>{{0.1, third}, {1, 0}, {2, 0}}));
}

TEST(GeojsonWriter, BreaksChainsAtJunctionsAndWhereNumbersChange) {
  EXPECT_EQ(
      written_and_read(make_lines({{0, 0}, {1, 0}, {2, 0}}, {{0, 1}, {1, 2}}, {{0}, {0, 1}})).lines.size(),
      2U);
  EXPECT_EQ(written_and_read(
                make_lines({{0, 0}, {1, 0}, {2, 0}, {1, 1}}, {{0, 1}, {1, 2}, {1, 3}}, {{0}, {0}, {0}}))
                .lines.size(),
            3U);
}

TEST(GeojsonWriter, WritesAClosedChainAsAClosedLine) {
  const LineSet read =
      written_and_read(make_lines({{0, 0}, {1, 0}, {0, 1}}, {{0, 1}, {1, 2}, {2, 0}}, {{0}, {0}, {0}}));
  ASSERT_EQ(read.lines.size(), 1U);
  EXPECT_TRUE(read.lines[LineId(0U)].closed());
  EXPECT_EQ(read.lines[LineId(0U)].points.size(), 4U);
}

}  // namespace
}  // namespace quarry
