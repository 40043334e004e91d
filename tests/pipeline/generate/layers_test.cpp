// Sections hang together: horizons end on faults, which offset them by their throw.
#include "pipeline/generate/layers.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "pipeline/section/section.hpp"
#include "tests/io/mesh/temporary_folder.hpp"

namespace quarry {
namespace {

using Point = std::pair<double, double>;

std::set<Point> vertices_of(const GeneratedModel& model, LineLabel::Kind kind) {
  std::set<Point> points;
  for (const LineId id : IdRange<LineId>(model.lines.lines.size()))
    if (model.labels[id.value()].kind == kind)
      for (const Vec2 p : model.lines.lines[id].points) points.emplace(p.x, p.y);
  return points;
}

bool on_side(const Box2& box, Vec2 p) {
  return p.x == box.low.x || p.x == box.high.x || p.y == box.low.y || p.y == box.high.y;
}

TEST(GeneratedLayers, HorizonsEndOnTheSidesOrInVerticesOfFaults) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    LayerOptions options;
    options.seed = seed;
    options.faults = 6;
    const GeneratedModel model = generate_layers(options, {});
    const std::set<Point> faults = vertices_of(model, LineLabel::Kind::kFault);
    std::size_t on_faults = 0;
    for (const LineId id : IdRange<LineId>(model.lines.lines.size())) {
      if (model.labels[id.value()].kind != LineLabel::Kind::kHorizon) continue;
      const std::vector<Vec2>& points = model.lines.lines[id].points;
      for (const Vec2 end : {points.front(), points.back()}) {
        if (on_side(options.box, end)) continue;
        EXPECT_TRUE(faults.contains({end.x, end.y})) << "seed " << seed << ": " << end.x << " " << end.y;
        ++on_faults;
      }
    }
    EXPECT_GT(on_faults, 20U) << "seed " << seed;
  }
}

TEST(GeneratedLayers, FaultsEndOnTheSidesOrInVerticesOfYoungerFaults) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    LayerOptions options;
    options.seed = seed;
    options.faults = 8;
    options.dip = 45;
    const GeneratedModel model = generate_layers(options, {});
    std::map<std::uint32_t, std::set<Point>> vertices;
    for (const LineId id : IdRange<LineId>(model.lines.lines.size()))
      if (model.labels[id.value()].kind == LineLabel::Kind::kFault)
        for (const Vec2 p : model.lines.lines[id].points)
          vertices[model.labels[id.value()].number].emplace(p.x, p.y);
    for (const LineId id : IdRange<LineId>(model.lines.lines.size())) {
      const LineLabel label = model.labels[id.value()];
      if (label.kind != LineLabel::Kind::kFault) continue;
      const std::vector<Vec2>& points = model.lines.lines[id].points;
      for (const Vec2 end : {points.front(), points.back()}) {
        bool held = on_side(options.box, end);
        for (std::uint32_t younger = label.number + 1; younger < 8; ++younger)
          held = held || vertices[younger].contains({end.x, end.y});
        EXPECT_TRUE(held) << "seed " << seed << ", fault " << label.number;
      }
    }
  }
}

TEST(GeneratedLayers, AFaultOffsetsALevelHorizonByItsThrow) {
  for (const double offset : {40.0, -40.0}) {
    LayerOptions options;
    options.horizons = 1;
    options.folds = 0;
    options.faults = 1;
    options.mean_throw = offset;
    const GeneratedModel model = generate_layers(options, {});
    ASSERT_EQ(model.lines.lines.size(), 3U);
    const std::vector<Vec2>& left = model.lines.lines[LineId(std::size_t{0})].points;
    const std::vector<Vec2>& right = model.lines.lines[LineId(std::size_t{1})].points;
    const double drop = std::abs(left.back().y - right.front().y);
    EXPECT_GE(drop, 20);
    EXPECT_LE(drop, 60);
    // Normal faults pull the parts asunder, reverse faults push one over the other.
    EXPECT_EQ(right.front().x > left.back().x, offset > 0);
  }
}

TEST(GeneratedLayers, HorizonsDoNotCross) {
  LayerOptions options;
  options.faults = 0;
  options.horizons = 20;
  options.amplitude = 300;
  options.folds = 5;
  const GeneratedModel model = generate_layers(options, {});
  std::map<double, std::map<std::uint32_t, double>> heights;
  for (const LineId id : IdRange<LineId>(model.lines.lines.size()))
    for (const Vec2 p : model.lines.lines[id].points)
      if (!on_side(options.box, p)) heights[p.x][model.labels[id.value()].number] = p.y;
  for (const auto& [x, column] : heights) {
    double below = -1;
    for (const auto& [number, y] : column) {
      EXPECT_GT(y, below) << "horizon " << number << " at " << x;
      below = y;
    }
  }
}

TEST(GeneratedLayers, AreTheSameForTheSameSeed) {
  LayerOptions options;
  const GeneratedModel first = generate_layers(options, {}), again = generate_layers(options, {});
  ASSERT_EQ(first.lines.lines.size(), again.lines.lines.size());
  for (const LineId id : IdRange<LineId>(first.lines.lines.size()))
    EXPECT_EQ(first.lines.lines[id].points, again.lines.lines[id].points);
  options.seed = 1;
  EXPECT_NE(generate_layers(options, {}).lines.lines.raw().front().points,
            first.lines.lines.raw().front().points);
}

TEST(GeneratedLayers, RefuseWhatMakesNoSense) {
  const auto expect = [](auto&& change, const std::string& word, ErrorKind kind = ErrorKind::kUsage) {
    LayerOptions options;
    change(options);
    try {
      static_cast<void>(generate_layers(options, {}));
      ADD_FAILURE() << "no error: " << word;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), kind);
      EXPECT_NE(error.message().find(word), std::string::npos) << error.message();
    }
  };
  const double nan = std::nan("");
  expect([](auto& o) { o.horizons = o.faults = 0; }, "--horizons");
  expect([](auto& o) { o.faults = 5000; }, "--faults");
  expect([](auto& o) { o.dip = 3; }, "--dip");
  expect([&](auto& o) { o.dip = nan; }, "--dip");
  expect([&](auto& o) { o.amplitude = nan; }, "--amplitude");
  expect([](auto& o) { o.amplitude = -1; }, "--amplitude");
  expect([](auto& o) { o.mean_throw = 1e9; }, "--throw");
  expect([](auto& o) { o.step = 0; }, "--step");
  expect([](auto& o) { o.step = 1e-9; }, "--step", ErrorKind::kBudget);
  expect([](auto& o) { o.box.high.y = -1; }, "--box");
}

TEST(GeneratedLayers, AreMeshed) {
  const TemporaryFolder folder;
  LayerOptions layers;
  layers.faults = 5;
  layers.outline = true;
  write_model(folder.file("model.geojson"), generate_layers(layers, {}));
  SectionOptions options;
  options.inputs = {folder.file("model.geojson")};
  options.size = 15;
  EXPECT_GT(mesh_section(options, {}).mesh.count_alive_faces(), 1000U);
}

}  // namespace
}  // namespace quarry
