#include "kernels/linework/noding.hpp"

#include <cmath>
#include <numbers>
#include <tuple>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "engine/geometry/segment.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/linework/conflicts.hpp"
#include "kernels/linework/lonely_points.hpp"
#include "kernels/linework/narrow_wedges.hpp"
#include "kernels/linework/node_places.hpp"
#include "kernels/linework/stray_paths.hpp"

namespace quarry::linework {
namespace {

// Where bending does not settle the hits in this many rounds in a row, the paths are laid anew.
constexpr std::uint32_t kRoundsOfBending = 32;
// Dense soups take a few dozen rounds, one in ten thousand up to a hundred; more than this is an error.
constexpr std::uint32_t kRounds = 256;
// Each closes every other wedge of a fan.
constexpr std::uint32_t kRoundsOfWedges = 8;

constexpr std::size_t kCrossingsPerChunk = 512;

class Noder {
 public:
  Noder(PathNetwork& network, const CleanOptions& options, double budget, CleanCounts& counts)
      : network_(network),
        snap_(options.snap),
        closed_wedge_(options.closed_wedge * std::numbers::pi / 180),
        counts_(counts),
        places_(network, std::numbers::sqrt2 * snap_),
        stray_(network, places_, snap_, budget, counts),
        search_(network, snap_) {}

  void run(const Progress& progress) {
    for (;;) {
      progress.throw_if_cancelled();
      network_.build_edges();
      if (network_.edges.empty()) return;
      search_.update();
      const bool settled = !snap_nodes(search_.segments()) && !node_crossings(search_.segments());
      if (!stray_.lay_anew({}) && settled && !close_wedges()) return;
      ++counts_.rounds;
    }
  }

 private:
  bool may_move_to(const Hit& hit) const {
    if (places_.on_outline(hit.node)) return false;
    return network_.edges[hit.edge].outline ||
           (places_.ends_one_path(hit.node) && network_.degree[hit.node.value()] == 1 &&
            network_.marked[hit.node.value()] == 0);
  }

  bool snap_nodes(const std::vector<Segment>& segments) {
    const std::vector<Hit> hits = search_.hits();
    if (hits.empty()) return false;
    require_rounds(network_.nodes[hits.front().node]);
    if (bending_rounds_ == 0) {
      bending_rounds_ = kRoundsOfBending;
      if (stray_.lay_anew(hits)) return true;
    }
    if (bending_rounds_ > 0) --bending_rounds_;
    std::vector<Insertion> insertions;
    places_.begin_merging();
    for (std::size_t i = 0; i < hits.size();) {
      std::size_t end = i;
      while (end < hits.size() && hits[end].node == hits[i].node) ++end;
      move_onto_nearest(std::span(hits).subspan(i, end - i), segments);
      for (; i < end; ++i) insertions.push_back(insertion_of(hits[i].node, hits[i].edge, segments));
    }
    counts_.bends += static_cast<std::uint32_t>(insertions.size());
    network_.insert(insertions);
    places_.finish_merging();
    stray_.anchor();
    return true;
  }

  Insertion insertion_of(NodeId node, std::uint32_t edge, const std::vector<Segment>& segments) const {
    return {edge, projection_parameter(network_.nodes[node], segments[edge].from, segments[edge].to), node};
  }

  // Moves the node of these hits onto the nearest of the edges that it may move to, the outline before
  // others.
  void move_onto_nearest(std::span<const Hit> hits, const std::vector<Segment>& segments) {
    const Hit* best = nullptr;
    const auto rank = [&](const Hit& hit) {
      return std::tuple(!network_.edges[hit.edge].outline, hit.squared, hit.edge);
    };
    for (const Hit& hit : hits)
      if (may_move_to(hit) && (best == nullptr || rank(hit) < rank(*best))) best = &hit;
    if (best == nullptr) return;
    const Segment& edge = segments[best->edge];
    places_.move(best->node, closest_point(network_.nodes[best->node], edge.from, edge.to),
                 network_.edges[best->edge].outline);
  }

  void require_rounds(Vec2 place) const {
    if (counts_.rounds < kRounds) return;
    throw Error(
        ErrorKind::kGeometry,
        fmt::format("near {} the lines are too dense to be told apart at the snapping distance of {:g}; "
                    "give a smaller size or --snap",
                    format_point(place.x, place.y), snap_));
  }

  bool node_crossings(const std::vector<Segment>& segments) {
    const std::vector<Crossing> crossings = search_.crossings();
    if (crossings.empty()) return false;
    require_rounds(segments[crossings.front().first].from);
    bending_rounds_ = kRoundsOfBending;
    places_.begin_merging();
    std::vector<Vec2> points(crossings.size());
    parallel::for_each(
        points.size(), [&](std::size_t i) { points[i] = point_of(crossings[i], segments); },
        kCrossingsPerChunk);
    std::vector<std::uint8_t> lonely = lonely_points(points, places_.apart());
    parallel::for_each(
        points.size(),
        [&](std::size_t i) { lonely[i] = lonely[i] != 0 && !places_.nearest(points[i]).valid(); },
        kCrossingsPerChunk);
    // Nodes are made and joined one after the other; where nothing is near, that is all.
    std::vector<NodeId> nodes(crossings.size());
    std::vector<Insertion> insertions(2 * crossings.size());
    for (std::size_t i = 0; i < crossings.size(); ++i) {
      nodes[i] =
          lonely[i] != 0 ? add_crossing(crossings[i], points[i]) : node_of_crossing(crossings[i], points[i]);
      // Before another crossing moves the node.
      if (lonely[i] == 0) set_insertions(crossings[i], nodes[i], segments, &insertions[2 * i]);
    }
    parallel::for_each(
        points.size(),
        [&](std::size_t i) {
          if (lonely[i] != 0) set_insertions(crossings[i], nodes[i], segments, &insertions[2 * i]);
        },
        kCrossingsPerChunk);
    std::erase_if(insertions, [](const Insertion& insertion) { return !insertion.node.valid(); });
    network_.insert(insertions);
    places_.finish_merging();
    return true;
  }

  // Whether there was any.
  bool close_wedges() {
    if (wedge_rounds_ == 0 || closed_wedge_ == 0) return false;
    --wedge_rounds_;
    const std::uint32_t closed = close_narrow_wedges(network_, places_, snap_, closed_wedge_);
    counts_.closed_wedges += closed;
    return closed > 0;
  }

  // Two: for both edges, without a node for one that it ends already.
  void set_insertions(const Crossing& crossing, NodeId node, const std::vector<Segment>& segments,
                      Insertion* two) const {
    for (const std::uint32_t e : {crossing.first, crossing.second}) {
      const bool ends = network_.edges[e].from == node || network_.edges[e].to == node;
      *two++ = ends ? Insertion{e, 0, NodeId()} : insertion_of(node, e, segments);
    }
  }

  // Where two edges cross: on the one that is of the outline, if one is.
  Vec2 point_of(const Crossing& crossing, const std::vector<Segment>& segments) const {
    const Segment first = segments[crossing.first];
    const Segment second = segments[crossing.second];
    const Vec2 x = crossing_point(first.from, first.to, second.from, second.to);
    if (network_.edges[crossing.first].outline) return closest_point(x, first.from, first.to);
    if (network_.edges[crossing.second].outline) return closest_point(x, second.from, second.to);
    return x;
  }

  bool crosses_outline(const Crossing& crossing) const {
    return network_.edges[crossing.first].outline || network_.edges[crossing.second].outline;
  }

  NodeId add_crossing(const Crossing& crossing, Vec2 x) {
    ++counts_.crossings;
    return places_.add(x, crosses_outline(crossing));
  }

  // An existing node near the crossing, or a new one.
  NodeId node_of_crossing(const Crossing& crossing, Vec2 x) {
    const NodeId near = places_.nearest(x);
    if (!near.valid()) return add_crossing(crossing, x);
    if (!crosses_outline(crossing) || places_.on_outline(near)) return near;
    // Rather the node onto the outline than the outline through the node.
    return places_.put_on_outline(near, x);
  }

  PathNetwork& network_;
  double snap_;
  double closed_wedge_;  // radians
  CleanCounts& counts_;
  NodePlaces places_;
  StrayPaths stray_;
  ConflictSearch search_;
  std::uint32_t bending_rounds_ = kRoundsOfBending;
  std::uint32_t wedge_rounds_ = kRoundsOfWedges;
};

}  // namespace

void node_and_snap(PathNetwork& network, const CleanOptions& options, double budget, CleanCounts& counts,
                   const Progress& progress) {
  Noder(network, options, budget, counts).run(progress);
}

}  // namespace quarry::linework
