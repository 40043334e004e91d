#include "kernels/deferred/deferred.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "engine/geometry/hilbert.hpp"
#include "engine/parallel/parallel.hpp"
#include "engine/parallel/sort.hpp"
#include "kernels/deferred/insert_nodes.hpp"
#include "kernels/deferred/insert_pieces.hpp"
#include "kernels/deferred/locate.hpp"

namespace quarry {
namespace {

// Constants of the two passes, part of the output: chosen for two to sixteen threads, see docs/results.md.
constexpr PassOptions kNodePass{.window = 8192, .cutoff = 4};
constexpr PassOptions kPiecePass{.window = 8192, .cutoff = 4};

// The ids from begin to end along a Hilbert curve.
template <class IdType>
std::vector<IdType> hilbert_list(std::size_t begin, std::size_t end, const Box2& box, const auto& point_of) {
  std::vector<std::uint64_t> keys(end - begin);
  parallel::for_each(keys.size(),
                     [&](std::size_t i) { keys[i] = hilbert_key(point_of(IdType(begin + i)), box); });
  std::vector<IdType> list;
  list.reserve(keys.size());
  for (const std::uint32_t i : parallel::sorted_order(std::move(keys))) list.push_back(IdType(begin + i));
  return list;
}

void add_events(DeferredReport& report, const deferred::Events& events) {
  report.attractions += events.attractions;
  report.taken += events.taken;
  report.flips += events.flips;
  report.splits += events.splits;
  report.fallbacks += events.fallbacks;
  report.rebuilt += events.rebuilt;
  report.most_tries = std::max<std::uint64_t>(report.most_tries, events.most_tries);
}

void check_all_reached(const deferred::State& state) {
  for (const NodeId node : IdRange<NodeId>(state.lines.nodes.size())) {
    if (state.vertex_of_node[node].valid()) continue;
    const Vec2 p = state.lines.nodes[node];
    throw Error(
        ErrorKind::kGeometry,
        fmt::format("the point {} lies outside the start mesh or on another line: clean the lines, or start "
                    "from a mesh that covers them",
                    format_point(p.x, p.y)));
  }
}

void check_all_connected(const deferred::State& state, const Mesh& mesh) {
  for (const PieceId piece : IdRange<PieceId>(state.lines.pieces.size())) {
    if (state.front[piece] == state.vertex_of_node[state.lines.pieces[piece].to]) continue;
    const Vec2 a = state.from(piece), b = state.to(piece), p = mesh.point(state.front[piece]);
    throw Error(
        ErrorKind::kGeometry,
        fmt::format(
            "the line {} - {} meets another line at {} where they share no point: clean the lines first",
            format_point(a.x, a.y), format_point(b.x, b.y), format_point(p.x, p.y)));
  }
}

}  // namespace

DeferredOptions paper_options(double spacing) {
  DeferredOptions options;
  options.spacing = spacing;
  options.max_distortion = 0.35;
  options.sweeps = 10;
  options.inverse_length_weights = true;
  options.guard_star_minimum = false;
  options.use_flips = false;
  options.several_targets = false;
  options.wedge_relative = false;
  options.quality_relaxation = 1;
  return options;
}

InsertedLines insert_lines(Mesh& mesh, const NodedLines& lines, const DeferredOptions& options,
                           DeferredReport& report, const Progress& progress, const InsertedLines& before) {
  deferred::State state(lines, options, ConstraintTags::of(mesh));
  const std::size_t old_nodes = before.vertex_of_node.size();
  for (const NodeId node : IdRange<NodeId>(old_nodes))
    state.vertex_of_node[node] = before.vertex_of_node[node];
  const Box2 box = mesh.box();

  progress.report("nodes", 0);
  const deferred::VertexGrid grid(mesh);
  const auto nodes =
      hilbert_list<NodeId>(old_nodes, lines.nodes.size(), box, [&](NodeId n) { return lines.nodes[n]; });
  for (const NodeId node : nodes) state.near_node[node] = grid.near(lines.nodes[node]);
  PassOptions pass = kNodePass;
  pass.max_faces = options.max_faces;
  report.nodes = run_pass(mesh, deferred::NodeInsertion(state), nodes, pass, progress);
  report.nodes.name = "nodes";
  check_all_reached(state);

  progress.report("lines", 0);
  for (const PieceId piece : IdRange<PieceId>(lines.pieces.size()))
    state.front[piece] = state.vertex_of_node[piece.value() < before.pieces ? lines.pieces[piece].to
                                                                            : lines.pieces[piece].from];
  const auto pieces = hilbert_list<PieceId>(before.pieces, lines.pieces.size(), box,
                                            [&](PieceId p) { return state.from(p); });
  pass = kPiecePass;
  pass.max_faces = options.max_faces;
  report.pieces = run_pass(mesh, deferred::PieceInsertion(state), pieces, pass, progress);
  report.pieces.name = "lines";
  check_all_connected(state, mesh);

  for (const deferred::Events& events : state.node_events) add_events(report, events);
  for (const deferred::Events& events : state.piece_events) add_events(report, events);
  return {std::move(state.vertex_of_node), lines.pieces.size()};
}

}  // namespace quarry
