#include "kernels/linework/stray_paths.hpp"

#include <algorithm>
#include <numbers>

#include "engine/geometry/segment.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/linework/gather.hpp"
#include "kernels/linework/nearest_course.hpp"
#include "kernels/linework/raw_stretch.hpp"

namespace quarry::linework {
namespace {

// How far an edge may be from its raw stretch before it is anchored, in snapping distances: more than the
// sqrt(2) that joining points to nodes can make.
constexpr double kDrift = 1.75;
// How far before its path is laid anew, in snapping distances: more than what laying it and bending it once
// make, so that this is not done over and over.
constexpr double kTooFar = 3;

constexpr std::size_t kCheckedPerChunk = 256;

// Whether a parameter lies between steps i and i + 1.
bool is_between(const Path& path, std::size_t i, double at) {
  return at > path.steps[i].at && at < path.steps[i + 1].at;
}

}  // namespace

StrayPaths::StrayPaths(PathNetwork& network, NodePlaces& places, double snap, double budget,
                       CleanCounts& counts)
    : network_(network),
      places_(places),
      snap_(snap),
      too_far_(std::min(budget, kTooFar * snap)),
      counts_(counts),
      anchors_(origin_of(network.raw), places.apart()) {}

template <class Holds>
std::vector<std::uint32_t> StrayPaths::paths_where(Holds&& holds) const {
  return gather<std::uint32_t>(network_.paths.size(),
                               [&](std::size_t begin, std::size_t end, std::vector<std::uint32_t>& found) {
                                 std::vector<std::uint8_t> scratch;
                                 for (std::size_t p = begin; p < end; ++p)
                                   if (holds(p, scratch)) found.push_back(static_cast<std::uint32_t>(p));
                               });
}

bool StrayPaths::lay_anew(std::span<const Hit> stuck) {
  std::vector<std::uint8_t> stuck_edges(stuck.empty() ? 0 : network_.edges.size(), 0);
  for (const Hit& hit : stuck) stuck_edges[hit.edge] = 1;
  const auto mark = [&](std::size_t p, std::vector<std::uint8_t>& marked) {
    return mark_far_edges(p, stuck_edges, marked);
  };
  check();
  bool changed = false;
  std::vector<std::uint8_t> marked;
  // Laying one anew changes no other.
  for (const std::uint32_t p : paths_where(mark))
    if (mark(p, marked) && lay_path_anew(network_.paths[p], marked)) changed = true;
  return changed;
}

void StrayPaths::check() {
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

bool StrayPaths::mark_far_edges(std::size_t p, const std::vector<std::uint8_t>& stuck_edges,
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

double StrayPaths::deviation_of(const Path& path, std::size_t i) const {
  const PathStep& from = path.steps[i];
  const PathStep& to = path.steps[i + 1];
  return deviation(network_.raw[path.raw].points, from.at, to.at, network_.nodes[from.node],
                   network_.nodes[to.node]);
}

bool StrayPaths::lay_path_anew(Path& path, const std::vector<std::uint8_t>& marked) {
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

void StrayPaths::anchor() {
  const auto drifts = [&](std::size_t p, std::vector<std::uint8_t>&) {
    const Path& path = network_.paths[p];
    if (network_.raw[path.raw].rigid || path.checked) return false;
    for (std::size_t i = 0; i + 1 < path.steps.size(); ++i)
      if (is_between(path, i, anchor_parameter(path, i))) return true;
    return false;
  };
  // Anchoring one changes no other, but for nodes that another then need not add.
  for (const std::uint32_t p : paths_where(drifts)) anchor_path(network_.paths[p]);
}

void StrayPaths::anchor_path(Path& path) {
  for (std::size_t i = 0; i + 1 < path.steps.size(); ++i) {
    const double at = anchor_parameter(path, i);
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

double StrayPaths::anchor_parameter(const Path& path, std::size_t i) const {
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

}  // namespace quarry::linework
