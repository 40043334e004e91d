// Toggling the arcs around an interior vertex, or around two joined ones, turns a join into another one:
// every triangle around the vertex has two of these arcs, so that its degree stays odd. What that changes in
// cost, and the change itself.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/matching/merge_cost.hpp"

namespace quarry::matching {

// The join under search, with what the cost of a toggle depends on.
struct SearchState {
  const Mesh& mesh;
  const MergeCosts& costs;
  DualArcs& join;
  // Faces that the quad mesh has around each vertex, and how many it should have (0: does not matter).
  IdVector<VertexId, std::int16_t> valence;
  IdVector<VertexId, std::uint8_t> ideal;
  // Vertices whose arcs may be toggled: interior, off the constraints, with few enough faces.
  IdVector<VertexId, std::uint8_t> free;

  SearchState(const Mesh& of, ConstraintTags tags, const MergeCosts& merge_costs, DualArcs& start);
};

// One vertex, or two that share an edge.
struct Star {
  VertexId first, second;
};

// The faces and vertices that one toggle changes. Keeps its memory on the stack: one a chunk.
class StarToggle {
 public:
  static constexpr std::size_t kMostFaces = 16;  // around a free vertex

  explicit StarToggle(SearchState& state) : state_(&state) {}

  // Reads the stars. All vertices must be free.
  void gather(Star star);
  // What the toggle adds to the cost of the join.
  [[nodiscard]] int gain_in_cost();
  // Does it. gain_in_cost() was called before.
  void commit();
  // The vertices of the gathered faces, once each.
  [[nodiscard]] std::span<const VertexId> vertices() const {
    return std::span(vertices_).first(vertex_count_);
  }

 private:
  static constexpr std::uint8_t kUnknown = 255;

  struct Face {
    FaceId id;
    std::uint8_t before, after;
    std::array<std::uint8_t, 3> corner;  // positions in vertices_
    std::array<std::uint8_t, 3> across;  // positions in faces_, as far as known
  };

  std::uint8_t add_vertex(VertexId v);
  std::uint8_t position_of(VertexId v);
  std::uint8_t add_face(SideId s, std::uint8_t here, std::uint8_t next, std::uint8_t previous);
  void join_in_turn(std::uint8_t face, SideId s, std::uint8_t after, SideId t);
  void gather_first(VertexId v);
  void gather_second(VertexId first, VertexId v);
  [[nodiscard]] std::uint8_t find(FaceId f) const;
  [[nodiscard]] int change_at(const Face& face, int k) const;
  void count_valences(const Face& face);

  SearchState* state_;
  std::array<Face, 2 * kMostFaces> faces_;
  std::array<VertexId, 4 * kMostFaces> vertices_;
  std::array<int, 4 * kMostFaces> more_faces_;  // around each vertex, after the toggle
  std::size_t face_count_ = 0, vertex_count_ = 0;
};

}  // namespace quarry::matching
