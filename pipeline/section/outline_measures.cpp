#include "pipeline/section/outline_measures.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace quarry {
namespace {

std::vector<Segment> segments_of(const Outline& outline) {
  std::vector<Segment> segments;
  for (const OutlineRing& ring : outline.rings)
    for (std::size_t i = 0; i + 1 < ring.points.size(); ++i)
      segments.push_back({ring.points[i], ring.points[i + 1]});
  return segments;
}

std::vector<std::uint32_t> polygons_of(const Outline& outline) {
  std::vector<std::uint32_t> polygons;
  for (const OutlineRing& ring : outline.rings)
    for (std::size_t i = 0; i + 1 < ring.points.size(); ++i) polygons.push_back(ring.polygon);
  return polygons;
}

}  // namespace

Box2 box_of(const Outline& outline) {
  Box2 box;
  for (const OutlineRing& ring : outline.rings)
    for (const Vec2 p : ring.points) box.extend(p);
  return box;
}

double area_of(const Outline& outline) {
  struct Areas {
    double largest = 0, sum = 0;
  };
  std::map<std::uint32_t, Areas> polygons;
  for (const OutlineRing& ring : outline.rings) {
    double doubled = 0;
    for (std::size_t i = 0; i + 1 < ring.points.size(); ++i)
      doubled += cross(ring.points[i] - ring.points[0], ring.points[i + 1] - ring.points[0]);
    Areas& areas = polygons[ring.polygon];
    areas.largest = std::max(areas.largest, 0.5 * std::abs(doubled));
    areas.sum += 0.5 * std::abs(doubled);
  }
  // All rings of a polygon but the largest are its holes.
  double area = 0;
  for (const auto& [polygon, areas] : polygons) area += std::max(0.0, 2 * areas.largest - areas.sum);
  return area;
}

InsideOutline::InsideOutline(const Outline& outline)
    : segments_(segments_of(outline)),
      polygons_(polygons_of(outline)),
      right_(box_of(outline).high.x + box_of(outline).longer_side()),
      grid_(segments_, box_of(outline).longer_side() / 256) {}

bool InsideOutline::operator()(Vec2 p) const {
  std::vector<std::uint32_t> ids;
  grid_.find({p, {right_, p.y}}, ids);
  std::map<std::uint32_t, bool> odd;  // crossings of the ray to the right, by polygon
  for (const std::uint32_t id : ids) {
    const auto [a, b] = segments_[id];
    if ((a.y > p.y) == (b.y > p.y)) continue;
    const double x = a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x);
    if (x > p.x) odd[polygons_[id]] = !odd[polygons_[id]];
  }
  return std::any_of(odd.begin(), odd.end(), [](const auto& entry) { return entry.second; });
}

}  // namespace quarry
