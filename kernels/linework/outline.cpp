#include "kernels/linework/outline.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "engine/geometry/grid.hpp"
#include "engine/geometry/predicates.hpp"
#include "engine/geometry/segment.hpp"
#include "kernels/linework/ring_locator.hpp"

namespace quarry {
namespace {

using linework::RingLocator;

std::string origin_of(const LineSet& lines, LineId id) {
  const InputLine& line = lines.lines[id];
  const std::string file = line.file < lines.files.size() ? lines.files[line.file] + ": " : "";
  return fmt::format("{}feature {}: line {}", file, line.feature, id.value());
}

Box2 box_of(const std::vector<Vec2>& points) {
  Box2 box;
  for (const Vec2 p : points) box.extend(p);
  return box;
}

// A closed line that could bound something.
bool is_ring(const InputLine& line) { return line.closed() && line.points.size() >= 4; }

// A ring that truly crosses itself has no inside that everyone agrees upon. Crossings within the snapping
// distance of a vertex vanish in cleaning.
void require_simple(const LineSet& lines, LineId id, double near) {
  const std::vector<Vec2>& points = lines.lines[id].points;
  std::vector<Segment> segments;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) segments.push_back({points[i], points[i + 1]});
  const Box2 box = box_of(points);
  if (segments.empty() || !(box.longer_side() > 0)) return;
  const SegmentGrid grid(segments, box.longer_side() / std::sqrt(static_cast<double>(segments.size())));
  const double snapped = std::numbers::sqrt2 * near;
  std::vector<std::uint32_t> others;
  for (std::uint32_t i = 0; i < segments.size(); ++i) {
    const auto [a, b] = segments[i];
    grid.find(box_of({a, b}), others);
    for (const std::uint32_t other : others) {
      const auto [c, d] = segments[other];
      if (other <= i || meeting(a, b, c, d) != Meeting::kProper) continue;
      const Vec2 x = crossing_point(a, b, c, d);
      if (std::min({distance(x, a), distance(x, b), distance(x, c), distance(x, d)}) <= snapped) continue;
      throw Error(
          ErrorKind::kInput,
          fmt::format(
              "{}: a ring of the outline crosses itself at {}; correct it or choose another --boundary",
              origin_of(lines, id), format_point(x.x, x.y)));
    }
  }
}

// Whether a line lies in a ring or near it: its points, and the middles of its segments, for a line that
// closes a bay of the ring may have all its points on the rim.
bool line_within(const std::vector<Vec2>& line, const RingLocator& ring) {
  for (std::size_t i = 0; i < line.size(); ++i)
    if (!ring.holds(line[i]) || (i > 0 && !ring.holds(midpoint(line[i - 1], line[i])))) return false;
  return true;
}

bool box_within(const Box2& inner, const Box2& outer) {
  return outer.contains(inner.low) && outer.contains(inner.high);
}

double area_of(const std::vector<Vec2>& ring) {
  double twice = 0;
  for (std::size_t i = 0; i + 1 < ring.size(); ++i) twice += cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
  return std::abs(twice) / 2;
}

// The closed lines, larger ones first, and for each those that it lies within (indices into ids).
struct Nesting {
  std::vector<LineId> ids;
  std::vector<std::vector<std::uint32_t>> within;
};

Nesting nest(const LineSet& lines, double near) {
  Nesting result;
  // By the area of the box first: that of a ring which crosses itself means nothing.
  std::vector<std::pair<double, double>> areas(lines.lines.size());
  for (const LineId id : IdRange<LineId>(lines.lines.size())) {
    if (!is_ring(lines.lines[id])) continue;
    const Box2 box = box_of(lines.lines[id].points);
    areas[id.value()] = {box.width() * box.height(), area_of(lines.lines[id].points)};
    if (areas[id.value()].first > 0) result.ids.push_back(id);
  }
  std::stable_sort(result.ids.begin(), result.ids.end(),
                   [&](LineId a, LineId b) { return areas[a.value()] > areas[b.value()]; });
  std::vector<Box2> boxes;
  for (const LineId id : result.ids) boxes.push_back(box_of(lines.lines[id].points));
  std::vector<std::unique_ptr<RingLocator>> rings(result.ids.size());
  result.within.resize(result.ids.size());
  for (std::uint32_t i = 0; i < result.ids.size(); ++i) {
    for (std::uint32_t k = 0; k < i; ++k) {
      if (!box_within(boxes[i], boxes[k].grown(near))) continue;
      if (!rings[k]) rings[k] = std::make_unique<RingLocator>(lines.lines[result.ids[k]].points, near);
      if (line_within(lines.lines[result.ids[i]].points, *rings[k])) result.within[i].push_back(k);
    }
  }
  return result;
}

OutlineRing ring_of(const LineSet& lines, LineId id, std::uint32_t polygon, bool input) {
  return {lines.lines[id].points, polygon, input ? id : LineId(), origin_of(lines, id)};
}

// Polygons as they were read: an outer ring and the holes that follow it.
Outline polygons_of(const LineSet& lines, double near, bool input) {
  Outline outline;
  std::uint32_t polygon = 0;
  for (const LineId id : IdRange<LineId>(lines.lines.size())) {
    const InputLine& line = lines.lines[id];
    if (!line.polygon_ring) continue;
    if (!line.hole) ++polygon;
    if (!is_ring(line)) continue;
    require_simple(lines, id, near);
    outline.rings.push_back(ring_of(lines, id, polygon, input));
  }
  return outline;
}

bool all_within(const LineSet& lines, const std::vector<LineId>& outermost, double near) {
  std::vector<RingLocator> rings;
  for (const LineId id : outermost) rings.emplace_back(lines.lines[id].points, near);
  const auto held = [&](Vec2 p) {
    return std::any_of(rings.begin(), rings.end(), [&](const RingLocator& ring) { return ring.holds(p); });
  };
  return std::all_of(lines.lines.begin(), lines.lines.end(), [&](const InputLine& line) {
    return std::all_of(line.points.begin(), line.points.end(), held);
  });
}

std::vector<Vec2> corners(const Box2& box) {
  return {box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}, box.low};
}

[[noreturn]] void fail_without_points(const LineSet& lines) {
  throw Error(ErrorKind::kInput,
              fmt::format("{}: no line of the input has a point, from this one on; there is nothing to mesh",
                          lines.lines.empty() ? "input" : origin_of(lines, LineId(0U))));
}

[[noreturn]] void fail_as_point(const LineSet& lines, Vec2 p) {
  std::size_t first = 0;
  while (first < lines.lines.size() && lines.lines[LineId(first)].points.empty()) ++first;
  throw Error(ErrorKind::kInput,
              fmt::format("{}: all points of the lines are one, {}; there is nothing to mesh without a "
                          "--boundary",
                          first < lines.lines.size() ? origin_of(lines, LineId(first)) : "input",
                          format_point(p.x, p.y)));
}

// Andrew's monotone chain, with exact turns; closed, counter-clockwise.
std::vector<Vec2> convex_hull(std::vector<Vec2> points) {
  std::sort(points.begin(), points.end(), [](Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::vector<Vec2> hull;
  const auto add = [&](Vec2 p, std::size_t floor) {
    while (hull.size() >= floor + 2 && orient2d(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
    hull.push_back(p);
  };
  for (const Vec2 p : points) add(p, 0);
  const std::size_t lower = hull.size() - 1;
  for (std::size_t i = points.size() - 1; i-- > 0;) add(points[i], lower);
  return hull;
}

}  // namespace

Outline box_outline(const LineSet& lines, double near, double margin) {
  Box2 box = lines.box();
  if (box.empty()) fail_without_points(lines);
  const double longer = box.longer_side();
  if (!(longer > 0) && margin <= 0) fail_as_point(lines, box.low);
  Outline outline;
  outline.rule = OutlineRule::kBox;
  outline.rigid = true;
  outline.text = "box of the lines";
  if (margin > 0) {
    outline.text = fmt::format("box of the lines, wider by {:g} on each side", margin);
    box = box.grown(margin);
  }
  const double least = 10 * near;
  const bool narrow = box.width() < least || box.width() < 1e-9 * longer;
  const bool low = box.height() < least || box.height() < 1e-9 * longer;
  if (narrow || low) {
    outline.text = fmt::format("box of the lines, grown by {:g} in {} because the lines span only {:g} there",
                               longer / 10, narrow ? "x" : "y", narrow ? box.width() : box.height());
    const Vec2 by{narrow ? longer / 10 : 0, low ? longer / 10 : 0};
    box = {box.low - by, box.high + by};
  }
  outline.rings.push_back({corners(box), 0, LineId()});
  return outline;
}

Outline hull_outline(const LineSet& lines, double near) {
  std::vector<Vec2> points;
  for (const InputLine& line : lines.lines)
    points.insert(points.end(), line.points.begin(), line.points.end());
  for (const InputPoint& point : lines.points) points.push_back(point.place);
  if (points.empty()) fail_without_points(lines);
  std::vector<Vec2> hull = convex_hull(points);
  const double longer = lines.box().longer_side();
  if (hull.size() < 4 || area_of(hull) < longer * std::max(10 * near, 1e-9 * longer)) {
    Outline outline = box_outline(lines, near);
    outline.text += " (their convex hull has no area worth the name)";
    return outline;
  }
  Outline outline;
  outline.rule = OutlineRule::kHull;
  outline.rigid = true;
  outline.text = "convex hull of the lines";
  outline.rings.push_back({std::move(hull), 0, LineId()});
  return outline;
}

Outline boundary_outline(const LineSet& boundary, double near) {
  Outline outline = polygons_of(boundary, near, false);
  outline.rule = OutlineRule::kBoundary;
  const std::string file = boundary.files.empty() ? "boundary" : boundary.files[0];
  outline.text = "polygons of the boundary file";
  if (!outline.rings.empty()) return outline;
  const Nesting nesting = nest(boundary, near);
  if (nesting.ids.empty())
    throw Error(ErrorKind::kInput,
                fmt::format("{}: holds no polygon and no closed line to serve as a boundary", file));
  outline.text = "closed lines of the boundary file";
  for (std::uint32_t i = 0; i < nesting.ids.size(); ++i) {
    require_simple(boundary, nesting.ids[i], near);
    // A hole belongs to the smallest ring around it.
    const bool hole = nesting.within[i].size() % 2 == 1;
    outline.rings.push_back(ring_of(boundary, nesting.ids[i], hole ? nesting.within[i].back() : i, false));
  }
  return outline;
}

Outline default_outline(const LineSet& lines, double near) {
  Outline outline = polygons_of(lines, near, true);
  if (!outline.rings.empty()) {
    outline.rule = OutlineRule::kPolygons;
    outline.text = "polygons of the input";
    return outline;
  }
  const Nesting nesting = nest(lines, near);
  std::vector<LineId> outermost;
  for (std::uint32_t i = 0; i < nesting.ids.size(); ++i)
    if (nesting.within[i].empty()) outermost.push_back(nesting.ids[i]);
  if (outermost.empty() || !all_within(lines, outermost, near)) return box_outline(lines, near);
  outline.rule = OutlineRule::kClosedLines;
  outline.text = fmt::format("outermost closed lines of the input ({})", outermost.size());
  for (std::uint32_t i = 0; i < outermost.size(); ++i) {
    require_simple(lines, outermost[i], near);
    outline.rings.push_back(ring_of(lines, outermost[i], i, true));
  }
  return outline;
}

}  // namespace quarry
