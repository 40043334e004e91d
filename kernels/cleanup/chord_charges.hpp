// The charges of the sectors around vertices, by the corners of faces: what collapses of chords are judged by
// on a mesh in one piece, where a sector has no vertex of its own.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/mesh/mesh.hpp"

namespace quarry {

// The charge of a sector is the number of faces that it should have less the number that it has. No operation
// inside a cell between lines changes the sum over the cell (Gauss-Bonnet): vertices of opposite charge can
// only go together.
class SectorCharges {
 public:
  // cut_open: with the vertex tag "ideal_faces". Faces keep their numbers when it is sewn again.
  explicit SectorCharges(const Mesh& cut_open);

  // Of the sector at the origin of a side that has the face of this side.
  [[nodiscard]] int operator[](SideId s) const {
    return charges_[s.face().value()][static_cast<std::size_t>(s.index())];
  }

 private:
  std::vector<std::array<std::int8_t, 4>> charges_;  // by face
};

}  // namespace quarry
