// The charges of the sectors around vertices, by the corners of faces: what collapses of chords are judged by
// on a mesh in one piece, where a sector has no vertex of its own.
#pragma once

#include <algorithm>
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
  using OfFace = std::array<std::int8_t, 4>;  // at its corners

  // cut_open: with the vertex tag "ideal_faces". Faces keep their numbers when it is sewn again.
  explicit SectorCharges(const Mesh& cut_open);

  // Of the sector at the origin of a side that has the face of this side.
  [[nodiscard]] int operator[](SideId s) const {
    return charges_[s.face().value()][static_cast<std::size_t>(s.index())];
  }

  // For faces that an operation has given other corners, or other sectors.
  void set(FaceId f, const OfFace& charges) { charges_[f.value()] = charges; }
  // The charge as it is kept: beyond a byte it says no more than its sign.
  [[nodiscard]] static std::int8_t stored(int charge) {
    return static_cast<std::int8_t>(std::clamp(charge, -128, 127));
  }

 private:
  std::vector<OfFace> charges_;  // by face
};

}  // namespace quarry
