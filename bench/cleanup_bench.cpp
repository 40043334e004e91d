// Clean-up of the three-way split of Delaunay triangulations of simple domains, for table 4 of
// docs/results-quads.md beside that of Verma & Tautges (Jaal, IMR 2011). Prints a line of JSON a run and
// needs no harness, since each figure is one long run.
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <ctime>
#include <nlohmann/json.hpp>

#include "bench/domains.hpp"
#include "engine/mesh/validate.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/cleanup/clean_up.hpp"
#include "kernels/quality/face.hpp"
#include "pipeline/report/clean_up_json.hpp"

namespace quarry::bench {
namespace {

using Json = nlohmann::ordered_json;

struct Settings {
  std::string domain;
  double quads = 0;
  CleanUpLevel level = CleanUpLevel::kFull;
  DomainPoints points;
  int threads = 1;
};

struct Figures {
  std::size_t quads = 0, inner = 0, irregular = 0, not_convex = 0;
  double mean = 0, smallest = 1;
  [[nodiscard]] double percent() const {
    return 100 * static_cast<double>(irregular) / static_cast<double>(inner);
  }
};

Figures figures_of(const Mesh& mesh) {
  Figures figures;
  for (const VertexId v : mesh.vertices()) {
    if (!mesh.alive(v) || mesh.on_boundary(v)) continue;
    int faces = 0;
    for_each_side_around(mesh, v, [&](SideId) { ++faces; });
    ++figures.inner;
    figures.irregular += faces != 4 ? 1 : 0;
  }
  for (const FaceId f : mesh.faces()) {
    if (!mesh.alive(f)) continue;
    const double value = scaled_jacobian(mesh, f);
    ++figures.quads;
    figures.not_convex += all_corners_turn_left(mesh, f) ? 0 : 1;
    figures.mean += value;
    figures.smallest = std::min(figures.smallest, value);
  }
  figures.mean /= static_cast<double>(figures.quads);
  return figures;
}

Json json_of(const Figures& figures) {
  return {{"quads", figures.quads},           {"inner", figures.inner},
          {"irregular", figures.irregular},   {"irregular_pct", figures.percent()},
          {"not_convex", figures.not_convex}, {"mean", figures.mean},
          {"smallest", figures.smallest}};
}

void print_run(const Settings& settings, Domain domain) {
  Mesh mesh = split_quads(domain, settings.quads, settings.points);
  const Figures before = figures_of(mesh);
  CleanUpOptions options;
  options.level = settings.level;
  CleanUpReport report;
  const auto began = std::chrono::steady_clock::now();
  const std::clock_t ticks = std::clock();
  clean_up(mesh, NodedLines(), options, report, Progress());
  const double of_processor = static_cast<double>(std::clock() - ticks) / CLOCKS_PER_SEC;
  const double of_clock = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  const Json row = {{"domain", settings.domain},
                    {"level", name_of(settings.level)},
                    {"seed", settings.points.seed},
                    {"boundary_spacing", settings.points.boundary_spacing},
                    {"threads", settings.threads},
                    {"before", json_of(before)},
                    {"after", json_of(figures_of(mesh))},
                    {"cpu_s", of_processor},
                    {"wall_s", of_clock},
                    {"cleanup", clean_up_json(report)},
                    {"times", clean_up_times_json(report)}};
  std::printf("%s\n", row.dump().c_str());
}

}  // namespace
}  // namespace quarry::bench

// Arguments: disk (default), square, annulus or l-shape; about how many quads (default 50,000); the level
// (default full); seed (default 1); boundary spacing as a share of the triangles' (default 1); threads
// (default 1).
int main(int argc, char** argv) {
  using namespace quarry;
  bench::Settings settings;
  settings.domain = argc > 1 ? argv[1] : "disk";
  settings.quads = argc > 2 ? std::atof(argv[2]) : 5e4;
  if (argc > 3) settings.level = clean_up_level_of(argv[3]);
  if (argc > 4) settings.points.seed = std::strtoull(argv[4], nullptr, 10);
  if (argc > 5) settings.points.boundary_spacing = std::atof(argv[5]);
  if (argc > 6) settings.threads = std::atoi(argv[6]);
  const auto domain = bench::domain_of(settings.domain);
  if (!domain || settings.quads < 10) {
    std::fprintf(stderr,
                 "cleanup_bench [disk|square|annulus|l-shape [QUADS [LEVEL [SEED [SPACING [THREADS]]]]]]\n");
    return 2;
  }
  parallel::with_threads(settings.threads, [&] { bench::print_run(settings, *domain); });
  return 0;
}
