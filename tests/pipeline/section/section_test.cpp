// Whole section jobs in this process: the promises of docs/contract.md on line work made here.
#include "pipeline/section/section.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "engine/base/error.hpp"
#include "engine/mesh/validate.hpp"
#include "engine/parallel/parallel.hpp"
#include "io/mesh/vtu_writer.hpp"
#include "kernels/quality/summary.hpp"
#include "pipeline/section/section_report.hpp"
#include "tests/pipeline/section/sample_lines.hpp"

namespace quarry {
namespace {

// A file that is removed with its test.
class ScratchFile {
 public:
  explicit ScratchFile(const std::string& name)
      : path_((std::filesystem::temp_directory_path() / fmt::format("quarry_section_{}_{}", ::getpid(), name))
                  .string()) {}
  ScratchFile(const std::string& name, const std::string& text) : ScratchFile(name) {
    std::ofstream(path_) << text;
  }
  ~ScratchFile() { std::filesystem::remove(path_); }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] std::string text() const {
    std::ifstream file(path_, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

 private:
  std::string path_;
};

SectionOptions options_for(const std::string& path, double size) {
  SectionOptions options;
  options.inputs = {path};
  options.size = size;
  return options;
}

std::string vtu_bytes(const SectionOptions& options) {
  const SectionResult result = mesh_section(options, {});
  const ScratchFile file("mesh.vtu");
  MeshWriteOptions write;
  write.fields = {{"options", option_text(resolved_options(options, result))}};
  write_vtu(file.path(), result.mesh, write);
  return file.text();
}

// Other threads take part, and the bytes are the same.
void expect_same_bytes(const SectionOptions& options) {
  std::string first;
  parallel::with_threads(1, [&] { first = vtu_bytes(options); });
  ASSERT_FALSE(first.empty());
  for (const int threads : {2, 4, 7}) {
    const parallel::ParticipationProbe probe;
    std::string bytes;
    parallel::with_threads(threads, [&] { bytes = vtu_bytes(options); });
    EXPECT_GT(probe.chunks_of_other_threads(), 0U) << threads << " threads";
    EXPECT_EQ(bytes == first, true) << "the file differs on " << threads << " threads";
  }
}

TEST(SectionThreads, QuadsHaveTheSameBytesOnAnyNumber) {
  expect_same_bytes(options_for("tests/data/demo_section.geojson", 12));
}

TEST(SectionThreads, TrianglesHaveTheSameBytesOnAnyNumber) {
  SectionOptions options = options_for("tests/data/demo_section.geojson", 15);
  options.elements = Elements::kTriangle;
  expect_same_bytes(options);
}

TEST(SectionThreads, ThePublishedProcedureHasTheSameBytesOnAnyNumber) {
  SectionOptions options = options_for("tests/data/demo_section.geojson", 15);
  options.preset = Preset::kPaper;
  expect_same_bytes(options);
}

TEST(SectionThreads, ADelaunayStartHasTheSameBytesOnAnyNumber) {
  SectionOptions options = options_for("tests/data/demo_section.geojson", 15);
  options.start = StartMesh::kDelaunay;
  expect_same_bytes(options);
}

// The promises that can be checked from the result alone; validity on the doubles is checked with exact
// predicates.
void expect_promises(const SectionResult& result, double area) {
  EXPECT_EQ(validate(result.mesh, GeometryCheck::kPlanarCorners), "");
  const QualitySummary quality = summarize_quality(result.mesh);
  EXPECT_EQ(quality.triangles.faces, 0U);
  EXPECT_GT(quality.quads.faces, 0U);
  EXPECT_NEAR(quality.area, area, 1e-9 * area);
  const auto constraint = result.mesh.find_tag<EdgeId, std::int32_t>("constraint");
  std::set<std::int32_t> numbers;
  for (const EdgeId e : result.mesh.edges()) numbers.insert(constraint[e]);
  for (const LineId line : IdRange<LineId>(result.lines.lines.size())) {
    const LedgerEntry& entry = result.cleaned.ledger[line];
    const bool dropped = entry.fate == LineFate::kDropped;
    EXPECT_EQ(numbers.contains(static_cast<std::int32_t>(line.value())), !dropped) << "line " << line.value();
    EXPECT_EQ(dropped && entry.why.empty(), false) << "line " << line.value();
    EXPECT_LE(entry.moved, result.lengths.snap + result.lengths.min_edge + result.lengths.tolerance);
  }
}

TEST(SectionProperties, RandomLineWorkEndsInAValidMeshOfQuads) {
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    const ScratchFile file("random.geojson", geojson_text(random_lines(seed)));
    SectionOptions options = options_for(file.path(), 2);
    options.boundary = "box";
    SectionResult result;
    ASSERT_NO_THROW(result = mesh_section(options, {}));
    const Box2 box = result.lines.box();
    expect_promises(result, box.width() * box.height());
  }
}

TEST(SectionProperties, MapCoordinatesWithCentimetreDetailChangeNothing) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    std::vector<Polyline> lines = random_lines(seed);
    for (Polyline& line : lines)
      for (Vec2& p : line) p = Vec2{6.7e6, 3.1e5} + 0.1 * p;
    const ScratchFile file("map.geojson", geojson_text(lines));
    SectionOptions options = options_for(file.path(), 0.2);
    options.boundary = "box";
    SectionResult result;
    ASSERT_NO_THROW(result = mesh_section(options, {}));
    const Box2 box = result.lines.box();
    expect_promises(result, box.width() * box.height());
  }
}

TEST(SectionProperties, SnapOfZeroIsRaisedAndTold) {
  const ScratchFile file("random.geojson", geojson_text(random_lines(3)));
  SectionOptions options = options_for(file.path(), 4);
  options.snap = 0;
  options.min_edge = 0;
  options.tolerance = 0;
  options.boundary = "box";
  SectionResult result;
  ASSERT_NO_THROW(result = mesh_section(options, {}));
  EXPECT_GT(result.lengths.snap, 0);
  EXPECT_FALSE(result.cleaned.notes.empty());
  EXPECT_EQ(validate(result.mesh, GeometryCheck::kPlanarCorners), "");
}

TEST(SectionCount, IsMetWithinATwentieth) {
  const ScratchFile file("lines.geojson",
                         geojson_text({{{0, 0}, {100, 0}}, {{0, 100}, {100, 100}}, {{20, 30}, {70, 60}}}));
  // Few elements come in whole rows.
  for (const auto& [count, share] :
       {std::pair(500.0, 0.2), std::pair(5000.0, 0.05), std::pair(50000.0, 0.05)}) {
    SectionOptions options = options_for(file.path(), 1);
    options.size.reset();
    options.count = count;
    const SectionResult result = mesh_section(options, {});
    EXPECT_NEAR(static_cast<double>(result.mesh.count_alive_faces()), count, share * count) << count;
  }
}

TEST(SectionCount, IsToldWhereLinesNeedMoreElements) {
  const ScratchFile file("lines.geojson",
                         geojson_text({{{0, 0}, {100, 0}}, {{0, 100}, {100, 100}}, {{20, 30}, {70, 60}}}));
  SectionOptions options = options_for(file.path(), 1);
  options.size.reset();
  options.count = 2;
  EXPECT_EQ(
      mesh_section(options, {}).cleaned.notes.back().find("--count asks for 2 elements, and there are "), 0U);
}

std::vector<std::string> passes_with(Elements elements, QuadMethod quads, bool keep_boundary = false) {
  SectionOptions options = options_for("tests/data/demo_section.geojson", 12);
  options.elements = elements;
  options.quads = quads;
  options.keep_boundary = keep_boundary;
  std::vector<std::string> names;
  for (const PassReport& pass : report_section(options, mesh_section(options, {}), {}).passes) {
    EXPECT_FALSE(pass.name.empty());
    EXPECT_GE(pass.live, pass.won) << pass.name;
    names.push_back(pass.name);
  }
  return names;
}

TEST(SectionQuads, HaveThreeToFiveEdgesAtEveryVertexOffTheLines) {
  for (const double size : {6.0, 12.0}) {
    SCOPED_TRACE(size);
    const SectionResult result = mesh_section(options_for("tests/data/demo_section.geojson", size), {});
    const std::vector<std::size_t> valences = summarize_quality(result.mesh).valence.free_histogram;
    for (std::size_t edges = 0; edges < valences.size(); ++edges) {
      if (edges < 3 || edges > 5) {
        EXPECT_EQ(valences[edges], 0U) << edges;
      }
    }
  }
}

TEST(SectionReport, CountsEachPassThatRan) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(passes_with(Elements::kQuad, QuadMethod::kCluster),
            (Names{"nodes", "lines", "rearrange", "rearrange"}));
  EXPECT_EQ(passes_with(Elements::kTriangle, QuadMethod::kCluster, true),
            (Names{"nodes", "lines", "vertices taken out of the outline", "flips to better triangles"}));
  EXPECT_GE(passes_with(Elements::kQuad, QuadMethod::kMatching).size(), 4U);
  const SectionOptions options = options_for("tests/data/demo_section.geojson", 12);
  EXPECT_TRUE(report_section(options, clean_section(options, {}), {}).passes.empty());
}

TEST(SectionLengths, AreReportedAsTheyWereUsed) {
  const ScratchFile file("lines.geojson", geojson_text({{{0, 0}, {100, 0}}, {{0, 100}, {100, 100}}}));
  SectionOptions options = options_for(file.path(), 10);
  options.snap = 2;
  options.min_edge = 1;
  for (const ReportItem& item : resolved_options(options, mesh_section(options, {})))
    if (item.name == "snap" || item.name == "min-edge") {
      EXPECT_EQ(std::get<double>(item.value), 2) << item.name;
    }
}

TEST(SectionCancellation, EndsTheJobWithItsOwnKind) {
  CancellationToken token;
  token.cancel();
  try {
    (void)mesh_section(options_for("tests/data/demo_section.geojson", 12), Progress({}, &token));
    FAIL() << "the job went on";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInterrupted);
  }
}

TEST(SectionHash, FollowsTheBytesOfEveryFile) {
  const ScratchFile a("a.geojson", "abc");
  const ScratchFile b("b.geojson", "abd");
  const std::string one = hash_inputs(options_for(a.path(), 1));
  EXPECT_EQ(one.size(), 16U);
  EXPECT_EQ(one, hash_inputs(options_for(a.path(), 2)));
  EXPECT_NE(one, hash_inputs(options_for(b.path(), 1)));
  SectionOptions both = options_for(a.path(), 1);
  both.boundary = b.path();
  EXPECT_NE(one, hash_inputs(both));
}

}  // namespace
}  // namespace quarry
