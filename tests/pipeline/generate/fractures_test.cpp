// Networks have the statistics that are asked for, and the same bytes whatever draws them.
#include "pipeline/generate/fractures.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "engine/parallel/parallel.hpp"
#include "io/lines/line_reader.hpp"
#include "pipeline/section/section.hpp"
#include "tests/io/mesh/temporary_folder.hpp"

namespace quarry {
namespace {

double measured_length(const GeneratedModel& model) {
  double sum = 0;
  for (const InputLine& line : model.lines.lines)
    for (std::size_t i = 1; i < line.points.size(); ++i) sum += distance(line.points[i - 1], line.points[i]);
  return sum;
}

std::string written(const GeneratedModel& model) {
  const TemporaryFolder folder;
  write_model(folder.file("model.geojson"), model);
  return file_content(folder.file("model.geojson"));
}

void expect_usage_error(const FractureOptions& options, const std::string& word) {
  try {
    static_cast<void>(generate_fractures(options, {}));
    ADD_FAILURE() << "no error: " << word;
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kUsage);
    EXPECT_NE(error.message().find(word), std::string::npos) << error.message();
  }
}

TEST(GeneratedFractures, AreAsManyAsIsAsked) {
  for (const bool curved : {false, true}) {
    FractureOptions options;
    options.count = 3000;
    options.curved = curved;
    const GeneratedModel model = generate_fractures(options, {});
    std::set<std::uint32_t> numbers;
    for (const LineLabel& label : model.labels) numbers.insert(label.number);
    EXPECT_EQ(numbers.size(), 3000U);
    EXPECT_EQ(*numbers.rbegin(), 2999U);
    for (const InputLine& line : model.lines.lines)
      for (const Vec2 point : line.points) EXPECT_TRUE(options.box.contains(point));
    EXPECT_NEAR(model.total_length, measured_length(model), 1e-9 * model.total_length);
  }
}

TEST(GeneratedFractures, HaveTheIntensityThatIsAsked) {
  for (const double intensity : {0.02, 0.2}) {
    FractureOptions options;
    options.box = {{4e5, 6e6}, {4e5 + 300, 6e6 + 2000}};
    options.intensity = intensity;
    options.curved = true;
    const GeneratedModel model = generate_fractures(options, {});
    // To within half of the longest fracture.
    EXPECT_NEAR(measured_length(model) / (300.0 * 2000), intensity, 75 / (300.0 * 2000));
  }
}

TEST(GeneratedFractures, AreAsDenseBesideTheSidesAsElsewhere) {
  FractureOptions options;
  options.intensity = 0.5;
  options.longest = 1500;
  options.exponent = 1.5;
  options.sets = {{0, 0, 1}};
  // The length in a frame that has the same area as the rest.
  const Box2 inner = options.box.grown(-500 * (1 - std::numbers::sqrt2 / 2));
  double beside = 0, all = 0;
  for (options.seed = 0; options.seed < 20; ++options.seed) {
    const GeneratedModel model = generate_fractures(options, {});
    all += model.total_length;
    for (const InputLine& line : model.lines.lines) {
      const Vec2 a = line.points.front(), b = line.points.back();
      constexpr int kSteps = 50;
      for (int i = 0; i < kSteps; ++i)
        if (!inner.contains(a + ((i + 0.5) / kSteps) * (b - a))) beside += distance(a, b) / kSteps;
    }
  }
  EXPECT_NEAR(beside / all, 0.5, 0.01);
}

TEST(GeneratedFractures, FollowTheirSets) {
  FractureOptions options;
  options.count = 20000;
  options.sets = {{20, 200, 3}, {110, 50, 1}};
  const GeneratedModel model = generate_fractures(options, {});
  std::map<std::uint32_t, double> count, offset, square;
  for (const LineId id : IdRange<LineId>(model.lines.lines.size())) {
    const std::uint32_t set = model.labels[id.value()].set;
    const Vec2 along = model.lines.lines[id].points.back() - model.lines.lines[id].points.front();
    double turn = std::atan2(along.y, along.x) * 180 / std::numbers::pi - options.sets[set].degrees;
    turn -= 180 * std::round(turn / 180);
    ++count[set];
    offset[set] += turn;
    square[set] += turn * turn;
  }
  EXPECT_NEAR(count[0] / (count[0] + count[1]), 0.75, 0.02);
  for (const std::uint32_t set : {0U, 1U}) {
    const double deviation = std::sqrt(square[set] / count[set]);
    EXPECT_NEAR(offset[set] / count[set], 0, 5 * deviation / std::sqrt(count[set])) << set;
    EXPECT_NEAR(deviation, 180 / std::numbers::pi / std::sqrt(options.sets[set].kappa), 0.3) << set;
  }
}

TEST(GeneratedFractures, HaveTheSameBytesOnAnyNumberOfThreads) {
  FractureOptions options;
  options.count = 30000;
  options.curved = true;
  std::string one;
  parallel::with_threads(1, [&] { one = written(generate_fractures(options, {})); });
  for (const int threads : {2, 4, 7})
    parallel::with_threads(threads,
                           [&] { EXPECT_TRUE(written(generate_fractures(options, {})) == one) << threads; });
}

TEST(GeneratedFractures, HaveTheBytesThatAreWrittenDownHere) {
  FractureOptions options;
  options.box = {{100, 0}, {110, 10}};
  options.count = 2;
  options.shortest = 2;
  options.curved = true;
  options.outline = true;
  options.seed = 5;
  EXPECT_EQ(written(generate_fractures(options, {})),
            R"({"type":"FeatureCollection","features":[
{"type":"Feature","properties":{"kind":"outline"},"geometry":{"type":"Polygon","coordinates":[[[100,0],[110,0],[110,10],[100,10],[100,0]]]}},
{"type":"Feature","properties":{"kind":"fracture","number":0,"set":0},"geometry":{"type":"LineString","coordinates":[[100,7.678608],[100.475273,8.109489],[101.315012,8.82183],[102.183033,9.499422],[102.86877,10]]}},
{"type":"Feature","properties":{"kind":"fracture","number":1,"set":1},"geometry":{"type":"LineString","coordinates":[[106.732035,5.558245],[105.901533,6.598956],[105.115462,7.67362],[104.22732,8.665596]]}}
]}
)");
}

TEST(GeneratedFractures, ReadBackAsTheyWereDrawn) {
  FractureOptions options;
  options.count = 500;
  options.curved = true;
  options.outline = true;
  const GeneratedModel model = generate_fractures(options, {});
  const TemporaryFolder folder;
  write_model(folder.file("model.geojson"), model);
  const LineSet back = read_lines({folder.file("model.geojson")});
  ASSERT_EQ(back.lines.size(), model.lines.lines.size());
  for (const LineId id : IdRange<LineId>(back.lines.size())) {
    EXPECT_EQ(back.lines[id].points, model.lines.lines[id].points);
    EXPECT_EQ(back.lines[id].polygon_ring, model.lines.lines[id].polygon_ring);
  }
}

TEST(GeneratedFractures, DifferWithTheSeed) {
  FractureOptions options;
  options.count = 50;
  const GeneratedModel first = generate_fractures(options, {});
  options.seed = 1;
  EXPECT_NE(first.lines.lines.raw().front().points,
            generate_fractures(options, {}).lines.lines.raw().front().points);
}

TEST(GeneratedFractures, RefuseWhatMakesNoSense) {
  const auto expect = [](auto&& change, const std::string& word) {
    FractureOptions options;
    options.count = 10;
    change(options);
    expect_usage_error(options, word);
  };
  const double nan = std::nan("");
  expect([](auto& o) { o.intensity = 1; }, "--p21");
  expect([](auto& o) { o.count.reset(); }, "--count");
  expect([](auto& o) { o.count = 0; }, "--count");
  expect([&](auto& o) { o.count.reset(), o.intensity = nan; }, "--p21");
  expect([](auto& o) { o.box.high.x = o.box.low.x; }, "--box");
  expect([&](auto& o) { o.box.high.x = nan; }, "--box");
  expect([&](auto& o) { o.exponent = nan; }, "--exponent");
  expect([](auto& o) { o.shortest = -1; }, "--lmin");
  expect([](auto& o) { o.shortest = 20, o.longest = 10; }, "--lmin");
  expect([](auto& o) { o.longest = 1e5; }, "--lmax");
  expect([](auto& o) { o.sets.clear(); }, "set");
  expect([](auto& o) { o.sets = {{0, -1, 1}}; }, "--set");
  expect([](auto& o) { o.sets = {{0, 1, 0}}; }, "--set");
  expect([&](auto& o) { o.sets = {{nan, 1, 1}}; }, "--set");
}

TEST(GeneratedFractures, RefuseMoreThanCanBeHeld) {
  FractureOptions options;
  options.intensity = 1e9;
  options.shortest = 1;
  try {
    static_cast<void>(generate_fractures(options, {}));
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kBudget);
  }
}

TEST(GeneratedFractures, EndWhereNearlyAllMissTheBox) {
  FractureOptions options;
  options.box = {{0, 0}, {1000, 1e-3}};
  options.sets = {{0, 1e8, 1}};
  options.count = 100000;
  options.shortest = 5000;
  options.longest = 10000;
  EXPECT_THROW(static_cast<void>(generate_fractures(options, {})), Error);
}

TEST(GeneratedFractures, AreMeshed) {
  const TemporaryFolder folder;
  for (const bool curved : {false, true}) {
    FractureOptions fractures;
    fractures.count = 200;
    fractures.curved = curved;
    write_model(folder.file("model.geojson"), generate_fractures(fractures, {}));
    SectionOptions options;
    options.inputs = {folder.file("model.geojson")};
    options.size = 20;
    const SectionResult result = mesh_section(options, {});
    EXPECT_GT(result.mesh.count_alive_faces(), 1000U);
  }
}

}  // namespace
}  // namespace quarry
