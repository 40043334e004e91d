#include "kernels/deferred/locate.hpp"

#include <algorithm>
#include <cmath>

#include "engine/base/random.hpp"
#include "engine/geometry/predicates.hpp"

namespace quarry::deferred {
namespace {

Location place_in_face(FaceId f, const double (&turn)[3]) {
  for (int k = 0; k < 3; ++k)
    if (turn[k] == 0 && turn[(k + 2) % 3] == 0) return {Place::kVertex, SideId(f, k)};
  for (int k = 0; k < 3; ++k)
    if (turn[k] == 0) return {Place::kEdge, SideId(f, k)};
  return {Place::kFace, SideId(f, 0)};
}

}  // namespace

Location locate(const Mesh& mesh, VertexId start, Vec2 p) {
  FaceId f = mesh.side_of(start).face();
  // Which of the sides that p is beyond is crossed first is drawn anew at each step: a walk that always takes
  // the first can go round for ever where the mesh is not Delaunay.
  for (std::uint32_t step = 0;; ++step) {
    const auto first = static_cast<int>(mix32(f.value() ^ mix32(step)) % 3);
    double turn[3];
    SideId beyond;
    for (int i = 0; i < 3; ++i) {
      const int k = (first + i) % 3;
      turn[k] = orient2d(mesh.point(mesh.corner(f, k)), mesh.point(mesh.corner(f, (k + 1) % 3)), p);
      if (turn[k] < 0) {
        beyond = SideId(f, k);
        break;
      }
    }
    if (!beyond.valid()) return place_in_face(f, turn);
    const SideId across = mesh.neighbour(beyond);
    if (!across.valid()) return {Place::kOutside, beyond};
    f = across.face();
  }
}

VertexGrid::VertexGrid(const Mesh& mesh) : box_(mesh.box()) {
  const double vertices = static_cast<double>(mesh.vertex_slots());
  const double cell = std::sqrt(std::max(box_.width() * box_.height(), 1e-300) * 8 / vertices);
  columns_ = static_cast<std::size_t>(std::clamp(box_.width() / cell, 1.0, 1e5)) + 1;
  rows_ = static_cast<std::size_t>(std::clamp(box_.height() / cell, 1.0, 1e5)) + 1;
  cells_.assign(columns_ * rows_, VertexId());
  VertexId last;
  for (const VertexId v : mesh.vertices()) {
    if (!mesh.alive(v)) continue;
    VertexId& cell_vertex = cells_[cell_of(mesh.point(v))];
    if (!cell_vertex.valid()) cell_vertex = v;
  }
  // Empty cells take the vertex of the one before, so that every look-up finds something.
  for (int sweep = 0; sweep < 2; ++sweep)
    for (VertexId& cell_vertex : cells_)
      cell_vertex.valid() ? void(last = cell_vertex) : void(cell_vertex = last);
}

std::size_t VertexGrid::cell_of(Vec2 p) const {
  const auto index = [](double value, double low, double extent, std::size_t count) {
    const double share = extent > 0 ? (value - low) / extent : 0;
    return static_cast<std::size_t>(
        std::clamp(share * static_cast<double>(count), 0.0, static_cast<double>(count - 1)));
  };
  return index(p.y, box_.low.y, box_.height(), rows_) * columns_ +
         index(p.x, box_.low.x, box_.width(), columns_);
}

VertexId VertexGrid::near(Vec2 p) const { return cells_[cell_of(p)]; }

}  // namespace quarry::deferred
