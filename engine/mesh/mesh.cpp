#include "engine/mesh/mesh.hpp"

#include <algorithm>
#include <cassert>

#include "engine/parallel/parallel.hpp"

namespace quarry {

std::size_t Mesh::count_alive_vertices() const {
  return parallel::reduce_ordered(
      vertex_slots(), std::size_t{0},
      [&](std::size_t begin, std::size_t end) {
        std::size_t count = 0;
        for (std::size_t i = begin; i < end; ++i) count += alive(VertexId(i)) ? 1 : 0;
        return count;
      },
      [](std::size_t a, std::size_t b) { return a + b; });
}

std::size_t Mesh::count_alive_faces() const {
  return parallel::reduce_ordered(
      face_slots(), std::size_t{0},
      [&](std::size_t begin, std::size_t end) {
        std::size_t count = 0;
        for (std::size_t i = begin; i < end; ++i) count += alive(FaceId(i)) ? 1 : 0;
        return count;
      },
      [](std::size_t a, std::size_t b) { return a + b; });
}

Box2 Mesh::box() const {
  Box2 box;
  for (const VertexId v : vertices())
    if (alive(v)) box.extend(point(v));
  return box;
}

Box3 Mesh::box3() const {
  Box3 box;
  for (const VertexId v : vertices())
    if (alive(v)) box.extend(point3(v));
  return box;
}

SideId Mesh::find_side(VertexId a, VertexId b) const {
  SideId found;
  const SideId first = side_of(a);
  for (SideId s = first; s.valid();) {
    if (target(s) == b) return s;
    s = turn_left(s);
    if (s == first) break;
  }
  return found;
}

void Mesh::delete_face(FaceId f) {
  for (int i = 0; i < 4; ++i) {
    set_corner(SideId(f, i), VertexId());
    set_neighbour(SideId(f, i), SideId());
  }
}

void Mesh::make_spatial() {
  assert(vertex_slots() == 0);
  spatial_ = true;
}

VertexId Mesh::grow_vertices(std::size_t count) {
  const VertexId first(vertex_slots());
  const std::size_t size = vertex_slots() + count;
  if (!planar()) z_.resize(size, 0.0);
  x_.resize(size, 0.0);
  y_.resize(size, 0.0);
  side_of_.resize(size, kDeadVertex);
  vertex_tags_.resize(size);
  return first;
}

FaceId Mesh::grow_faces(std::size_t count) {
  const FaceId first(face_slots());
  const std::size_t size = face_slots() + count;
  corners_.resize(size * 4);
  neighbours_.resize(size * 4);
  face_tags_.resize(size);
  return first;
}

void Mesh::reserve(std::size_t vertex_count, std::size_t face_count) {
  x_.reserve(vertex_count);
  y_.reserve(vertex_count);
  if (!planar()) z_.reserve(vertex_count);
  side_of_.reserve(vertex_count);
  corners_.reserve(face_count * 4);
  neighbours_.reserve(face_count * 4);
}

EdgeId Mesh::add_edge(VertexId a, VertexId b) {
  const EdgeId e = edge_ends_.push_back({a, b});
  edge_tags_.resize(edge_slots());
  return e;
}

std::size_t Mesh::bytes() const {
  return (x_.size() + y_.size() + z_.size()) * sizeof(double) + side_of_.size() * sizeof(SideId) +
         corners_.size() * sizeof(VertexId) + neighbours_.size() * sizeof(SideId) +
         edge_ends_.size() * sizeof(std::pair<VertexId, VertexId>) + vertex_tags_.bytes() +
         edge_tags_.bytes() + face_tags_.bytes();
}

}  // namespace quarry
