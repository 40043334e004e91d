#include "kernels/linework/linked_paths.hpp"

#include <algorithm>

#include "kernels/linework/raw_stretch.hpp"

namespace quarry::linework {

namespace {

// How many steps of all paths are at each node.
std::vector<std::uint32_t> count_steps(const PathNetwork& network) {
  std::vector<std::uint32_t> counts(network.nodes.size(), 0);
  for (const Path& path : network.paths)
    for (const PathStep& step : path.steps) ++counts[step.node.value()];
  return counts;
}

}  // namespace

LinkedPaths::LinkedPaths(PathNetwork& network) : network_(network), steps_at_(count_steps(network)) {
  for (std::size_t p = 0; p < network.paths.size(); ++p) {
    const Path& path = network.paths[p];
    const auto base = static_cast<std::uint32_t>(steps_.size());
    const auto count = static_cast<std::uint32_t>(path.steps.size());
    first_.push_back(count == 0 ? kNone : base);
    for (std::uint32_t i = 0; i < count; ++i) {
      steps_at_.add(path.steps[i].node.value(), base + i);
      steps_.push_back({path.steps[i].node, static_cast<std::uint32_t>(p), i == 0 ? kNone : base + i - 1,
                        i + 1 == count ? kNone : base + i + 1, path.steps[i].at});
    }
  }
}

void LinkedPaths::write_back() {
  for (std::size_t p = 0; p < first_.size(); ++p) {
    std::vector<PathStep>& steps = network_.paths[p].steps;
    steps.clear();
    for (std::uint32_t s = first_[p]; s != kNone; s = steps_[s].after)
      steps.push_back({steps_[s].node, steps_[s].at});
  }
}

const RawLine& LinkedPaths::raw_of(std::uint32_t step) const {
  return network_.raw[network_.paths[steps_[step].path].raw];
}

bool LinkedPaths::outline(std::uint32_t step) const { return network_.paths[steps_[step].path].outline; }

double LinkedPaths::deviation(std::uint32_t from, std::uint32_t to) const {
  return linework::deviation(raw_of(from).points, steps_[from].at, steps_[to].at,
                             network_.nodes[steps_[from].node], network_.nodes[steps_[to].node]);
}

double LinkedPaths::deviation_if_moved(std::uint32_t step, NodeId node) const {
  const Step& s = steps_[step];
  const std::span<const Vec2> points = raw_of(step).points;
  const Vec2 p = network_.nodes[node];
  double worst = length(raw_point(points, s.at) - p);
  if (s.before != kNone) {
    const Step& before = steps_[s.before];
    worst = std::max(worst, linework::deviation(points, before.at, s.at, network_.nodes[before.node], p));
  }
  if (s.after != kNone) {
    const Step& after = steps_[s.after];
    worst = std::max(worst, linework::deviation(points, s.at, after.at, p, network_.nodes[after.node]));
  }
  return worst;
}

bool LinkedPaths::joined(NodeId a, NodeId b) const {
  if (at(b).size() < at(a).size()) std::swap(a, b);
  for (const std::uint32_t step : at(a)) {
    if (before(step) != kNone && node_before(step) == b) return true;
    if (after(step) != kNone && node_after(step) == b) return true;
  }
  return false;
}

bool LinkedPaths::alone(NodeId node) const {
  return !marked(node) && std::all_of(at(node).begin(), at(node).end(), [&](std::uint32_t step) {
    return before(step) == kNone && after(step) == kNone;
  });
}

bool LinkedPaths::marked(NodeId node) const {
  return std::any_of(at(node).begin(), at(node).end(),
                     [&](std::uint32_t step) { return raw_of(step).point.valid(); });
}

std::vector<NodeId> LinkedPaths::neighbours(NodeId node) const {
  std::vector<NodeId> result;
  for (const std::uint32_t step : at(node)) {
    if (before(step) != kNone) result.push_back(node_before(step));
    if (after(step) != kNone) result.push_back(node_after(step));
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

bool LinkedPaths::on_outline(NodeId node) const {
  return std::any_of(at(node).begin(), at(node).end(), [&](std::uint32_t step) { return outline(step); });
}

std::vector<NodeId> LinkedPaths::outline_neighbours(NodeId node) const {
  std::vector<NodeId> result;
  for (const std::uint32_t step : at(node)) {
    if (!outline(step)) continue;
    if (before(step) != kNone) result.push_back(node_before(step));
    if (after(step) != kNone) result.push_back(node_after(step));
  }
  std::sort(result.begin(), result.end());
  return result;
}

bool LinkedPaths::joined_by_outline(NodeId a, NodeId b) const {
  const std::vector<NodeId> others = outline_neighbours(a);
  return std::binary_search(others.begin(), others.end(), b);
}

bool LinkedPaths::share_outline_neighbour(NodeId a, NodeId b) const {
  const std::vector<NodeId> of_a = outline_neighbours(a);
  const std::vector<NodeId> of_b = outline_neighbours(b);
  return std::any_of(of_a.begin(), of_a.end(),
                     [&](NodeId n) { return std::binary_search(of_b.begin(), of_b.end(), n); });
}

// Takes a step out of its path. The stretch before or after an end goes to the neighbour, which becomes the
// end.
void LinkedPaths::unlink(std::uint32_t step) {
  Step& s = steps_[step];
  if (s.before != kNone) steps_[s.before].after = s.after;
  if (s.after != kNone) steps_[s.after].before = s.before;
  if (s.before == kNone) {
    first_[s.path] = s.after;
    if (s.after != kNone) steps_[s.after].at = s.at;
  } else if (s.after == kNone) {
    steps_[s.before].at = s.at;
  }
}

void LinkedPaths::remove_node(NodeId node) {
  for (const std::uint32_t step : at(node)) unlink(step);
  steps_at_.clear(node.value());
}

void LinkedPaths::merge(NodeId gone, NodeId kept) {
  const std::vector<std::uint32_t> steps(at(gone).begin(), at(gone).end());
  steps_at_.clear(gone.value());
  for (const std::uint32_t step : steps) {
    const std::uint32_t earlier = before(step);
    const std::uint32_t later = after(step);
    const bool repeats_earlier = earlier != kNone && steps_[earlier].node == kept;
    const bool repeats_later = later != kNone && steps_[later].node == kept;
    if (repeats_earlier || repeats_later) {
      unlink(step);
      if (repeats_earlier && repeats_later) {
        unlink(later);
        steps_at_.remove(kept.value(), later);
      }
    } else {
      steps_[step].node = kept;
      steps_at_.add(kept.value(), step);
    }
  }
}

}  // namespace quarry::linework
