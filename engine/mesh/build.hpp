// Makes a mesh from points and the corners of faces; finds who is next to whom.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "engine/mesh/mesh.hpp"

namespace quarry {

// Corners of a face, counter-clockwise; the fourth is an invalid id for a triangle.
using FaceCorners = std::array<VertexId, 4>;

// Builds a planar mesh. Order of points and faces is kept.
// Throws Error(kInput) naming the place when an edge has three faces, two faces turn the same way along an
// edge, a corner is out of range, or a face repeats a corner.
[[nodiscard]] Mesh build_mesh(std::vector<double> x, std::vector<double> y,
                              std::span<const FaceCorners> faces);

// The same in space. z has the size of x and y.
[[nodiscard]] Mesh build_mesh(std::vector<double> x, std::vector<double> y, std::vector<double> z,
                              std::span<const FaceCorners> faces);

// The same for a surface whose sheets may meet: where an edge has three faces or more, or two that turn the
// same way along it (a one-sided band), all of them end there as at a rim. Each fan of faces beyond the first
// that a point has then gets a vertex of its own, behind all others, and the vertices of such a point have
// the tag kPinchTag (engine/mesh/pinch.hpp).
[[nodiscard]] Mesh build_sheets(std::vector<double> x, std::vector<double> y, std::vector<double> z,
                                std::span<const FaceCorners> faces);

// Sets side_of of every vertex from the corners and neighbours of the faces alive: the most clockwise side at
// a boundary vertex, else the side of smallest number. Vertices without a face are deleted.
void rebuild_sides_of_vertices(Mesh& mesh);

}  // namespace quarry
