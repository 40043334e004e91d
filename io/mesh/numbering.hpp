// Numbers the entities of a mesh that are alive from 0, in id order: files have no tombstones, and a point
// where the domain touches itself (engine/mesh/pinch.hpp) is one point. A mesh without either costs nothing
// here.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/mesh/mesh.hpp"

namespace quarry {

class LiveNumbering {
 public:
  explicit LiveNumbering(const Mesh& mesh);

  [[nodiscard]] std::size_t vertex_count() const { return vertex_count_; }
  [[nodiscard]] std::size_t face_count() const { return face_count_; }
  // Edges whose ends are alive.
  [[nodiscard]] const std::vector<EdgeId>& edges() const { return edges_; }
  // Leaves out all edges but those at the given places, ascending.
  void keep_edges(const std::vector<std::uint32_t>& places);

  [[nodiscard]] VertexId vertex(std::size_t number) const {
    return vertices_.empty() ? VertexId(number) : VertexId(vertices_[number]);
  }
  [[nodiscard]] FaceId face(std::size_t number) const {
    return faces_.empty() ? FaceId(number) : FaceId(faces_[number]);
  }
  [[nodiscard]] std::uint32_t number(VertexId v) const {
    return number_of_.empty() ? v.value() : number_of_[v.value()];
  }

 private:
  std::size_t vertex_count_ = 0;
  std::size_t face_count_ = 0;
  std::vector<std::uint32_t> vertices_;   // empty: all are alive
  std::vector<std::uint32_t> faces_;      // empty: all are alive
  std::vector<std::uint32_t> number_of_;  // by vertex slot; empty: all are alive
  std::vector<EdgeId> edges_;
};

}  // namespace quarry
