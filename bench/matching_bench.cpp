// Matching of triangles beside Boost's maximum matchings, for tables 1 and 2 of docs/results.md: times and
// Steiner points on Delaunay meshes. Prints Markdown and needs no harness, since each figure is one long run.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#ifdef QUARRY_BOOST_GRAPH
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/max_cardinality_matching.hpp>
#include <boost/graph/maximum_weighted_matching.hpp>
#endif

#include "engine/parallel/parallel.hpp"
#include "kernels/initial/delaunay.hpp"
#include "kernels/matching/matching.hpp"
#include "kernels/matching/merge_join.hpp"
#include "kernels/matching/spanning_forest.hpp"
#include "kernels/matching/subtree_parity.hpp"
#include "kernels/quality/face.hpp"

namespace quarry {
namespace {

constexpr double kTriangleArea = 0.4330127018922193;

double seconds_of(auto&& work) {
  const auto began = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}

// About so many triangles of a square, evened out by halving one outer edge.
Mesh even_mesh(double triangles, double jitter) {
  const double width = std::sqrt(triangles * kTriangleArea);
  Mesh mesh = make_delaunay({{0, 0}, {width, width}}, {.spacing = 1, .jitter = jitter, .seed = 1});
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
  double shapes = 0, forest = 0, parity = 0, search = 0, merge = 0;
  std::uint64_t steiner = 0;
  JoinSearchReport searched;
  Quality quality;
  [[nodiscard]] double tree() const { return shapes + forest + parity; }
};

Run run_matching(Mesh mesh, const MatchingOptions& options) {
  Run run;
  const ConstraintTags tags = ConstraintTags::of(mesh);
  std::vector<float> shapes;
  SpanningForest forest;
  DualArcs join;
  run.shapes = seconds_of([&] { shapes = pair_shapes(mesh, tags); });
  run.forest = seconds_of([&] { forest = maximum_spanning_forest(mesh, shapes); });
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

void print_first_table(double largest, int threads) {
  fmt::print("Matching alone, {} threads. Tree: weights, spanning forest, parity. Search: descent.\n\n",
             threads);
  fmt::print(
      "| triangles | tree s | of it forest | search s | moves looked at | Steiner, % of nodes | mean SJ | "
      "smallest SJ | merge s | Boost cardinality s | slower than tree | than tree and search |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (double triangles = 1e3; triangles <= 1.01 * largest; triangles *= 10) {
    const Mesh shape = even_mesh(triangles, 0.25);
    const std::size_t faces = shape.face_slots(), nodes = shape.vertex_slots();
    const Run run = run_matching(even_mesh(triangles, 0.25), MatchingOptions());
    std::string peer = "| | |";
#ifdef QUARRY_BOOST_GRAPH
    if (triangles < 2e5) {
      const Peer boost = cardinality(shape);
      peer = fmt::format("{:.3f} | {:.0f} | {:.0f} |", boost.seconds, boost.seconds / run.tree(),
                         boost.seconds / (run.tree() + run.search));
    }
#endif
    fmt::print("| {} | {:.4f} | {:.4f} | {:.4f} | {} | {:.2f} | {:.4f} | {:.4f} | {:.4f} | {}\n", faces,
               run.tree(), run.forest, run.search, run.searched.evaluated,
               100.0 * static_cast<double>(run.steiner) / static_cast<double>(nodes), run.quality.mean,
               run.quality.smallest, run.merge, peer);
    std::fflush(stdout);
  }
}

void print_weighted_row() {
#ifdef QUARRY_BOOST_GRAPH
  const Mesh mesh = even_mesh(1500, 0.25);
  const Peer boost = weighted(mesh);
  const Run run = run_matching(even_mesh(1500, 0.25), MatchingOptions());
  fmt::print(
      "\nAt {} triangles Boost's weighted matching takes {:.2f} s: mean SJ {:.4f}, smallest {:.4f}, {} "
      "triangles left. Tree and search: {:.4f} s, mean {:.4f} ({:+.2f} %), smallest {:.4f}, {} Steiner "
      "points.\n",
      mesh.face_slots(), boost.seconds, boost.mean, boost.smallest, mesh.face_slots() - 2 * boost.pairs,
      run.tree() + run.search, run.quality.mean, 100 * (run.quality.mean / boost.mean - 1),
      run.quality.smallest, run.steiner);
#endif
}

void print_second_table() {
  fmt::print(
      "\nSteiner points in % of the nodes.\n\n"
      "| nodes | jitter | tree alone | descent | s | mean SJ | 100 sweeps | s | mean SJ | 300 sweeps | s | "
      "mean SJ |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const double nodes : {2e3, 1e4, 5e4}) {
    for (const double jitter : {0.1, 0.25}) {
      const Mesh shape = even_mesh(2 * nodes, jitter);
      const auto count = static_cast<double>(shape.vertex_slots());
      fmt::print("| {} | {} ", shape.vertex_slots(), jitter);
      MatchingOptions options;
      options.search = false;
      const Run tree = run_matching(even_mesh(2 * nodes, jitter), options);
      fmt::print("| {:.2f} ", 100 * static_cast<double>(tree.steiner) / count);
      options.search = true;
      for (const int sweeps : {0, 100, 300}) {
        options.searching.annealing_sweeps = sweeps;
        const Run run = run_matching(even_mesh(2 * nodes, jitter), options);
        fmt::print("| {:.2f} | {:.3f} | {:.4f} ", 100 * static_cast<double>(run.steiner) / count, run.search,
                   run.quality.mean);
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
  quarry::parallel::with_threads(threads, [&] {
    quarry::print_first_table(largest, threads);
    quarry::print_weighted_row();
    quarry::print_second_table();
  });
  return 0;
}
