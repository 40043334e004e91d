// Clean-up of the three-way split of Delaunay triangulations of a disk, for table 4 of docs/results.md beside
// that of Verma & Tautges (Jaal, IMR 2011). Prints Markdown and needs no harness, since each figure is one
// long run.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <utility>
#include <vector>

#include <ctime>
#include <fmt/format.h>

#include "engine/mesh/compact.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/cleanup/clean_up.hpp"
#include "kernels/cluster/subdivide.hpp"
#include "kernels/initial/delaunay.hpp"
#include "kernels/initial/triangulation.hpp"
#include "kernels/quality/face.hpp"

namespace quarry {
namespace {

// Points on a circle and shaken points of a lattice inside; each triangle makes three quads. Half of the
// inner vertices are irregular.
Mesh disk_of_quads(double quads, std::uint64_t seed) {
  const double spacing = std::sqrt(std::numbers::pi * 6 / quads * 2 / std::numbers::sqrt3);
  std::vector<Vec2> points;
  const auto rim = static_cast<std::size_t>(std::lround(2 * std::numbers::pi / spacing));
  for (std::size_t i = 0; i < rim; ++i) {
    const double turn = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(rim);
    points.push_back({std::cos(turn), std::sin(turn)});
  }
  DelaunayOptions lattice;
  lattice.spacing = spacing;
  lattice.jitter = 0.25;
  lattice.seed = seed;
  for (const Vec2 p : make_spaced_points(Box2{{-1, -1}, {1, 1}}, lattice))
    if (length(p) < 1 - 0.6 * spacing) points.push_back(p);
  Mesh triangles = delaunay_triangulation(points);
  ConstraintTags tags = ConstraintTags::add_to(triangles);
  for (const VertexId v : triangles.vertices())
    if (triangles.on_boundary(v)) tags.support[v] = Support::fixed();
  SubdivideReport report;
  Mesh mesh = subdivide(std::move(triangles), NodedLines(), report, Progress());
  compact(mesh, EntityOrder::kHilbert);
  return mesh;
}

struct Figures {
  std::size_t quads = 0, inner = 0, irregular = 0;
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
    figures.mean += value;
    figures.smallest = std::min(figures.smallest, value);
  }
  figures.mean /= static_cast<double>(figures.quads);
  return figures;
}

// One row: what there was, the seconds of each part, what came of it.
double print_row(double quads, CleanUpLevel level, bool one_thread) {
  Mesh mesh = disk_of_quads(quads, 1);
  const Figures before = figures_of(mesh);
  CleanUpOptions options;
  options.level = level;
  CleanUpReport report;
  const auto began = std::chrono::steady_clock::now();
  const std::clock_t ticks = std::clock();
  clean_up(mesh, NodedLines(), options, report, Progress());
  // Of the processor on one thread, so that other work on the machine does not count; of the clock on more.
  const double seconds =
      one_thread ? static_cast<double>(std::clock() - ticks) / CLOCKS_PER_SEC
                 : std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  double search = 0, commit = 0;
  for (const PatchReport& each : report.patches) {
    search += each.search_seconds;
    commit += each.commit_seconds;
  }
  const Figures after = figures_of(mesh);
  fmt::print(
      "| {} | {} | {:.1f} | {} | {} | {:.3f} | {:.4f} | {:.3f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} "
      "|\n",
      before.quads, name_of(level), before.percent(), after.quads, after.irregular, after.percent(),
      after.mean, after.smallest, seconds, report.local_seconds, search, commit, report.smoothing_seconds);
  std::fflush(stdout);
  return seconds;
}

// Which patches were tried and won, all sizes of one run.
void print_patches(double quads) {
  Mesh mesh = disk_of_quads(quads, 1);
  CleanUpReport report;
  clean_up(mesh, NodedLines(), CleanUpOptions(), report, Progress());
  fmt::print(
      "\n| largest | seeds | searches | stages | three-sided | grid | pair | five | six | refused for "
      "quality | "
      "search s | commit s |\n|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const PatchReport& each : report.patches)
    fmt::print("| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {:.3f} | {:.3f} |\n", each.largest,
               each.seeds, each.searches, each.stages, each.won[0], each.won[1], each.won[2], each.won[3],
               each.won[4], each.rejected[static_cast<std::size_t>(PatchReject::kQuality)],
               each.search_seconds, each.commit_seconds);
}

}  // namespace
}  // namespace quarry

// Arguments: the largest number of quads by default patches (default 5e5) and with as few irregular vertices
// as can be had (default 5e4), and threads (default all).
int main(int argc, char** argv) {
  const double largest = argc > 1 ? std::atof(argv[1]) : 5e5;
  const double largest_fewest = argc > 2 ? std::atof(argv[2]) : 5e4;
  const int threads = argc > 3 ? std::atoi(argv[3]) : quarry::parallel::hardware_threads();
  quarry::parallel::with_threads(threads, [&] {
    fmt::print(
        "Clean-up of a disk on {} threads.\n\n| quads | level | irregular, % | quads after | irregular | % | "
        "mean SJ | smallest | seconds | local | search | commit | smoothing |\n"
        "|---|---|---|---|---|---|---|---|---|---|---|---|---|\n",
        threads);
    double at_fifty = 0;
    for (const double quads : {5e3, 1e4, 5e4, 5e5}) {
      if (quads <= largest) {
        const double seconds = quarry::print_row(quads, quarry::CleanUpLevel::kFull, threads == 1);
        if (quads == 5e4) at_fifty = seconds;
        if (quads == 5e5) fmt::print("\n500,000 take {:.1f} times 50,000.\n\n", seconds / at_fifty);
      }
      if (quads <= largest_fewest) quarry::print_row(quads, quarry::CleanUpLevel::kFewest, threads == 1);
    }
    quarry::print_patches(std::min(5e4, largest));
  });
  return 0;
}
