#include "kernels/linework/narrow_wedges.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>
#include <utility>

#include "engine/geometry/ends_around.hpp"
#include "engine/geometry/segment.hpp"
#include "kernels/linework/gather.hpp"

namespace quarry::linework {
namespace {

// How far along the second edge leaves the first, in snapping distances: at an angle of some 20 degrees.
constexpr double kStep = 2.5;

struct Wedge {
  NodeId apex;
  std::uint32_t first;   // of the outline, if one is
  std::uint32_t second;  // neighbours around the apex
  double angle;          // between them, radians
};

struct Ray {
  double direction;
  std::uint32_t edge;
};

void append_wedges(const PathNetwork& network, NodeId apex, std::span<const std::uint32_t> edges,
                   double limit, std::vector<Wedge>& found) {
  const auto along = [&](std::uint32_t e) {
    const Edge& edge = network.edges[e];
    return network.nodes[edge.from == apex ? edge.to : edge.from] - network.nodes[apex];
  };
  std::vector<Ray> rays;
  for (const std::uint32_t e : edges) rays.push_back({std::atan2(along(e).y, along(e).x), e});
  std::sort(rays.begin(), rays.end(), [](const Ray& a, const Ray& b) {
    return std::tie(a.direction, a.edge) < std::tie(b.direction, b.edge);
  });
  for (std::size_t i = 0; i < rays.size(); ++i) {
    std::uint32_t first = rays[i].edge;
    std::uint32_t second = rays[(i + 1) % rays.size()].edge;
    const double angle = std::abs(signed_angle(along(first), along(second)));
    if (first == second || !(angle > 0 && angle < limit)) continue;
    if (network.edges[second].outline) std::swap(first, second);
    if (!network.edges[second].outline) found.push_back({apex, first, second, angle});
  }
}

// By apex, then around it.
std::vector<Wedge> narrow_wedges(const PathNetwork& network, double limit) {
  const EndsAround<std::uint32_t> around(network.nodes.size(), network.edges);
  return gather<Wedge>(network.nodes.size(),
                       [&](std::size_t begin, std::size_t end, std::vector<Wedge>& found) {
                         for (std::size_t n = begin; n < end; ++n) {
                           const std::span<const std::uint32_t> edges = around.at(NodeId(n));
                           if (edges.size() > 1) append_wedges(network, NodeId(n), edges, limit, found);
                         }
                       });
}

// A place on an edge, so far from the apex.
struct Place {
  double at;  // along the edge
  Vec2 point;
};

Place place_on(const PathNetwork& network, std::uint32_t e, NodeId apex, double from_apex) {
  const Edge& edge = network.edges[e];
  const Vec2 a = network.nodes[edge.from];
  const Vec2 b = network.nodes[edge.to];
  const double share = from_apex / distance(a, b);
  const double at = edge.from == apex ? share : 1 - share;
  return {at, point_at(at, a, b)};
}

double length_of(const PathNetwork& network, std::uint32_t e) {
  return distance(network.nodes[network.edges[e].from], network.nodes[network.edges[e].to]);
}

}  // namespace

std::uint32_t close_narrow_wedges(PathNetwork& network, NodePlaces& places, double snap, double limit) {
  std::vector<Insertion> insertions;
  for (const Wedge& wedge : narrow_wedges(network, limit)) {
    const double along_first = snap * (1 - wedge.angle) / std::sin(wedge.angle);
    const double along_second = along_first + kStep * snap;
    const double rest = 1.1 * places.apart();
    if (length_of(network, wedge.first) < along_first + rest ||
        length_of(network, wedge.second) < along_second + rest)
      continue;
    const Place first = place_on(network, wedge.first, wedge.apex, along_first);
    const Place second = place_on(network, wedge.second, wedge.apex, along_second);
    if (places.nearest(first.point).valid() || places.nearest(second.point).valid()) continue;
    const bool outline = network.edges[wedge.first].outline;
    insertions.push_back({wedge.first, first.at, places.add(first.point, outline)});
    insertions.push_back({wedge.second, second.at, places.add(second.point, false)});
  }
  network.insert(insertions);
  return static_cast<std::uint32_t>(insertions.size() / 2);
}

}  // namespace quarry::linework
