#include "bench/boost_matching.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/max_cardinality_matching.hpp>
#include <boost/graph/maximum_weighted_matching.hpp>
#include <ctime>

#include "engine/mesh/constraint.hpp"
#include "kernels/matching/merge_cost.hpp"
#include "kernels/matching/spanning_forest.hpp"

namespace quarry::bench {
namespace {

using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property,
                                    boost::property<boost::edge_weight_t, double>>;

// Calls visit(face, face, shape) for each pair of triangles that may be merged.
template <class Visit>
void for_each_pair(const Mesh& mesh, const Visit& visit) {
  const std::vector<float> shapes = pair_shapes(mesh, ConstraintTags::of(mesh));
  for (const FaceId f : mesh.faces()) {
    for (int k = 0; k < 3; ++k) {
      const SideId s(f, k);
      if (shapes[s.value()] <= kNoArc || mesh.neighbour(s) < s) continue;
      visit(f.value(), mesh.neighbour(s).face().value(), static_cast<double>(shapes[s.value()]));
    }
  }
}

template <class Match>
PeerMatching run_peer(const Mesh& mesh, const Match& match) {
  Graph graph(mesh.face_slots());
  for_each_pair(mesh, [&](std::uint32_t a, std::uint32_t b, double shape) {
    boost::add_edge(a, b, 2.0 + shape, graph);
  });
  std::vector<boost::graph_traits<Graph>::vertex_descriptor> mate(mesh.face_slots());
  PeerMatching peer;
  const std::clock_t began = std::clock();
  match(graph, mate);
  peer.seconds = static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC;
  for_each_pair(mesh, [&](std::uint32_t a, std::uint32_t b, double shape) {
    if (mate[a] != b) return;
    ++peer.pairs;
    peer.mean += shape;
    peer.smallest = std::min(peer.smallest, shape);
  });
  peer.mean /= static_cast<double>(peer.pairs);
  return peer;
}

}  // namespace

PeerMatching boost_cardinality_matching(const Mesh& mesh) {
  return run_peer(mesh, [](const Graph& graph, auto& mate) {
    boost::edmonds_maximum_cardinality_matching(graph, mate.data());
  });
}

PeerMatching boost_weighted_matching(const Mesh& mesh) {
  return run_peer(
      mesh, [](const Graph& graph, auto& mate) { boost::maximum_weighted_matching(graph, mate.data()); });
}

}  // namespace quarry::bench
