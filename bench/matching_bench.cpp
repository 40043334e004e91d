// Matching of triangles beside Boost's maximum matchings: times and Steiner points on Delaunay meshes, for
// tables 1 and 2 of docs/results-quads.md. Prints a line of JSON a row and needs no harness, since each
// figure is one long run.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <utility>
#include <vector>

#include <ctime>
#include <nlohmann/json.hpp>

#ifdef QUARRY_BOOST_GRAPH
#include "bench/boost_matching.hpp"
#endif
#include "bench/point_sets.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/matching/matching.hpp"
#include "kernels/matching/merge_join.hpp"
#include "kernels/matching/short_ways.hpp"
#include "kernels/matching/spanning_forest.hpp"
#include "kernels/matching/subtree_parity.hpp"
#include "kernels/quality/face.hpp"

namespace quarry::bench {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kFewestNodes = 2e3;
constexpr int kAnnealingSweeps = 2400;
constexpr double kAnnealingSteinerCost = 4;

struct Settings {
  std::string_view table = "all";
  double largest = 1e7;  // triangles of the table of times, nodes of the table of Steiner points
  int threads = 1;
  [[nodiscard]] bool wants(std::string_view name) const { return table == "all" || table == name; }
};

// Of the processor on one thread, so that other work on the machine does not count; of the clock on more.
double seconds_of(int threads, auto&& work) {
  const auto began = std::chrono::steady_clock::now();
  const std::clock_t ticks = std::clock();
  work();
  if (threads == 1) return static_cast<double>(std::clock() - ticks) / CLOCKS_PER_SEC;
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}

struct Quality {
  double mean = 0, smallest = 1;
};

Quality quality_of(const Mesh& mesh) {
  Quality quality;
  std::uint64_t quads = 0;
  for (const double shape : scaled_jacobians(mesh)) {
    if (std::isnan(shape)) continue;
    ++quads;
    quality.mean += shape;
    quality.smallest = std::min(quality.smallest, shape);
  }
  quality.mean /= static_cast<double>(quads);
  return quality;
}

struct Run {
  std::size_t triangles = 0, nodes = 0;
  double shapes = 0, ways = 0, forest = 0, parity = 0, search = 0, merge = 0;  // seconds
  std::uint64_t steiner = 0;
  Quality quality;
  [[nodiscard]] double tree() const { return shapes + ways + forest + parity; }
  [[nodiscard]] double steiner_percent() const {
    return 100.0 * static_cast<double>(steiner) / static_cast<double>(nodes);
  }
};

Run run_matching(Mesh mesh, const MatchingOptions& options, int threads) {
  Run run;
  run.triangles = mesh.face_slots();
  run.nodes = mesh.vertex_slots();
  const ConstraintTags tags = ConstraintTags::of(mesh);
  std::vector<float> shapes, worths;
  SpanningForest forest;
  DualArcs join;
  run.shapes = seconds_of(threads, [&] { shapes = pair_shapes(mesh, tags); });
  run.ways = seconds_of(threads, [&] {
    worths =
        options.start == MatchingStart::kShapes ? shapes : short_way_worths(mesh, shapes, options.short_ways);
  });
  run.forest = seconds_of(threads, [&] { forest = maximum_spanning_forest(mesh, worths); });
  run.parity = seconds_of(threads, [&] { join = subtree_parity_join(mesh, forest.arcs); });
  run.search = seconds_of(threads, [&] {
    if (!options.search) return;
    const MergeCosts costs(mesh, shapes, options.cost);
    JoinSearchReport searched;
    improve_join(mesh, tags, costs, options.searching, join, searched, Progress());
  });
  run.steiner = count_steiner_points(join);
  Mesh quads;
  run.merge = seconds_of(threads, [&] { quads = merge_join(std::move(mesh), join); });
  run.quality = quality_of(quads);
  return run;
}

Json json_of(const char* table, const Run& run) {
  return {{"table", table},           {"triangles", run.triangles},
          {"nodes", run.nodes},       {"shapes_s", run.shapes},
          {"ways_s", run.ways},       {"forest_s", run.forest},
          {"parity_s", run.parity},   {"tree_s", run.tree()},
          {"search_s", run.search},   {"merge_s", run.merge},
          {"steiner", run.steiner},   {"steiner_pct", run.steiner_percent()},
          {"mean", run.quality.mean}, {"smallest", run.quality.smallest}};
}

void print(const Json& row) {
  std::printf("%s\n", row.dump().c_str());
  std::fflush(stdout);
}

#ifdef QUARRY_BOOST_GRAPH
constexpr double kLargestCardinality = 2e5;

Json json_of(const PeerMatching& peer) {
  return {{"s", peer.seconds}, {"pairs", peer.pairs}, {"mean", peer.mean}, {"smallest", peer.smallest}};
}
#endif

void print_times(const Settings& settings) {
  for (double triangles = 1e3; triangles <= 1.01 * settings.largest; triangles *= 10) {
    const auto make = [=] { return even_triangles(triangles, PointSet::kRelaxed); };
    Json row = json_of("times", run_matching(make(), MatchingOptions(), settings.threads));
#ifdef QUARRY_BOOST_GRAPH
    if (triangles < kLargestCardinality) row["cardinality"] = json_of(boost_cardinality_matching(make()));
#endif
    print(row);
  }
}

void print_weighted(const Settings& settings) {
  const auto make = [=] { return even_triangles(1700, PointSet::kRelaxed); };
  Json row = json_of("weighted", run_matching(make(), MatchingOptions(), settings.threads));
#ifdef QUARRY_BOOST_GRAPH
  row["weighted"] = json_of(boost_weighted_matching(make()));
#endif
  print(row);
}

// Four ways: the forest by shapes alone, by short ways, then descent, and annealing before it.
void print_steiner(const Settings& settings) {
  for (const PointSet points : kPointSets) {
    for (const double nodes : {1.1 * kFewestNodes, 1e4, 5e4}) {
      if (nodes > settings.largest) continue;
      const auto print_way = [&](const char* way, const MatchingOptions& options) {
        Json row =
            json_of("steiner", run_matching(even_triangles(2 * nodes, points), options, settings.threads));
        row["points"] = name_of(points);
        row["way"] = way;
        print(row);
      };
      MatchingOptions options;
      options.search = false;
      options.start = MatchingStart::kShapes;
      print_way("shapes", options);
      options.start = MatchingStart::kShortWays;
      print_way("short ways", options);
      options.search = true;
      print_way("descent", options);
      options.searching.annealing_sweeps = kAnnealingSweeps;
      options.cost.steiner = kAnnealingSteinerCost;
      print_way("annealing", options);
    }
  }
}

}  // namespace
}  // namespace quarry::bench

// Arguments: times, weighted, steiner or all (default); the largest number of triangles or nodes (default
// 1e7); threads (default 1).
int main(int argc, char** argv) {
  quarry::bench::Settings settings;
  if (argc > 1) settings.table = argv[1];
  if (argc > 2) settings.largest = std::atof(argv[2]);
  if (argc > 3) settings.threads = std::atoi(argv[3]);
  quarry::parallel::with_threads(settings.threads, [&] {
    if (settings.wants("times")) print_times(settings);
    if (settings.wants("weighted")) print_weighted(settings);
    if (settings.wants("steiner")) print_steiner(settings);
  });
  return 0;
}
