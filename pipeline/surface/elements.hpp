// The elements of the surface job: triangles of the wanted size, and quads of them.
#pragma once

#include <cstdint>
#include <vector>

#include "pipeline/surface/surface.hpp"
#include "surface/feature/curve_network.hpp"
#include "surface/model/surface_model.hpp"
#include "surface/size/surface_sizes.hpp"

namespace quarry {

// The area of an equilateral triangle, or of a square, of edge 1.
[[nodiscard]] double element_area(Elements elements);

// The edge that elements of edge 1 begin with: that of the triangles which are paired, or of the lattice.
[[nodiscard]] double first_edge(Elements elements, SurfaceQuads method);
// The edge of joins for elements of edge 1: a matching halves what it is given.
[[nodiscard]] double join_edge(Elements elements, SurfaceQuads method);

struct SurfaceToMesh {
  const SurfaceModel& model;
  const CurveNetwork& network;
  const SurfaceSizes& sizes;  // of what elements begin with
  double area;
};

enum class ElementsMade : std::uint8_t {
  kAll,
  // The mesh is of no use: features or walls keep a lattice from becoming as coarse as it is to be, so that
  // its quads would be worse than others.
  kTooManyCells,
  // Nor is it here: remeshing has lost tips and pits of the surface. `lost` says where.
  kSurfaceLost
};

// result: its mesh is that of the surface, with features bound, and becomes that of the elements; its size
// and method say what they are to be, its reports are filled. lost: none if nobody asks for what remeshing
// loses; else empty, and then the places, with half the edge there, if they are few.
[[nodiscard]] ElementsMade make_elements(const SurfaceToMesh& surface, const SurfaceOptions& options,
                                         SurfaceResult& result, std::vector<TightPlace>* lost,
                                         StageClock& clock, const Progress& progress);

}  // namespace quarry
