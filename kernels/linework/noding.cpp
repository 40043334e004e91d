#include "kernels/linework/noding.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "engine/geometry/segment.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/linework/conflicts.hpp"
#include "kernels/linework/gather.hpp"
#include "kernels/linework/lonely_points.hpp"
#include "kernels/linework/narrow_wedges.hpp"
#include "kernels/linework/nearest_course.hpp"
#include "kernels/linework/node_buckets.hpp"
#include "kernels/linework/node_places.hpp"
#include "kernels/linework/place_order.hpp"
#include "kernels/linework/raw_stretch.hpp"

namespace quarry::linework {
namespace {

// Where bending does not settle the hits in this many rounds in a row, the paths are laid anew.
constexpr std::uint32_t kRoundsOfBending = 32;
// Dense soups take a few dozen rounds, one in ten thousand up to a hundred; more than this is an error.
constexpr std::uint32_t kRounds = 256;
// How far an edge may be from its raw stretch before it is anchored, in snapping distances: more than the
// sqrt(2) that joining points to nodes can make.
constexpr double kDrift = 1.75;
// How far before its path is laid anew, in snapping distances: more than what laying it and bending it once
// make, so that this is not done over and over.
constexpr double kTooFar = 3;

// Each closes every other wedge of a fan.
constexpr std::uint32_t kRoundsOfWedges = 8;

constexpr std::size_t kCheckedPerChunk = 256;
constexpr std::size_t kCrossingsPerChunk = 512;

// Somewhere among the points, so that offsets from it are small.
Vec2 origin_of(const std::vector<RawLine>& raw) {
  Vec2 origin;
  for (const RawLine& line : raw)
    if (!line.points.empty()) origin = line.points.front();
  return origin;
}

class Noder {
 public:
  Noder(PathNetwork& network, const CleanOptions& options, double budget, CleanCounts& counts)
      : network_(network),
        snap_(options.snap),
        closed_wedge_(options.closed_wedge * std::numbers::pi / 180),
        too_far_(std::min(budget, kTooFar * snap_)),
        counts_(counts),
        places_(network, std::numbers::sqrt2 * snap_),
        anchors_(origin_of(network.raw), places_.apart()),
        search_(network, snap_) {}

  void run(const Progress& progress) {
    for (;;) {
      progress.throw_if_cancelled();
      network_.build_edges();
      if (network_.edges.empty()) return;
      search_.update();
      const bool settled = !snap_nodes(search_.segments()) && !node_crossings(search_.segments());
      if (!lay_far_paths_anew({}) && settled && !close_wedges()) return;
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
      if (lay_far_paths_anew(hits)) return true;
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
    anchor_drifting_paths();
    return true;
  }

  // Lays paths anew around edges that are too far from the stretches they stand for, and around these stuck
  // edges; whether that changed any path.
  bool lay_far_paths_anew(std::span<const Hit> stuck) {
    std::vector<std::uint8_t> stuck_edges(stuck.empty() ? 0 : network_.edges.size(), 0);
    for (const Hit& hit : stuck) stuck_edges[hit.edge] = 1;
    const auto mark = [&](std::size_t p, std::vector<std::uint8_t>& marked) {
      return mark_far_edges(p, stuck_edges, marked);
    };
    check_paths();
    bool changed = false;
    std::vector<std::uint8_t> marked;
    // Laying one anew changes no other.
    for (const std::uint32_t p : paths_where(mark))
      if (mark(p, marked) && lay_anew(network_.paths[p], marked)) changed = true;
    return changed;
  }

  // Most paths stay as they are from one round to the next, and need not be measured again.
  void check_paths() {
    parallel::for_each(
        network_.paths.size(),
        [&](std::size_t p) {
          Path& path = network_.paths[p];
          if (path.checked) return;
          const double limit = std::min(too_far_, kDrift * snap_);
          path.checked = true;
          for (std::size_t i = 0; i + 1 < path.steps.size() && path.checked; ++i)
            path.checked = deviation_of(path, i) <= limit;
        },
        kCheckedPerChunk);
  }

  // Marks the edges of a path that are to be laid anew; whether there are any.
  bool mark_far_edges(std::size_t p, const std::vector<std::uint8_t>& stuck_edges,
                      std::vector<std::uint8_t>& marked) const {
    const Path& path = network_.paths[p];
    if (network_.raw[path.raw].rigid || path.steps.size() < 2) return false;
    if (path.checked && stuck_edges.empty()) return false;
    marked.assign(path.steps.size() - 1, 0);
    bool any = false;
    for (std::size_t i = 0; i < marked.size(); ++i) {
      const bool is_stuck =
          !stuck_edges.empty() && stuck_edges[network_.edge_of_step[network_.edge_begin[p] + i]] != 0;
      marked[i] = is_stuck || (!path.checked && deviation_of(path, i) > too_far_) ? 1 : 0;
      any = any || marked[i] != 0;
    }
    return any;
  }

  // The paths of which holds(path number, scratch) is true, ascending.
  template <class Holds>
  std::vector<std::uint32_t> paths_where(Holds&& holds) const {
    return gather<std::uint32_t>(network_.paths.size(),
                                 [&](std::size_t begin, std::size_t end, std::vector<std::uint32_t>& found) {
                                   std::vector<std::uint8_t> scratch;
                                   for (std::size_t p = begin; p < end; ++p)
                                     if (holds(p, scratch)) found.push_back(static_cast<std::uint32_t>(p));
                                 });
  }

  double deviation_of(const Path& path, std::size_t i) const {
    const PathStep& from = path.steps[i];
    const PathStep& to = path.steps[i + 1];
    return deviation(network_.raw[path.raw].points, from.at, to.at, network_.nodes[from.node],
                     network_.nodes[to.node]);
  }

  bool lay_anew(Path& path, const std::vector<std::uint8_t>& marked) {
    const std::span<const Vec2> raw = network_.raw[path.raw].points;
    const auto node_at = [&](Vec2 p) { return places_.at(p, path.outline); };
    const std::vector<PathStep> before = path.steps;
    const std::vector<Window> windows = windows_around(network_, path, marked, std::numbers::sqrt2 * snap_);
    for (PathStep* end : {&path.steps.front(), &path.steps.back()}) {
      const Vec2 p = raw_point(raw, end->at);
      if (distance(p, network_.nodes[end->node]) > too_far_) end->node = node_at(p);
    }
    std::vector<PathStep> steps;
    std::size_t next = 0;  // step of the path that follows
    for (const Window& window : windows) {
      for (; next <= window.first; ++next) steps.push_back(path.steps[next]);
      pin_course(places_, network_, path, window);
      const auto laid = nearest_course(places_, raw, path.steps[window.first].at, path.steps[window.last].at);
      steps.insert(steps.end(), laid.begin(), laid.end());
      next = window.last;
    }
    for (; next < path.steps.size(); ++next) steps.push_back(path.steps[next]);
    path.steps = std::move(steps);
    path.checked = false;
    network_.drop_repeated_steps(path);
    const bool changed = !std::equal(before.begin(), before.end(), path.steps.begin(), path.steps.end(),
                                     [](const PathStep& a, const PathStep& b) { return a.node == b.node; });
    if (changed) ++counts_.reroutes;
    return changed;
  }

  // A long edge that is bent through one node after another of a line that slowly leaves it would be drawn
  // along with that line (the drift of iterated snap rounding: Packer 2008). Where an edge is too far from
  // the stretch that it stands for, the path is brought back to the raw line by a node on it.
  void anchor_drifting_paths() {
    const auto drifts = [&](std::size_t p, std::vector<std::uint8_t>&) {
      const Path& path = network_.paths[p];
      if (network_.raw[path.raw].rigid || path.checked) return false;
      for (std::size_t i = 0; i + 1 < path.steps.size(); ++i)
        if (is_between(path, i, anchor(path, i))) return true;
      return false;
    };
    // Anchoring one changes no other, but for nodes that another then need not add.
    for (const std::uint32_t p : paths_where(drifts)) anchor_path(network_.paths[p]);
  }

  void anchor_path(Path& path) {
    for (std::size_t i = 0; i + 1 < path.steps.size(); ++i) {
      const double at = anchor(path, i);
      if (!is_between(path, i, at)) continue;
      const Vec2 place = raw_point(network_.raw[path.raw].points, at);
      // Where one was and did not stay, as beside the outline, another would not.
      if (places_.nearest(place).valid() || anchors_.nearest(place).valid()) continue;
      const NodeId node = places_.add(place, path.outline);
      anchors_.insert(node, place);
      path.checked = false;
      path.steps.insert(path.steps.begin() + static_cast<std::ptrdiff_t>(i) + 1, {node, at});
      ++counts_.anchors;
    }
  }

  static bool is_between(const Path& path, std::size_t i, double at) {
    return at > path.steps[i].at && at < path.steps[i + 1].at;
  }

  // The parameter at which a path should return to its raw line between two steps; that of the first if it
  // need not.
  double anchor(const Path& path, std::size_t i) const {
    const PathStep& from = path.steps[i];
    const PathStep& to = path.steps[i + 1];
    const Vec2 a = network_.nodes[from.node];
    const Vec2 b = network_.nodes[to.node];
    const double limit = kDrift * snap_;
    const std::span<const Vec2> raw = network_.raw[path.raw].points;
    if (distance(a, b) < 2 * limit || deviation(raw, from.at, to.at, a, b) <= limit) return from.at;
    const double from_gap = distance(raw_point(raw, from.at), a);
    const double to_gap = distance(raw_point(raw, to.at), b);
    // As far along as will not make a sharp corner of it.
    if (std::max(from_gap, to_gap) > limit)
      return from_gap > to_gap ? advance(raw, from.at, to.at, 3 * from_gap)
                               : advance(raw, to.at, from.at, 3 * to_gap);
    return farthest_vertex(raw, from.at, to.at, a, b);
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
  double too_far_;
  CleanCounts& counts_;
  NodePlaces places_;
  NodeBuckets anchors_;  // the places of all that were put
  ConflictSearch search_;
  std::uint32_t bending_rounds_ = kRoundsOfBending;
  std::uint32_t wedge_rounds_ = kRoundsOfWedges;
};

// Points become nodes one after the other, unless a node is near. That takes one thread, but most points have
// no other near them: those are found first, by all, and need not be looked up.
class Clustering {
 public:
  Clustering(std::vector<RawLine> raw, double apart) : apart_(apart), buckets_(origin_of(raw), apart) {
    network_.raw = std::move(raw);
    for (const RawLine& line : network_.raw) {
      begin_.push_back(points_.size());
      points_.insert(points_.end(), line.points.begin(), line.points.end());
    }
    begin_.push_back(points_.size());
    node_of_.resize(points_.size());
  }

  PathNetwork run() {
    lonely_ = lonely_points(points_, apart_);
    for (std::size_t r = 0; r < network_.raw.size(); ++r)
      if (network_.raw[r].outline)
        for (std::size_t i = begin_[r]; i < begin_[r + 1]; ++i) (void)node_at(i);
    // Rather a line to a point of the input than that to the line.
    for (std::size_t r = 0; r < network_.raw.size(); ++r)
      if (network_.raw[r].point.valid()) (void)node_at(begin_[r]);
    for (std::size_t r = 0; r < network_.raw.size(); ++r)
      if (begin_[r] != begin_[r + 1])
        for (const std::size_t i : {begin_[r], begin_[r + 1] - 1}) (void)node_at(i);
    network_.paths.resize(network_.raw.size());
    for (std::size_t r = 0; r < network_.raw.size(); ++r) {
      Path& path = network_.paths[r];
      path.raw = static_cast<std::uint32_t>(r);
      path.outline = network_.raw[r].outline;
      path.steps.reserve(begin_[r + 1] - begin_[r]);
      for (std::size_t i = begin_[r]; i < begin_[r + 1]; ++i)
        path.steps.push_back({node_at(i), static_cast<double>(i - begin_[r])});
    }
    network_.drop_repeated_steps();
    order_by_place(network_);
    return std::move(network_);
  }

 private:
  NodeId node_at(std::size_t i) {
    NodeId& node = node_of_[i];
    if (lonely_[i] != 0) {
      if (!node.valid()) node = network_.nodes.push_back(points_[i]);
      return node;
    }
    // Asked anew each time: a nearer node may have come since.
    node = buckets_.nearest(points_[i]);
    if (!node.valid()) {
      node = network_.nodes.push_back(points_[i]);
      buckets_.insert(node, points_[i]);
    }
    return node;
  }

  double apart_;
  PathNetwork network_;
  NodeBuckets buckets_;
  std::vector<Vec2> points_;        // of all raw lines
  std::vector<std::size_t> begin_;  // of each raw line in them
  std::vector<std::uint8_t> lonely_;
  std::vector<NodeId> node_of_;
};

}  // namespace

PathNetwork cluster_points(std::vector<RawLine> raw, double snap) {
  return Clustering(std::move(raw), std::numbers::sqrt2 * snap).run();
}

void node_and_snap(PathNetwork& network, const CleanOptions& options, double budget, CleanCounts& counts,
                   const Progress& progress) {
  Noder(network, options, budget, counts).run(progress);
}

}  // namespace quarry::linework
