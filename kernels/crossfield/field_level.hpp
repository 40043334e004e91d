// One level of a hierarchy of graphs on which fields over a mesh are found from coarse to fine: vertices with
// a place, a normal and a tangent axis, and rows of neighbours with weights.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/geometry/vec.hpp"
#include "engine/mesh/mesh.hpp"

namespace quarry {

// Complex numbers as planar vectors. A cross is the number of length 1 whose angle is four times that of its
// directions.
constexpr Vec2 complex_product(Vec2 a, Vec2 b) { return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x}; }
constexpr Vec2 conjugate(Vec2 a) { return {a.x, -a.y}; }
inline Vec3 unit_or(Vec3 v, Vec3 otherwise) {
  const double size = length(v);
  return size > 0 ? (1 / size) * v : otherwise;
}

// Vertices a chunk of loops that visit rows.
inline constexpr std::size_t kFieldChunk = 512;

struct FieldLevel {
  static constexpr std::uint32_t kNone = 0xffffffffU;

  std::vector<Vec3> points, normals, axes;  // axes: unit, across the normal; angles are counted from there
  std::vector<double> mass;                 // how many vertices of the finest level it stands for
  std::vector<std::uint8_t> given;          // 1: its field is given
  // Row i: entries first[i] to first[i + 1].
  std::vector<std::uint32_t> first, other;
  std::vector<double> weight;
  // Of the connection Laplacian A: A(i, i) = diagonal[i], A(i, other) = -turn. At the finest level a turn is
  // the weight times the number by which the other vertex's field is multiplied when it is carried over here.
  std::vector<Vec2> turn;
  std::vector<double> diagonal;
  // Into the next coarser level; the field of a vertex is that of its parent times from_parent.
  std::vector<std::uint32_t> parent;
  std::vector<Vec2> from_parent;
  // Those in the next finer level that a vertex stands for: one or two (else kNone); empty at the finest.
  std::vector<std::array<std::uint32_t, 2>> children;
  // The vertices that are not given, no two joined ones in one class.
  std::vector<std::vector<std::uint32_t>> classes;

  [[nodiscard]] std::size_t size() const { return points.size(); }
  [[nodiscard]] std::size_t free_size() const;
  // Of what is known by vertex.
  void resize(std::size_t size);
};

// The finest level: the vertices of a mesh, joined by its edges. Normals are those of the mesh
// (Mesh::normals()), or of the faces around where it has none or they are zero; (0, 0, 1) in the plane.
// axes: empty, or one direction a vertex that angles are counted from: they change no result but by rounding.
[[nodiscard]] FieldLevel finest_level(const Mesh& mesh, std::vector<std::uint8_t> given,
                                      std::span<const Vec3> axes = {});

// Fills the classes of a level by its rows.
void find_classes(FieldLevel& level);

}  // namespace quarry
