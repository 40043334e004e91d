// What a mesh in space has to keep beside its surface: tagged edges, and points.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "io/mesh/read_cells.hpp"
#include "pipeline/improve/face_surface.hpp"
#include "surface/feature/curve_network.hpp"
#include "surface/imprint/imprint.hpp"

namespace quarry {

// A tagged edge that is no side of a face; the ends are points of the file.
struct EdgeApart {
  std::uint32_t a, b;
  std::int32_t number;
};

struct SurfaceLines {
  // Sides of faces that are tagged, ascending; the line is a place in `numbers`.
  std::vector<LineEdge> edges;
  // All numbers that an edge bears, ascending, -1 where it is tagged without one.
  std::vector<std::vector<std::int32_t>> numbers;
  std::vector<EdgeApart> apart;
  std::size_t tagged = 0;  // edges of the file that are kept
  std::size_t lost = 0;    // edges that join points of no face
  // Points that stay where they are, beside the ends of features: those of the file, and ends of edges apart.
  std::vector<std::uint32_t> fixed;

  // How long the edges of each number are together, apart ones too; without those of none.
  [[nodiscard]] std::map<std::int32_t, double> lengths(const TriangleSurface& surface) const;
  // The numbers of the edges on a curve; a rim without any has -1, other features none.
  [[nodiscard]] std::vector<std::int32_t> numbers_of(const FeatureCurve& curve, bool rim) const;
};

[[nodiscard]] SurfaceLines find_surface_lines(const ReadCells& cells, const FaceSurface& surface);

}  // namespace quarry
