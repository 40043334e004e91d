// Our figures against those of the independent referee on the same file.
#include <array>
#include <cstdio>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/mesh/vtu_writer.hpp"
#include "kernels/quality/face.hpp"
#include "kernels/quality/summary.hpp"
#include "tests/io/mesh/sample_mesh.hpp"

namespace quarry {
namespace {

constexpr const char* kReferee = "../shared/referee/planar_quality.py";

std::string output_of(const std::string& command) {
  std::string text;
  if (FILE* pipe = ::popen(command.c_str(), "r")) {
    std::array<char, 4096> part{};
    while (const std::size_t count = std::fread(part.data(), 1, part.size(), pipe))
      text.append(part.data(), count);
    ::pclose(pipe);
  }
  return text;
}

nlohmann::json referee_figures(const Mesh& mesh) {
  const std::string path =
      (std::filesystem::temp_directory_path() / ("quarry_referee_" + std::to_string(::getpid()) + ".vtu"))
          .string();
  MeshWriteOptions options;
  write_vtu(path, mesh, options);
  const std::string text = output_of(std::string("/usr/bin/python3 -B ") + kReferee + " " + path);
  std::filesystem::remove(path);
  return nlohmann::json::parse(text);
}

class Referee : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(kReferee)) GTEST_SKIP() << kReferee << " is not there";
    if (output_of("/usr/bin/python3 -c 'import numpy; print(1)' 2>/dev/null") != "1\n")
      GTEST_SKIP() << "python3-numpy is not installed";
  }
};

void expect_near(double ours, const nlohmann::json& theirs, const char* what) {
  const double value = theirs.get<double>();
  EXPECT_NEAR(ours, value, 1e-12 * std::max(1.0, std::abs(value))) << what;
}

void expect_range(const ValueRange& ours, const nlohmann::json& theirs, const char* what) {
  expect_near(ours.min, theirs["min"], what);
  expect_near(ours.mean, theirs["mean"], what);
  expect_near(ours.max, theirs["max"], what);
}

// The referee gives per cent, rounded to three digits.
template <std::size_t kBins>
void expect_histogram(const ShapeSummary& shape, const std::array<std::size_t, kBins>& ours,
                      const nlohmann::json& theirs, const char* what) {
  for (std::size_t i = 0; i < theirs.size(); ++i)
    EXPECT_NEAR(100 * shape.share(ours[i]), theirs[i].get<double>(), 0.000501) << what << ", bin " << i;
}

void expect_quads_equal(const ShapeSummary& ours, const nlohmann::json& theirs) {
  expect_range(ours.scaled_jacobian, theirs["scaled_jacobian"], "scaled Jacobian");
  expect_histogram(ours, ours.scaled_jacobian_histogram, theirs["sj_hist_0_1"], "scaled Jacobian");
  EXPECT_EQ(ours.scaled_jacobian_below_0p2, theirs["sj_below_0p2"].get<std::size_t>());
  EXPECT_EQ(ours.scaled_jacobian_not_positive, theirs["inverted"].get<std::size_t>());
  expect_range(ours.min_angle, theirs["min_angle"], "smallest angle");
  expect_histogram(ours, ours.min_angle_histogram, theirs["min_angle_hist_10deg"], "smallest angle");
  expect_near(ours.max_angle, theirs["max_angle"], "largest angle");
  EXPECT_NEAR(100 * ours.share(ours.max_angle_over_150), theirs["max_angle_over_150_pct"].get<double>(),
              0.0000501);
  expect_range(ours.aspect, theirs["aspect_max_over_min_edge"], "aspect");
}

void expect_triangles_equal(const ShapeSummary& ours, const nlohmann::json& theirs) {
  expect_range(ours.lo_measure, theirs["lo"], "Lo's measure");
  expect_histogram(ours, ours.lo_histogram, theirs["lo_hist_0_1"], "Lo's measure");
  expect_range(ours.min_angle, theirs["min_angle"], "smallest angle");
  expect_histogram(ours, ours.min_angle_histogram, theirs["min_angle_hist_10deg"], "smallest angle");
}

void expect_valence_equal(const ValenceSummary& ours, const nlohmann::json& theirs) {
  EXPECT_EQ(ours.regular, theirs["regular"].get<int>());
  EXPECT_EQ(ours.interior, theirs["interior"].get<std::size_t>());
  EXPECT_EQ(ours.free, theirs["free"].get<std::size_t>());
  EXPECT_NEAR(100 * ours.irregular_share(), theirs["irregular_pct"].get<double>(), 0.000501);
  EXPECT_NEAR(100 * ours.free_irregular_share(), theirs["irregular_free_pct"].get<double>(), 0.000501);
  std::size_t bins = 0;
  for (std::size_t valence = 0; valence < ours.histogram.size(); ++valence)
    if (ours.histogram[valence] != 0) {
      ++bins;
      EXPECT_EQ(ours.histogram[valence], theirs["hist"].at(std::to_string(valence)).get<std::size_t>());
    }
  EXPECT_EQ(bins, theirs["hist"].size());
}

void expect_referee_agrees(const Mesh& mesh) {
  const nlohmann::json theirs = referee_figures(mesh);
  const QualitySummary ours = summarize_quality(mesh);
  EXPECT_EQ(ours.vertices, theirs["vertices"].get<std::size_t>());
  EXPECT_EQ(ours.quads.faces, theirs["quads"].get<std::size_t>());
  EXPECT_EQ(ours.triangles.faces, theirs["triangles"].get<std::size_t>());
  EXPECT_EQ(ours.edges, theirs["lines"].get<std::size_t>());
  expect_near(ours.area, theirs["area"], "area");
  expect_near(ours.boundary_length, theirs["boundary_length"], "boundary");
  expect_valence_equal(ours.valence, theirs["valence"]);
  if (ours.quads.faces != 0) expect_quads_equal(ours.quads, theirs["quad"]);
  if (ours.triangles.faces != 0) expect_triangles_equal(ours.triangles, theirs["tri"]);
}

TEST_F(Referee, FindsTheSameFiguresOnQuads) {
  expect_referee_agrees(make_sample_mesh({.size = 60, .triangles = false}));
}

TEST_F(Referee, FindsTheSameFiguresOnAMixedMesh) { expect_referee_agrees(make_sample_mesh({.size = 61})); }

TEST_F(Referee, FindsTheSameFiguresOnAPlainGrid) {
  expect_referee_agrees(make_sample_mesh({.size = 20, .disorder = 0}));
}

TEST_F(Referee, FindsTheSameFiguresOnATangledMesh) {
  expect_referee_agrees(make_sample_mesh({.size = 50, .disorder = 2.5, .seed = 7}));
}

TEST_F(Referee, FindsTheSameFiguresOnMapCoordinates) {
  const Mesh mesh = make_sample_mesh({.size = 30, .corner = {6.7e6, 4.2e5}});
  const nlohmann::json theirs = referee_figures(mesh);
  const QualitySummary ours = summarize_quality(mesh);
  // The referee's own area is off by the rounding of products of coordinates, ours is not.
  EXPECT_DOUBLE_EQ(ours.area, 900.0);
  expect_quads_equal(ours.quads, theirs["quad"]);
  expect_triangles_equal(ours.triangles, theirs["tri"]);
}

}  // namespace
}  // namespace quarry
