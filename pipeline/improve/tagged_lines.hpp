// The line work that a finished mesh bears: its boundary, its tagged edges, and the interfaces between its
// regions, as the nodes and straight pieces that kernels keep. Vertices where lines end, meet, bend or change
// their numbers become nodes and never move; the others slide along the straight piece that they lie on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/geometry/line_set.hpp"
#include "engine/mesh/constraint.hpp"
#include "engine/mesh/mesh.hpp"

namespace quarry {

// An edge that a file bears, with the number of its group; -1 for none.
struct TaggedEdge {
  VertexId a, b;
  std::int32_t number = -1;
};

struct TaggedLines {
  // line_numbers are those of the groups, but for -1.
  NodedLines lines;
  // What a piece means, by its number.
  struct Meaning {
    std::uint32_t number_begin = 0, number_end = 0;  // in numbers
    // Of the faces on its left and right, seen from `from` to `to`; kNoRegion outside the domain.
    std::int32_t left = 0, right = 0;
  };
  static constexpr std::int32_t kNoRegion = -0x7fffffff - 1;
  std::vector<Meaning> meanings;
  std::vector<std::int32_t> numbers;
  // The number of the input's point at each node, or -1; empty where the mesh has none.
  std::vector<std::int32_t> points;
  // How many tagged edges are no side of a face. They are edge entities of the mesh, and their ends are
  // fixed.
  std::size_t apart = 0;

  // The numbers of a piece, ascending, -1 among them where an edge is tagged without a number; empty for the
  // boundary and for interfaces that the file does not tag.
  [[nodiscard]] std::span<const std::int32_t> numbers_of(PieceId piece) const {
    const Meaning& meaning = meanings[piece.value()];
    return std::span(numbers).subspan(meaning.number_begin, meaning.number_end - meaning.number_begin);
  }
};

// Finds the lines of a mesh with the face tag "region" and adds ConstraintTags that bind it to them; vertices
// with the tag kPointTag are nodes too. The mesh has no tombstones. tolerance: a vertex between two nodes may
// lie this far from the piece that joins them, in input units; a tagged edge covered by a chain of sides is
// that chain (pipeline/improve/side_chains.hpp). Each fan at a point where the domain touches
// itself gets a vertex of its own (engine/mesh/pinch.hpp). The mesh has no edge entities before, and those
// that are no side of a face with the tag "constraint" afterwards.
[[nodiscard]] TaggedLines bind_lines(Mesh& mesh, const std::vector<TaggedEdge>& tagged, double tolerance);

// The inverse, after the mesh was changed within its lines: sets the tag "region" to the numbers that faces
// had between the same pieces, and adds edge entities for the boundary and all tagged edges, with the tags
// "constraint" and "kind", and points to their vertices.
void restore_groups(Mesh& mesh, const TaggedLines& lines);

}  // namespace quarry
