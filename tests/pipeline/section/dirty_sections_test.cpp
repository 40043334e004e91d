// Dirty line sets and points, from the file to the mesh (RC_PARAMS="max_success=1000", as ./run fuzz has it;
// fewer by default): a valid mesh of quads with every line and point in it, or an error that says why not.
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "engine/base/error.hpp"
#include "engine/mesh/validate.hpp"
#include "pipeline/section/section.hpp"
#include "tests/kernels/linework/dirty_sets.hpp"
#include "tests/support/geojson_text.hpp"

namespace quarry {
namespace {

constexpr int kMostPoints = 20;

// Of the ends of lines, and a little beside them.
std::string points_text(const LineSet& raw, const DirtySet& set) {
  Dice dice(set.seed + 1);
  std::string text = R"({"type":"Feature","properties":{},"geometry":{"type":"MultiPoint","coordinates":[)";
  const int count = static_cast<int>(dice(0, kMostPoints));
  for (int i = 0; i < count; ++i) {
    const auto line = static_cast<std::size_t>(dice(0, static_cast<double>(raw.lines.size())));
    const double beside = std::pow(10, set.scale) * std::pow(10, dice(-9, -1));
    const Vec2 p = raw.lines[LineId(line)].points.front() + Vec2{beside, -beside};
    text += fmt::format("{}[{}, {}]", i == 0 ? "" : ",", p.x, p.y);
  }
  return text + "]}}";
}

std::string write_set(const DirtySet& set) {
  const LineSet raw = DirtyLines(set).draw();
  std::vector<Polyline> lines;
  for (const InputLine& line : raw.lines) lines.push_back(line.points);
  std::string text = geojson_text(lines);
  text.insert(text.size() - 2, "," + points_text(raw, set));
  const std::string path =
      (std::filesystem::temp_directory_path() / fmt::format("quarry_dirty_{}.geojson", ::getpid())).string();
  std::ofstream(path) << text;
  return path;
}

// Nothing if all is well. That lines and points are kept is checked by the job itself.
std::string what_is_wrong(const DirtySet& set) {
  SectionOptions options;
  options.inputs = {write_set(set)};
  options.as_is = true;
  // A tenth to a fiftieth of the box.
  options.size = std::pow(10, set.scale) / (10 + static_cast<double>(set.seed % 41));
  std::string wrong;
  try {
    const SectionResult result = mesh_section(options, Progress());
    wrong = validate(result.mesh, GeometryCheck::kPlanarCorners);
    for (const FaceId f : result.mesh.faces())
      if (result.mesh.corner_count(f) != 4) wrong = "a face is no quad";
  } catch (const Error& error) {
    const bool reasoned = error.kind() == ErrorKind::kInput || error.kind() == ErrorKind::kGeometry;
    if (!reasoned) wrong = error.message();
  }
  std::filesystem::remove(options.inputs[0]);
  return wrong;
}

TEST(DirtySections, EndInAMeshOrAReasonedError) { expect_all_right("seed=1 max_success=40", what_is_wrong); }

}  // namespace
}  // namespace quarry
