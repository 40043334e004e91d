// Makes a triangulated surface fit to be meshed, and tells what had to be done: points at one place are one
// point, no triangle is there twice or has no extent, and neighbours agree on which side is up wherever a
// surface has two sides. Holes stay holes unless filling is asked for.
//
// What two sheets cannot share is kept, not refused: along an edge of three triangles or more, and along the
// cut that a one-sided surface needs, the sheets end, and meet again in their points
// (surface/repair/sheets.hpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "surface/repair/triangle_surface.hpp"

namespace quarry {

struct RepairOptions {
  // Points this near to one another become one, in input units; 0: only those with equal coordinates.
  double weld = 0;
  // Holes with at most so many edges are closed; 0: none.
  std::uint32_t fill_holes = 0;
};

// How often something was done, and where at first.
struct RepairCount {
  static constexpr std::size_t kMostPlaces = 20;
  std::uint64_t count = 0;
  std::vector<Vec3> places;

  void add(Vec3 place) {
    if (count++ < kMostPlaces) places.push_back(place);
  }
};

struct RepairReport {
  RepairCount welded;        // points that went into another
  RepairCount unused;        // points without a triangle, left out
  RepairCount degenerate;    // triangles of fewer than three points, left out
  RepairCount duplicate;     // triangles that were there already, left out
  RepairCount hanging;       // flat triangles that hang on an edge of two others, left out
  RepairCount caps;          // flat triangles, for which those across their longest edge were cut
  RepairCount turned;        // triangles
  RepairCount filled_holes;  // holes
  // What was found and left.
  RepairCount flat;                         // triangles without area
  RepairCount branches;                     // edges of three triangles or more
  RepairCount seams;                        // edges along which a one-sided surface was cut
  RepairCount pinches;                      // points in which a surface touches itself, beside joins
  std::uint64_t holes = 0, open_edges = 0;  // closed courses of rims, and their edges
};

// An edge in which sheets end that go on as others do: branches and seams. Ascending ends.
using SheetJoin = std::array<std::uint32_t, 2>;
[[nodiscard]] constexpr SheetJoin join_of(std::uint32_t a, std::uint32_t b) {
  return a < b ? SheetJoin{a, b} : SheetJoin{b, a};
}

struct RepairedSurface {
  TriangleSurface surface;
  std::vector<SheetJoin> joins;  // ascending
  RepairReport report;
};

// Order of points and triangles is kept, filled holes come last. Of copies the first one stays. Each
// connected part keeps the side that most of its triangles have, of equals that of the first. Throws
// Error(kInput) if no triangle is left, or a triangle names a point that does not exist.
[[nodiscard]] RepairedSurface repair_surface(TriangleSurface surface, const RepairOptions& options);

}  // namespace quarry
