// How many faces a vertex should have, and what it costs to have another number.
#pragma once

#include <cstdint>

#include "engine/geometry/model.hpp"
#include "engine/mesh/mesh.hpp"

namespace quarry {

// The vertex tag (uint8) of the number of faces that a vertex should have. Vertices to come get 4: operations
// on a mesh that is cut open make inner vertices only.
inline constexpr const char* kIdealTag = "ideal_faces";

// The angle at a boundary vertex from its first to its last boundary edge through the faces, in radians in
// (0, 2 pi]; both edges to one vertex make a full turn. The side on which the faces lie is decided by the
// model's orientation. The angles of the faces must not be added up instead: a face that is turned over there
// gives -160 degrees in place of 200, and the vertex would be taken for a corner.
template <GeometryModel Model>
[[nodiscard]] double sector_angle(const Mesh& mesh, const Model& model, VertexId v);

// Sets kIdealTag from the present shape of the boundary: 4 inside, on the boundary the nearest number of
// right angles to the sector, at least 1. In parallel. Makes the tag if there is none.
template <GeometryModel Model>
Tag<VertexId, std::uint8_t> set_ideal_faces(Mesh& mesh, const Model& model);

// What a vertex costs that has so many faces in place of the ideal: 0, 1, 4, 9, ... A vertex that is two off
// costs more than two that are one off.
constexpr int valence_energy(int faces, int ideal) { return (faces - ideal) * (faces - ideal); }

extern template double sector_angle(const Mesh&, const PlaneModel&, VertexId);
extern template double sector_angle(const Mesh&, const SpaceModel&, VertexId);
extern template Tag<VertexId, std::uint8_t> set_ideal_faces(Mesh&, const PlaneModel&);
extern template Tag<VertexId, std::uint8_t> set_ideal_faces(Mesh&, const SpaceModel&);

}  // namespace quarry
