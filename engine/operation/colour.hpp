// Colour classes for sweeps that change no topology: no two vertices of a class share a face, so that the
// vertices of a class may move at the same time, in place, while each reads its star.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/mesh/mesh.hpp"

namespace quarry {

// A partial colouring that grows with the vertices that are met. It is what a greedy colouring in the order
// of the calls, and within a call in the order of a hash of the vertex number, would give (Jones & Plassmann
// 1993): a function of the mesh and the calls, whatever the threads.
class VertexColouring {
 public:
  explicit VertexColouring(const Mesh& mesh) : mesh_(&mesh), colours_(mesh.vertex_slots(), kNone) {}

  // Colours those of the vertices that have no colour yet.
  void extend(std::span<const std::uint32_t> vertices);

  [[nodiscard]] bool coloured(VertexId v) const { return colours_[v] < kPending; }
  [[nodiscard]] int colour(VertexId v) const { return colours_[v]; }

  // The vertices sorted into classes; each class keeps their order. Every vertex must be coloured.
  [[nodiscard]] std::vector<std::vector<std::uint32_t>> classes(
      std::span<const std::uint32_t> vertices) const;

 private:
  static constexpr std::uint8_t kNone = 255;
  static constexpr std::uint8_t kPending = 254;

  bool try_colour(VertexId v);
  [[nodiscard]] std::uint8_t load(VertexId v) const;
  void store(VertexId v, std::uint8_t colour);

  const Mesh* mesh_;
  IdVector<VertexId, std::uint8_t> colours_;
};

}  // namespace quarry
