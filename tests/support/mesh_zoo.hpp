// Small awkward meshes, each valid, for tests that must hold on any mesh.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "engine/mesh/build.hpp"

namespace quarry::test {

// Faces by numbers of points: three or four each.
inline Mesh mesh_of(const std::vector<Vec2>& points, const std::vector<std::vector<std::uint32_t>>& faces) {
  std::vector<double> x, y;
  for (const Vec2 p : points) {
    x.push_back(p.x);
    y.push_back(p.y);
  }
  std::vector<FaceCorners> corners;
  for (const auto& face : faces) {
    corners.emplace_back();
    for (std::size_t i = 0; i < face.size(); ++i) corners.back()[i] = VertexId(face[i]);
  }
  return build_mesh(std::move(x), std::move(y), corners);
}

inline Mesh one_triangle() { return mesh_of({{0, 0}, {1, 0}, {0, 1}}, {{0, 1, 2}}); }

inline Mesh two_triangles() { return mesh_of({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 1, 2}, {0, 2, 3}}); }

// Triangles side by side, alternately up and down.
inline Mesh strip(std::uint32_t triangles) {
  std::vector<Vec2> points;
  std::vector<std::vector<std::uint32_t>> faces;
  for (std::uint32_t i = 0; i < triangles + 2; ++i) points.push_back({0.5 * i, i % 2 == 0 ? 0.0 : 1.0});
  for (std::uint32_t i = 0; i < triangles; ++i)
    faces.push_back(i % 2 == 0 ? std::vector{i, i + 2, i + 1} : std::vector{i, i + 1, i + 2});
  return mesh_of(points, faces);
}

// Triangles around a point, all the way or not.
inline Mesh fan(std::uint32_t triangles, bool closed) {
  std::vector<Vec2> points{{0, 0}};
  std::vector<std::vector<std::uint32_t>> faces;
  const std::uint32_t rim = closed ? triangles : triangles + 1;
  for (std::uint32_t i = 0; i < rim; ++i) {
    const double turn = (closed ? 2 : 1) * std::numbers::pi * i / triangles;
    points.push_back({std::cos(turn), std::sin(turn)});
  }
  for (std::uint32_t i = 0; i < triangles; ++i) faces.push_back({0, 1 + i, 1 + (i + 1) % rim});
  return mesh_of(points, faces);
}

// A ring of quads around a hole.
inline Mesh annulus(std::uint32_t quads) {
  std::vector<Vec2> points;
  std::vector<std::vector<std::uint32_t>> faces;
  for (std::uint32_t i = 0; i < quads; ++i) {
    const double turn = 2 * std::numbers::pi * i / quads;
    points.push_back({std::cos(turn), std::sin(turn)});
    points.push_back({2 * std::cos(turn), 2 * std::sin(turn)});
  }
  for (std::uint32_t i = 0; i < quads; ++i) {
    const std::uint32_t j = (i + 1) % quads;
    faces.push_back({2 * i, 2 * i + 1, 2 * j + 1, 2 * j});
  }
  return mesh_of(points, faces);
}

inline Mesh two_components() {
  return mesh_of({{0, 0}, {1, 0}, {0, 1}, {5, 5}, {6, 5}, {6, 6}, {5, 6}}, {{0, 1, 2}, {3, 4, 5}, {3, 5, 6}});
}

// Two quads and three triangles around an interior point.
inline Mesh mixed() {
  return mesh_of({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {1, 1}, {0, 1}},
                 {{0, 1, 7, 8}, {1, 2, 3, 7}, {7, 3, 4}, {7, 4, 5}, {8, 7, 5, 6}});
}

// Columns by rows of square cells of side 1, each cut in two.
inline Mesh triangle_lattice(std::uint32_t columns, std::uint32_t rows, Vec2 origin = {0, 0}) {
  std::vector<Vec2> points;
  std::vector<std::vector<std::uint32_t>> faces;
  for (std::uint32_t row = 0; row <= rows; ++row)
    for (std::uint32_t column = 0; column <= columns; ++column)
      points.push_back({origin.x + column, origin.y + row});
  for (std::uint32_t row = 0; row < rows; ++row) {
    for (std::uint32_t column = 0; column < columns; ++column) {
      const std::uint32_t a = row * (columns + 1) + column;
      faces.push_back({a, a + 1, a + columns + 2});
      faces.push_back({a, a + columns + 2, a + columns + 1});
    }
  }
  return mesh_of(points, faces);
}

struct ZooMesh {
  std::string name;
  Mesh mesh;
  int euler;  // vertices - edges + faces
};

inline std::vector<ZooMesh> mesh_zoo() {
  std::vector<ZooMesh> zoo;
  zoo.push_back({"one triangle", one_triangle(), 1});
  zoo.push_back({"two triangles", two_triangles(), 1});
  zoo.push_back({"strip of 9", strip(9), 1});
  zoo.push_back({"closed fan of 3", fan(3, true), 1});
  zoo.push_back({"closed fan of 40", fan(40, true), 1});
  zoo.push_back({"open fan of 7", fan(7, false), 1});
  zoo.push_back({"annulus of 5 quads", annulus(5), 0});
  zoo.push_back({"two components", two_components(), 2});
  zoo.push_back({"quads and triangles", mixed(), 1});
  zoo.push_back({"lattice", triangle_lattice(5, 4), 1});
  return zoo;
}

}  // namespace quarry::test
