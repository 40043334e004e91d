// Cuts lines into a triangulated surface, so that they become edges of its triangles: what a mesh of the
// surface keeps like any other feature. Lines may cross, touch and end anywhere.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "surface/repair/repair.hpp"

namespace quarry {

// A line on or near the surface.
struct SurfaceLine {
  std::vector<Vec3> points;
  // Without heights (z is passed over) a line lies where plumb lines through it meet the surface from above.
  bool has_heights = true;
};

// Lengths are in input units.
struct ImprintOptions {
  // Between its points a line is led across the surface in steps of at most this length; it should be half a
  // wanted edge or less.
  double step = 1;
  // What of a line comes nearer than this to a point or an edge of the surface goes through it.
  double snap = 0;
  // How far from the surface a line with heights may lie; what lies farther is left out.
  double reach = 0;
};

// What became of a line.
struct ImprintedLine {
  std::uint64_t edges = 0;         // that bear its number, when it was cut in
  std::uint64_t shared = 0;        // that it goes along, and that a line before it has
  std::uint64_t outside = 0;       // how often it leaves the surface or comes to it
  std::uint64_t lost = 0;          // its stretches that could not be followed
  bool lends = false;              // edges of its own to lines behind it
  bool meets = false;              // other lines between its ends
  std::vector<std::int32_t> with;  // lines with which it shares edges or points, ascending
  std::vector<Vec3> places;        // of its points, and where it leaves and comes to the surface: on it
};

struct ImprintReport {
  RepairCount outside;          // ends of stretches that do not lie on the surface, left out
  RepairCount lost;             // stretches that could not be followed across the surface, left out
  std::uint64_t imprinted = 0;  // lines of which something lies on the surface
  std::vector<ImprintedLine> lines;
};

// An edge that a line goes along.
struct LineEdge {
  std::array<std::uint32_t, 2> ends;  // points of the surface, ascending
  std::int32_t line;                  // of several lines the first

  friend bool operator==(const LineEdge&, const LineEdge&) = default;
};

// New points come last; of a triangle that is cut one part keeps its number, and its group goes to all. Joins
// that are crossed are cut too. Returns the edges, ascending. Line after line, and so the same each time.
[[nodiscard]] std::vector<LineEdge> imprint_lines(RepairedSurface& repaired,
                                                  std::span<const SurfaceLine> lines,
                                                  const ImprintOptions& options, ImprintReport& report);

}  // namespace quarry
