// Matching of triangles beside Boost's maximum matchings, for tables 1 and 2 of docs/results.md: times and
// Steiner points on Delaunay meshes. Prints Markdown and needs no harness, since each figure is one long run.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include <ctime>
#include <fmt/format.h>

#ifdef QUARRY_BOOST_GRAPH
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/max_cardinality_matching.hpp>
#include <boost/graph/maximum_weighted_matching.hpp>
#endif

#include "engine/base/random.hpp"
#include "engine/mesh/compact.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/initial/delaunay.hpp"
#include "kernels/initial/triangulation.hpp"
#include "kernels/matching/matching.hpp"
#include "kernels/matching/merge_join.hpp"
#include "kernels/matching/short_ways.hpp"
#include "kernels/matching/spanning_forest.hpp"
#include "kernels/matching/subtree_parity.hpp"
#include "kernels/quality/face.hpp"

namespace quarry {

bool on_one_thread = false;

namespace {

constexpr double kTriangleArea = 0.4330127018922193;

// Of the processor on one thread, so that other work on the machine does not count; of the clock on more.
double seconds_of(auto&& work) {
  const auto began = std::chrono::steady_clock::now();
  const std::clock_t ticks = std::clock();
  work();
  if (on_one_thread) return static_cast<double>(std::clock() - ticks) / CLOCKS_PER_SEC;
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}

enum class Points { kRelaxed, kRows };

// The Delaunay triangulation of about so many points of a square: one drawn in each cell of a grid and three
// times moved to the mean of those around it, which gives the irregular valences that meshers give.
Mesh relaxed_mesh(double triangles) {
  const auto side = static_cast<std::uint64_t>(std::sqrt(0.5 * triangles));
  std::vector<Vec2> points(side * side);
  for (std::uint64_t i = 0; i < points.size(); ++i) {
    const std::uint64_t row = i / side, column = i % side;
    const bool rim = row == 0 || column == 0 || row + 1 == side || column + 1 == side;
    const double reach = rim ? 0 : 0.95;
    points[i] = {static_cast<double>(column) + reach * (uniform01(1, 2 * i) - 0.5),
                 static_cast<double>(row) + reach * (uniform01(1, 2 * i + 1) - 0.5)};
  }
  for (int round = 0; round < 3; ++round) {
    const Mesh mesh = delaunay_triangulation(points);
    const std::vector<Vec2> before = points;
    parallel::for_each(points.size(), [&](std::size_t i) {
      if (mesh.on_boundary(VertexId(i))) return;
      Vec2 sum;
      int count = 0;
      for_each_side_around(mesh, VertexId(i), [&](SideId s) {
        sum = sum + (before[mesh.target(s).value()] - before[i]);
        ++count;
      });
      points[i] = before[i] + (1.0 / count) * sum;
    });
  }
  Mesh mesh = delaunay_triangulation(points);
  compact(mesh, EntityOrder::kHilbert);
  return mesh;
}

// Evened out by halving one outer edge.
Mesh even_mesh(double triangles, Points points) {
  const double width = std::sqrt(triangles * kTriangleArea);
  Mesh mesh = points == Points::kRelaxed
                  ? relaxed_mesh(triangles)
                  : make_delaunay({{0, 0}, {width, width}}, {.spacing = 1, .jitter = 0.25, .seed = 1});
  auto tags = ConstraintTags::add_to(mesh);
  MatchingReport report;
  NodedLines lines;
  lines.line_begin.push_back(0);
  prepare_for_join(mesh, tags, lines, MatchingOptions(), report, Progress());
  return mesh;
}

struct Quality {
  double mean = 0, smallest = 1;
  std::uint64_t quads = 0;
};

Quality quality_of(const Mesh& mesh) {
  Quality quality;
  for (const double shape : scaled_jacobians(mesh)) {
    if (std::isnan(shape)) continue;
    ++quality.quads;
    quality.mean += shape;
    quality.smallest = std::min(quality.smallest, shape);
  }
  quality.mean /= static_cast<double>(quality.quads);
  return quality;
}

struct Run {
  double shapes = 0, ways = 0, forest = 0, parity = 0, search = 0, merge = 0;
  std::uint64_t steiner = 0;
  JoinSearchReport searched;
  Quality quality;
  [[nodiscard]] double tree() const { return shapes + ways + forest + parity; }
};

Run run_matching(Mesh mesh, const MatchingOptions& options) {
  Run run;
  const ConstraintTags tags = ConstraintTags::of(mesh);
  std::vector<float> shapes;
  SpanningForest forest;
  DualArcs join;
  run.shapes = seconds_of([&] { shapes = pair_shapes(mesh, tags); });
  std::vector<float> worths;
  run.ways = seconds_of([&] {
    worths =
        options.start == MatchingStart::kShapes ? shapes : short_way_worths(mesh, shapes, options.short_ways);
  });
  run.forest = seconds_of([&] { forest = maximum_spanning_forest(mesh, worths); });
  run.parity = seconds_of([&] { join = subtree_parity_join(mesh, forest.arcs); });
  run.search = seconds_of([&] {
    if (!options.search) return;
    const MergeCosts costs(mesh, shapes, options.cost);
    improve_join(mesh, tags, costs, options.searching, join, run.searched, Progress());
  });
  run.steiner = count_steiner_points(join);
  Mesh quads;
  run.merge = seconds_of([&] { quads = merge_join(std::move(mesh), join); });
  run.quality = quality_of(quads);
  return run;
}

#ifdef QUARRY_BOOST_GRAPH
using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property,
                                    boost::property<boost::edge_weight_t, double>>;

Graph dual_of(const Mesh& mesh, const std::vector<float>& shapes) {
  Graph graph(mesh.face_slots());
  for (const FaceId f : mesh.faces()) {
    for (int k = 0; k < 3; ++k) {
      const SideId s(f, k);
      if (shapes[s.value()] <= kNoArc || mesh.neighbour(s) < s) continue;
      // Every pair is worth more than none.
      boost::add_edge(f.value(), mesh.neighbour(s).face().value(),
                      2.0 + static_cast<double>(shapes[s.value()]), graph);
    }
  }
  return graph;
}

struct Peer {
  double seconds = 0, mean = 0, smallest = 1;
  std::uint64_t pairs = 0;
};

template <class Match>
Peer run_peer(const Mesh& mesh, const Match& match) {
  const std::vector<float> shapes = pair_shapes(mesh, ConstraintTags::of(mesh));
  const Graph graph = dual_of(mesh, shapes);
  std::vector<boost::graph_traits<Graph>::vertex_descriptor> mate(mesh.face_slots());
  Peer peer;
  peer.seconds = seconds_of([&] { match(graph, mate); });
  for (const FaceId f : mesh.faces()) {
    for (int k = 0; k < 3; ++k) {
      const SideId s(f, k);
      if (shapes[s.value()] <= kNoArc || mesh.neighbour(s) < s) continue;
      if (mate[f.value()] != mesh.neighbour(s).face().value()) continue;
      ++peer.pairs;
      peer.mean += shapes[s.value()];
      peer.smallest = std::min(peer.smallest, static_cast<double>(shapes[s.value()]));
    }
  }
  peer.mean /= static_cast<double>(peer.pairs);
  return peer;
}

Peer cardinality(const Mesh& mesh) {
  return run_peer(mesh, [](const Graph& graph, auto& mate) {
    boost::edmonds_maximum_cardinality_matching(graph, mate.data());
  });
}

Peer weighted(const Mesh& mesh) {
  return run_peer(
      mesh, [](const Graph& graph, auto& mate) { boost::maximum_weighted_matching(graph, mate.data()); });
}
#endif

double percent(std::uint64_t part, std::size_t whole) {
  return 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

void print_first_table(double largest, int threads) {
  fmt::print(
      "Matching alone, {} threads, random points relaxed. Tree: shapes, short ways, forest, parity. Search: "
      "descent.\n\n| triangles | shapes s | short ways s | forest s | parity s | tree s | search s | "
      "Steiner, % of "
      "nodes | mean SJ | smallest SJ | merge s | Boost cardinality s | slower than tree | than tree and "
      "search "
      "|\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n",
      threads);
  for (double triangles = 1e3; triangles <= 1.01 * largest; triangles *= 10) {
    Mesh mesh = even_mesh(triangles, Points::kRelaxed);
    const std::size_t faces = mesh.face_slots(), nodes = mesh.vertex_slots();
    double boost = 0;
#ifdef QUARRY_BOOST_GRAPH
    if (triangles < 2e5) boost = cardinality(mesh).seconds;
#endif
    const Run run = run_matching(std::move(mesh), MatchingOptions());
    fmt::print(
        "| {} | {:.4f} | {:.4f} | {:.4f} | {:.4f} | {:.4f} | {:.4f} | {:.2f} | {:.4f} | {:.4f} | {:.4f} |",
        faces, run.shapes, run.ways, run.forest, run.parity, run.tree(), run.search,
        percent(run.steiner, nodes), run.quality.mean, run.quality.smallest, run.merge);
    if (boost > 0)
      fmt::print(" {:.3f} | {:.0f} | {:.0f} |\n", boost, boost / run.tree(),
                 boost / (run.tree() + run.search));
    else
      fmt::print(" | | |\n");
    std::fflush(stdout);
  }
}

void print_weighted_row() {
#ifdef QUARRY_BOOST_GRAPH
  Mesh mesh = even_mesh(1700, Points::kRelaxed);
  const std::size_t faces = mesh.face_slots();
  const Peer boost = weighted(mesh);
  const Run run = run_matching(std::move(mesh), MatchingOptions());
  fmt::print(
      "\nAt {} triangles Boost's weighted matching takes {:.2f} s: mean SJ {:.4f}, smallest {:.4f}, {} "
      "triangles left. Tree and search: {:.4f} s, mean {:.4f} ({:+.2f} %), smallest {:.4f}, {} Steiner "
      "points.\n",
      faces, boost.seconds, boost.mean, boost.smallest, faces - 2 * boost.pairs, run.tree() + run.search,
      run.quality.mean, 100 * (run.quality.mean / boost.mean - 1), run.quality.smallest, run.steiner);
#endif
}

void print_second_table() {
  fmt::print(
      "\nSteiner points in % of the nodes; tree: the forest by shapes alone; then by short ways. Annealing "
      "with a cost of 4 for each.\n\n"
      "| points | nodes | shapes | short ways | descent | s | mean SJ | 600 sweeps | s | mean SJ |\n"
      "|---|---|---|---|---|---|---|---|---|---|\n");
  for (const Points points : {Points::kRelaxed, Points::kRows}) {
    for (const double nodes : {2.2e3, 1e4, 5e4}) {
      const std::size_t count = even_mesh(2 * nodes, points).vertex_slots();
      fmt::print("| {} | {} ", points == Points::kRelaxed ? "relaxed" : "in rows", count);
      MatchingOptions options;
      options.search = false;
      for (const MatchingStart start : {MatchingStart::kShapes, MatchingStart::kShortWays}) {
        options.start = start;
        fmt::print("| {:.2f} ", percent(run_matching(even_mesh(2 * nodes, points), options).steiner, count));
      }
      options.search = true;
      for (const int sweeps : {0, 600}) {
        options.searching.annealing_sweeps = sweeps;
        options.cost.steiner = sweeps > 0 ? 4 : JoinCostOptions().steiner;
        const Run run = run_matching(even_mesh(2 * nodes, points), options);
        fmt::print("| {:.2f} | {:.3f} | {:.4f} ", percent(run.steiner, count), run.search, run.quality.mean);
      }
      fmt::print("|\n");
      std::fflush(stdout);
    }
  }
}

}  // namespace
}  // namespace quarry

// Arguments: the largest number of triangles of the first table (default 1e7), and threads (default all).
int main(int argc, char** argv) {
  const double largest = argc > 1 ? std::atof(argv[1]) : 1e7;
  const int threads = argc > 2 ? std::atoi(argv[2]) : quarry::parallel::hardware_threads();
  quarry::on_one_thread = threads == 1;
  quarry::parallel::with_threads(threads, [&] {
    quarry::print_first_table(largest, threads);
    quarry::print_weighted_row();
    quarry::print_second_table();
  });
  return 0;
}
