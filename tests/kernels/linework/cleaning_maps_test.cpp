// Real maps, as published by others; skipped where they are absent.
#include <filesystem>

#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "io/lines/line_reader.hpp"
#include "tests/kernels/linework/line_samples.hpp"

namespace quarry {
namespace {

const std::string kFolder = "../shared/data/";

struct Map {
  const char* lines;
  const char* boundary;
};

class CleaningMaps : public testing::TestWithParam<Map> {};

TEST_P(CleaningMaps, StaysWithinTheBudgetAndTellsOfEveryLine) {
  const std::string path = kFolder + GetParam().lines;
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is absent";
  const LineSet raw = read_lines({path});
  for (const double count : {150.0, 300.0, 600.0}) {
    const double size = raw.box().longer_side() / count;
    const CleanOptions options{0.05 * size, 0.1 * size, 0.05 * size};
    const std::string boundary = GetParam().boundary;
    const Outline outline = boundary.empty()
                                ? default_outline(raw, options.snap)
                                : boundary_outline(read_lines({kFolder + boundary}), options.snap);
    const CleanedLines result = clean_lines(raw, outline, options);
    expect_faithful(raw, result);
    EXPECT_EQ(result.counts.reroutes, 0U);
    EXPECT_LE(result.counts.short_pieces * 1000, result.lines.pieces.size());
  }
}

INSTANTIATE_TEST_SUITE_P(FiveMaps, CleaningMaps,
                         testing::Values(Map{"planar/kb11_traces.lines.geojson",
                                             "planar/kb11_area.lines.geojson"},
                                         Map{"planar/hastholmen_traces.lines.geojson", ""},
                                         Map{"planar/souter_all.lines.geojson", ""},
                                         Map{"planar/lineaments_200k.lines.geojson", ""},
                                         Map{"planar/section_model_a1_x2500.lines.geojson", ""}));

TEST(CleaningOtherMaps, EndInAResultOrAnErrorThatSaysWhy) {
  if (!std::filesystem::exists(kFolder)) GTEST_SKIP() << kFolder << " is absent";
  for (const char* folder : {"planar", "ugly"}) {
    for (const auto& entry : std::filesystem::directory_iterator(kFolder + folder)) {
      if (entry.path().extension() != ".geojson") continue;
      SCOPED_TRACE(entry.path().string());
      try {
        const LineSet raw = read_lines({entry.path().string()});
        const double size = raw.box().longer_side() / 300;
        const CleanOptions options{0.05 * size, 0.1 * size, 0.05 * size};
        expect_faithful(raw, clean_lines(raw, default_outline(raw, options.snap), options));
      } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::kInput) << error.message();
      }
    }
  }
}

}  // namespace
}  // namespace quarry
