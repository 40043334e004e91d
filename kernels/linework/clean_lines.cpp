#include "kernels/linework/clean_lines.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <span>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "engine/base/error.hpp"
#include "engine/geometry/hilbert.hpp"
#include "engine/parallel/parallel.hpp"
#include "engine/parallel/sort.hpp"
#include "kernels/linework/clustering.hpp"
#include "kernels/linework/domain.hpp"
#include "kernels/linework/ledger.hpp"
#include "kernels/linework/noding.hpp"
#include "kernels/linework/path_network.hpp"
#include "kernels/linework/repairs.hpp"
#include "kernels/linework/thinning.hpp"

namespace quarry {
namespace {

using linework::Edge;
using linework::Path;
using linework::PathNetwork;
using linework::RawLine;

void require_usable(const CleanOptions& options) {
  for (const double value : {options.snap, options.min_edge, options.tolerance})
    if (!std::isfinite(value) || value < 0)
      throw Error(
          ErrorKind::kUsage,
          fmt::format("snap {}, min-edge {} and tolerance {} must be lengths: finite and not negative",
                      options.snap, options.min_edge, options.tolerance));
  if (!(options.closed_wedge >= 0 && options.closed_wedge <= 30))
    throw Error(ErrorKind::kUsage, fmt::format("wedges are closed below an angle of 0 to 30 degrees, not {}",
                                               options.closed_wedge));
}

double largest_coordinate(const LineSet& lines, const Outline& outline) {
  double largest = 0;
  const auto look_at = [&](Vec2 p) { largest = std::max({largest, std::abs(p.x), std::abs(p.y)}); };
  for (const InputLine& line : lines.lines) std::ranges::for_each(line.points, look_at);
  for (const OutlineRing& ring : outline.rings) std::ranges::for_each(ring.points, look_at);
  for (const InputPoint& point : lines.points) look_at(point.place);
  return largest;
}

// Rings of the outline that are input lines stand for these; every other line follows, then every other ring,
// then the points.
std::vector<RawLine> raw_lines(const LineSet& lines, const Outline& outline) {
  std::vector<RawLine> raw;
  for (const LineId id : IdRange<LineId>(lines.lines.size())) raw.push_back({lines.lines[id].points, id});
  for (const OutlineRing& ring : outline.rings) {
    if (ring.line.valid()) {
      raw[ring.line.value()].outline = true;
      raw[ring.line.value()].polygon = ring.polygon;
    } else {
      raw.push_back({ring.points, LineId(), true, outline.rigid, ring.polygon});
    }
  }
  for (const PointId id : IdRange<PointId>(lines.points.size())) {
    RawLine point{std::span(&lines.points[id].place, 1), LineId()};
    point.rigid = true;
    point.point = id;
    raw.push_back(point);
  }
  return raw;
}

// Lines that are too short to be seen at this snapping distance, with the reason.
std::string reason_for_point(const InputLine& line) {
  if (line.points.empty()) return "has no points";
  const bool one =
      std::all_of(line.points.begin(), line.points.end(), [&](Vec2 p) { return p == line.points[0]; });
  return one ? "has no length" : "lies within the snapping distance of one point";
}

void note_points(const LineSet& lines, const PathNetwork& network, linework::Reasons& reasons) {
  for (const Path& path : network.paths) {
    const LineId line = network.raw[path.raw].line;
    if (line.valid() && path.steps.size() < 2) reasons[line] = reason_for_point(lines.lines[line]);
  }
}

// Nodes in use, in Hilbert order.
std::vector<NodeId> ordered_nodes(const PathNetwork& network) {
  const std::vector<std::uint32_t> used =
      parallel::filter_indices(network.nodes.size(), [&](std::size_t n) { return network.used(NodeId(n)); });
  Box2 box;
  for (const std::uint32_t n : used) box.extend(network.nodes[NodeId(n)]);
  std::vector<std::uint64_t> keys(used.size());
  parallel::for_each(used.size(),
                     [&](std::size_t i) { keys[i] = hilbert_key(network.nodes[NodeId(used[i])], box); });
  std::vector<NodeId> result;
  result.reserve(used.size());
  for (const std::uint32_t i : parallel::sorted_order(std::move(keys))) result.emplace_back(used[i]);
  return result;
}

// renamed: the new number of each node.
NodedLines noded_lines(const PathNetwork& network, IdVector<NodeId, NodeId>& renamed) {
  NodedLines result;
  renamed = IdVector<NodeId, NodeId>(network.nodes.size());
  for (const NodeId node : ordered_nodes(network))
    renamed[node] = result.nodes.push_back(network.nodes[node]);
  const auto ends_of = [&](const Edge& edge) {
    return std::pair(std::minmax(renamed[edge.from], renamed[edge.to]));
  };
  std::vector<std::uint64_t> keys(network.edges.size());
  parallel::for_each(keys.size(), [&](std::size_t e) {
    const auto [from, to] = ends_of(network.edges[e]);
    keys[e] = std::uint64_t{from.value()} << 32 | to.value();
  });
  const linework::LinesAt lines = linework::lines_on_edges(network);
  result.line_begin.push_back(0);
  for (const std::uint32_t e : parallel::sorted_order(std::move(keys))) {
    const auto [from, to] = ends_of(network.edges[e]);
    result.pieces.push_back(
        {from, to, network.edges[e].outline ? PieceKindOf::kOutline : PieceKindOf::kInterior});
    const std::span<const LineId> numbers = lines.at(e);
    result.line_numbers.insert(result.line_numbers.end(), numbers.begin(), numbers.end());
    result.line_begin.push_back(static_cast<std::uint32_t>(result.line_numbers.size()));
  }
  return result;
}

std::string box_text(const Box2& box) {
  return format_point(box.low.x, box.low.y) + " to " + format_point(box.high.x, box.high.y);
}

bool any_line_left(const PathNetwork& network) {
  return std::any_of(network.paths.begin(), network.paths.end(), [&](const Path& path) {
    return network.raw[path.raw].line.valid() && path.steps.size() > 1;
  });
}

bool any_point_left(const PathNetwork& network) {
  return std::any_of(network.paths.begin(), network.paths.end(), [&](const Path& path) {
    return network.raw[path.raw].point.valid() && !path.steps.empty();
  });
}

std::string all_files(const LineSet& lines) {
  return lines.files.empty() ? "input" : fmt::format("{}", fmt::join(lines.files, ", "));
}

void require_lines(const LineSet& lines, const PathNetwork& network, double snap) {
  if (lines.lines.empty() || any_line_left(network)) return;
  throw Error(
      ErrorKind::kInput,
      fmt::format(
          "{}: every line is so short that it is one point at the snapping distance of {:g} (all lie in {}); "
          "give a smaller size or --snap",
          all_files(lines), snap, box_text(lines.box())));
}

void require_lines_inside(const LineSet& lines, const Outline& outline, const PathNetwork& network) {
  if (lines.lines.empty() ? any_point_left(network) : any_line_left(network)) return;
  const char* what = lines.lines.empty() ? "point" : "line";
  Box2 box;
  for (const OutlineRing& ring : outline.rings)
    for (const Vec2 p : ring.points) box.extend(p);
  throw Error(
      ErrorKind::kInput,
      fmt::format("{}: the outline {} holds no part of any {}; the {}s lie in {}; give another boundary",
                  all_files(lines), box_text(box), what, what, box_text(lines.box())));
}

void require_domain(const Outline& outline, const std::vector<linework::EdgePlace>& places) {
  if (std::find(places.begin(), places.end(), linework::EdgePlace::kBoundary) != places.end()) return;
  const OutlineRing ring = outline.rings.empty() ? OutlineRing() : outline.rings[0];
  const Vec2 p = ring.points.empty() ? Vec2{} : ring.points[0];
  throw Error(
      ErrorKind::kInput,
      fmt::format("{}{}the outline near {} has no area at this snapping distance; give a smaller size or "
                  "another boundary",
                  ring.origin, ring.origin.empty() ? "" : ": ", format_point(p.x, p.y)));
}

std::string text_of_sharers(const std::vector<PointId>& points) {
  std::vector<std::uint32_t> numbers;
  for (const PointId id : points) numbers.push_back(id.value());
  return fmt::format("{}", fmt::join(numbers, ", "));
}

// What became of the points: those that came nearer than snap share a node.
IdVector<PointId, PointEntry> point_entries(const LineSet& lines, const PathNetwork& network,
                                            const IdVector<NodeId, NodeId>& renamed,
                                            const NodedLines& noded) {
  IdVector<PointId, PointEntry> entries(lines.points.size());
  for (PointEntry& entry : entries) entry.why = "lies outside the outline";
  std::map<NodeId, std::vector<PointId>> sharers;
  for (const Path& path : network.paths) {
    const PointId id = network.raw[path.raw].point;
    if (!id.valid() || path.steps.empty()) continue;
    PointEntry& entry = entries[id];
    entry.node = renamed[path.steps.front().node];
    entry.moved = distance(lines.points[id].place, noded.nodes[entry.node]);
    entry.why.clear();
    sharers[entry.node].push_back(id);
  }
  for (auto& [node, points] : sharers) {
    if (points.size() < 2) continue;
    std::sort(points.begin(), points.end());
    for (const PointId id : points) entries[id].why = "one vertex for points " + text_of_sharers(points);
  }
  return entries;
}

IdVector<LineId, std::uint32_t> dangles_of_lines(const PathNetwork& network,
                                                 const std::vector<std::uint32_t>& of_raw, std::size_t size) {
  IdVector<LineId, std::uint32_t> result(size);
  for (std::size_t r = 0; r < network.raw.size(); ++r)
    if (network.raw[r].line.valid()) result[network.raw[r].line] = of_raw[r];
  return result;
}

// No invariant is kept at the cost of a line's course: rather no result.
void require_within_budget(const LineSet& lines, const IdVector<LineId, LedgerEntry>& ledger, double budget) {
  for (const LineId id : IdRange<LineId>(ledger.size())) {
    const LedgerEntry& entry = ledger[id];
    if (entry.moved <= budget) continue;
    throw Error(
        ErrorKind::kGeometry,
        fmt::format("{}: feature {}: near {} the lines are so dense that joining them would move this "
                    "one by {:.4g}, beyond the {:.4g} of snap, min-edge and tolerance; give a smaller "
                    "size or --snap",
                    lines.files.empty() ? "input" : lines.files[lines.lines[id].file],
                    lines.lines[id].feature, format_point(entry.moved_at.x, entry.moved_at.y), entry.moved,
                    budget));
  }
}

}  // namespace

CleanedLines clean_lines(const LineSet& lines, const Outline& outline, const CleanOptions& options,
                         const Progress& progress) {
  require_usable(options);
  CleanedLines result;
  result.options = options;
  const double least = 64 * std::numeric_limits<double>::epsilon() * largest_coordinate(lines, outline);
  if (result.options.snap < least) {
    result.options.snap = least;
    result.notes.push_back(fmt::format(
        "snap {:g} is below what the coordinates can tell apart; raised to {:g}", options.snap, least));
  }
  if (result.options.min_edge < result.options.snap) {
    result.options.min_edge = result.options.snap;
    result.notes.push_back(
        fmt::format("min-edge {:g} is below snap, within which points become one; raised to {:g}",
                    options.min_edge, result.options.snap));
  }
  progress.report("clean", 0.0);
  PathNetwork network = linework::cluster_points(raw_lines(lines, outline), result.options.snap);
  linework::Reasons reasons(lines.lines.size());
  note_points(lines, network, reasons);
  const double budget = result.options.snap + result.options.min_edge + result.options.tolerance;
  linework::node_and_snap(network, result.options, budget, result.counts, progress);
  linework::note_lost_lines(network, "was merged into one point with others within the snapping distance",
                            reasons);

  progress.report("clean", 0.5);
  network.build_edges();
  require_lines(lines, network, result.options.snap);
  const auto places = linework::edge_places(network);
  require_domain(outline, places);
  linework::drop_points_outside(network, places);
  const std::vector<double> clipped = linework::clip_to_domain(network, places);
  require_lines_inside(lines, outline, network);
  linework::note_lost_lines(network, "lies outside the outline", reasons);

  progress.report("clean", 0.7);
  const auto cut_dangles = linework::thin_out(network, result.options, result.counts, progress);
  linework::note_lost_lines(network, "what is left of it is shorter than the shortest piece (min-edge)",
                            reasons);
  network.build_edges();
  IdVector<NodeId, NodeId> renamed;
  result.lines = noded_lines(network, renamed);
  progress.report("clean", 0.9);
  require_noded(result.lines, result.options.snap);
  result.ledger = linework::make_ledger(lines, network, clipped, reasons);
  result.points = point_entries(lines, network, renamed, result.lines);
  linework::tell_repairs(lines, dangles_of_lines(network, cut_dangles, lines.lines.size()), result.ledger,
                         result.counts);
  result.counts.nodes = count_classes(classify_nodes(result.lines));
  result.counts.smallest_angle = smallest_angle(result.lines);
  for (const LedgerEntry& entry : result.ledger)
    result.counts.largest_move = std::max(result.counts.largest_move, entry.moved);
  require_within_budget(lines, result.ledger, budget * (1 + 1e-9) + least / 16);
  for (const Piece& piece : result.lines.pieces)
    if (distance(result.lines.nodes[piece.from], result.lines.nodes[piece.to]) < result.options.min_edge)
      ++result.counts.short_pieces;
  progress.report("clean", 1.0);
  return result;
}

}  // namespace quarry
