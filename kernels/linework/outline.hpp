// The outline of the domain: which closed loops bound it, and by which rule they were chosen.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/geometry/line_set.hpp"

namespace quarry {

enum class OutlineRule : std::uint8_t {
  kPolygons,     // polygons of the input, holes as holes
  kClosedLines,  // its outermost closed lines, within which all other lines lie
  kBox,          // the box of the lines
  kHull,         // their convex hull
  kBoundary,     // rings of a boundary file
};

// A closed loop: its last point equals its first.
struct OutlineRing {
  std::vector<Vec2> points;
  // Rings with the same number bound one polygon together: a point is in it if it is within an odd number of
  // its rings. The domain is the union of the polygons.
  std::uint32_t polygon = 0;
  // The input line that the ring is; none for a box, a hull and the rings of a boundary file.
  LineId line;
  // For messages: file, feature and line of a ring that was read.
  std::string origin = {};
};

struct Outline {
  std::vector<OutlineRing> rings;
  OutlineRule rule = OutlineRule::kBox;
  // The rule in words, and what was done beyond it: one line for the report.
  std::string text;
  // The rings are kept to the last bit of their shape: nothing may bend them (box and hull).
  bool rigid = false;
};

// The default rule: polygons of the input; else its outermost closed lines, where all other lines lie within
// them or nearer than `near` to them; else the box. near: in input units, the snapping distance. Throws
// Error(kInput) if a ring crosses itself (with the coordinates) or all points of the lines are one.
[[nodiscard]] Outline default_outline(const LineSet& lines, double near);

// The box of the lines. A side shorter than ten times `near` is grown by a tenth of the longer side on each
// side, so that lines on one straight line are given a domain; the text tells so. margin: by which the box is
// wider on each side, in input units.
[[nodiscard]] Outline box_outline(const LineSet& lines, double near, double margin = 0);

// The convex hull of all points of the lines; grown to a box as above where it has no area worth the name.
[[nodiscard]] Outline hull_outline(const LineSet& lines, double near);

// The rings of a boundary file: its polygons if it has any; else its closed lines, of which those within an
// odd number of others are holes. Throws Error(kInput) if it has neither, or if a ring crosses itself.
[[nodiscard]] Outline boundary_outline(const LineSet& boundary, double near);

}  // namespace quarry
