// What a surface job does with a mesh before it hands it out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "engine/mesh/mesh.hpp"
#include "surface/feature/curve_network.hpp"
#include "surface/model/surface_model.hpp"

namespace quarry {

// The faces that are inverted or flat, or that lie upside down on the surface: where a wall or a gap is
// thinner than the elements are long, nothing good may be left to be done. area: of the surface. Ascending.
[[nodiscard]] std::vector<FaceId> find_invalid_on_surface(const Mesh& mesh, const SurfaceModel& model,
                                                          double area);

// Gives faces the tag "region": each part between features has the group that most of its faces lie on.
// groups: of the triangles of the model.
void set_surface_regions(Mesh& mesh, const std::vector<std::int32_t>& groups, const SurfaceModel& model);

// What edges on a curve become: an edge entity with each of these as its tag "constraint". rim: the curve is
// the end of one sheet alone. Where no curve is known under an edge, the curve is none.
using NumbersOfCurve = std::function<std::vector<std::int32_t>(PieceId curve, bool rim)>;

// Edge entities and points that sheets share, as SurfaceResult has them, in the place of what the kernels
// work with.
void finish_surface_mesh(Mesh& mesh, const CurveNetwork& network, const NumbersOfCurve& numbers);

}  // namespace quarry
