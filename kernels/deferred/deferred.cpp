#include "kernels/deferred/deferred.hpp"

#include <numeric>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "engine/geometry/hilbert.hpp"
#include "engine/parallel/sort.hpp"
#include "kernels/deferred/insert_nodes.hpp"
#include "kernels/deferred/insert_pieces.hpp"
#include "kernels/deferred/locate.hpp"

namespace quarry {
namespace {

// Constants of the two passes, part of the output: chosen for two to sixteen threads, see docs/results.md.
constexpr PassOptions kNodePass{.window = 8192, .cutoff = 4};
constexpr PassOptions kPiecePass{.window = 8192, .cutoff = 4};

template <class IdType>
std::vector<IdType> hilbert_list(std::size_t size, const Box2& box, const auto& point_of) {
  std::vector<std::uint64_t> keys(size);
  for (std::size_t i = 0; i < size; ++i) keys[i] = hilbert_key(point_of(IdType(i)), box);
  std::vector<IdType> list;
  list.reserve(size);
  for (const std::uint32_t i : parallel::sorted_order(std::move(keys))) list.push_back(IdType(i));
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
    throw Error(ErrorKind::kGeometry,
                fmt::format("the point {} lies outside the start mesh or on another line: clean the lines, or start "
                            "from a mesh that covers them",
                            format_point(p.x, p.y)));
  }
}

void check_all_connected(const deferred::State& state, const Mesh& mesh) {
  for (const PieceId piece : IdRange<PieceId>(state.lines.pieces.size())) {
    if (state.front[piece] == state.vertex_of_node[state.lines.pieces[piece].to]) continue;
    const Vec2 a = state.from(piece), b = state.to(piece), p = mesh.point(state.front[piece]);
    throw Error(ErrorKind::kGeometry,
                fmt::format("the line {} - {} meets another line at {} where they share no point: clean the lines first",
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

InsertedLines insert_lines(Mesh& mesh, const NodedLines& lines, const DeferredOptions& options, DeferredReport& report,
                           const Progress& progress) {
  deferred::State state(lines, options, ConstraintTags::of(mesh));
  const Box2 box = mesh.box();
  const deferred::VertexGrid grid(mesh);
  for (const NodeId node : IdRange<NodeId>(lines.nodes.size())) state.near_node[node] = grid.near(lines.nodes[node]);

  const auto nodes = hilbert_list<NodeId>(lines.nodes.size(), box, [&](NodeId n) { return lines.nodes[n]; });
  progress.report("nodes", 0);
  report.nodes = run_pass(mesh, deferred::NodeInsertion(state), nodes, kNodePass, progress);
  report.nodes.name = "nodes";
  check_all_reached(state);

  for (const PieceId piece : IdRange<PieceId>(lines.pieces.size()))
    state.front[piece] = state.vertex_of_node[lines.pieces[piece].from];
  const auto pieces = hilbert_list<PieceId>(lines.pieces.size(), box, [&](PieceId p) { return state.from(p); });
  progress.report("lines", 0);
  report.pieces = run_pass(mesh, deferred::PieceInsertion(state), pieces, kPiecePass, progress);
  report.pieces.name = "lines";
  check_all_connected(state, mesh);

  for (const deferred::Events& events : state.node_events) add_events(report, events);
  for (const deferred::Events& events : state.piece_events) add_events(report, events);
  return {std::move(state.vertex_of_node)};
}

}  // namespace quarry
