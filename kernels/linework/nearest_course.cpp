#include "kernels/linework/nearest_course.hpp"

#include <algorithm>
#include <tuple>

#include "engine/geometry/segment.hpp"
#include "kernels/linework/raw_stretch.hpp"

namespace quarry::linework {
namespace {

// Around a step that was too far, so much of the line is pinned to either side, at such places; in distances
// that nodes are apart.
constexpr double kPinned = 2;
constexpr double kPinSpacing = 0.2;

bool is_far(const PathNetwork& network, const Path& path, std::size_t step, double near) {
  const auto [node, at] = path.steps[step];
  return distance(raw_point(network.raw[path.raw].points, at), network.nodes[node]) > near;
}

// A node beside one segment of a raw line.
struct Passing {
  NodeId node;
  std::uint32_t segment;
  double at;       // parameter of the line's point nearest to it
  double squared;  // distance
};

std::vector<Passing> passings(const NodePlaces& places, std::span<const Vec2> raw, double from, double to) {
  std::vector<Passing> found;
  if (raw.size() < 2) return found;
  for (auto i = static_cast<std::size_t>(from); i + 1 < raw.size() && static_cast<double>(i) < to; ++i) {
    const auto base = static_cast<double>(i);
    const Vec2 a = raw_point(raw, std::max(from, base));
    const Vec2 b = raw_point(raw, std::min(to, base + 1));
    places.visit_along(a, b, [&](NodeId node, Vec2 p) {
      const double at = std::clamp(base + closest_parameter(p, raw[i], raw[i + 1]), from, to);
      const double squared = squared_length(raw_point(raw, at) - p);
      if (squared <= places.apart() * places.apart())
        found.push_back({node, static_cast<std::uint32_t>(i), at, squared});
    });
  }
  return found;
}

}  // namespace

std::vector<Window> windows_around(const PathNetwork& network, const Path& path,
                                   const std::vector<std::uint8_t>& marked, double near) {
  std::vector<Window> windows;
  for (std::size_t i = 0; i + 1 < path.steps.size(); ++i) {
    if (marked[i] == 0) continue;
    Window window{i, i + 1};
    while (window.first > 0 && is_far(network, path, window.first, near)) --window.first;
    while (window.last + 1 < path.steps.size() && is_far(network, path, window.last, near)) ++window.last;
    if (!windows.empty() && window.first < windows.back().last) {
      windows.back().last = std::max(windows.back().last, window.last);
    } else {
      windows.push_back(window);
    }
  }
  return windows;
}

void pin_course(NodePlaces& places, const PathNetwork& network, const Path& path, const Window& window) {
  const std::span<const Vec2> raw = network.raw[path.raw].points;
  const double from = path.steps[window.first].at;
  const double to = path.steps[window.last].at;
  for (auto i = static_cast<std::size_t>(from) + 1; static_cast<double>(i) < to; ++i)
    (void)places.at(raw[i], path.outline);
  double pinned = from;
  for (std::size_t i = window.first + 1; i < window.last; ++i) {
    if (!is_far(network, path, i, places.apart())) continue;
    const double at = path.steps[i].at;
    const double end = advance(raw, at, to, kPinned * places.apart());
    double pin = std::max(pinned, advance(raw, at, from, kPinned * places.apart()));
    for (; pin < end; pin = advance(raw, pin, end, kPinSpacing * places.apart()))
      (void)places.at(raw_point(raw, pin), path.outline);
    pinned = end;
  }
}

std::vector<PathStep> nearest_course(const NodePlaces& places, std::span<const Vec2> raw, double from,
                                     double to) {
  std::vector<Passing> found = passings(places, raw, from, to);
  std::sort(found.begin(), found.end(), [](const Passing& a, const Passing& b) {
    return std::tie(a.node, a.segment) < std::tie(b.node, b.segment);
  });
  std::vector<PathStep> steps;
  for (std::size_t i = 0; i < found.size();) {
    // The line passes once as long as it does so along consecutive segments.
    const Passing* nearest = &found[i];
    const auto goes_on = [&] {
      return found[i].node == nearest->node && found[i].segment <= found[i - 1].segment + 1;
    };
    for (++i; i < found.size() && goes_on(); ++i)
      if (found[i].squared < nearest->squared) nearest = &found[i];
    if (nearest->at > from && nearest->at < to) steps.push_back({nearest->node, nearest->at});
  }
  std::sort(steps.begin(), steps.end(), [](const PathStep& a, const PathStep& b) {
    return std::tie(a.at, a.node) < std::tie(b.at, b.node);
  });
  return steps;
}

}  // namespace quarry::linework
