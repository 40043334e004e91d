// The cavity of a proposed local operation: the vertices whose stars it reads or changes, and how many
// entities it will create. Who holds all corners of a face owns the face; who holds both ends of an edge owns
// the two neighbour slots of that edge.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "engine/base/id.hpp"

namespace quarry {

// The claims of the operations of one chunk, one after the other; grows without bound, since stars do.
class Cavity {
 public:
  explicit Cavity(std::vector<VertexId>& storage) : storage_(&storage), begin_(storage.size()) {}

  // Claiming a vertex twice is allowed and costs only time.
  void claim(VertexId v) { storage_->push_back(v); }
  // Tells how many vertices and faces apply() will fill in: exactly these are reserved.
  void will_create(std::uint32_t vertices, std::uint32_t faces) {
    new_vertices_ = vertices;
    new_faces_ = faces;
  }
  // Forgets what was claimed so far.
  void clear() {
    storage_->resize(begin_);
    will_create(0, 0);
  }

  [[nodiscard]] std::span<const VertexId> claims() const { return std::span(*storage_).subspan(begin_); }
  [[nodiscard]] std::uint32_t new_vertices() const { return new_vertices_; }
  [[nodiscard]] std::uint32_t new_faces() const { return new_faces_; }

 private:
  std::vector<VertexId>* storage_;
  std::size_t begin_;
  std::uint32_t new_vertices_ = 0;
  std::uint32_t new_faces_ = 0;
};

// The ids that a winner may fill in: consecutive from these on.
struct NewIds {
  VertexId vertex;
  FaceId face;

  VertexId take_vertex() { return std::exchange(vertex, VertexId(vertex.value() + 1)); }
  FaceId take_face() { return std::exchange(face, FaceId(face.value() + 1)); }
};

}  // namespace quarry
