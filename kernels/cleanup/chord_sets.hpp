// The chords that lie between vertices of opposite charge.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/mesh/constraint.hpp"
#include "engine/mesh/mesh.hpp"
#include "kernels/cleanup/chord_charges.hpp"
#include "kernels/cleanup/chords.hpp"

namespace quarry {

// The chords between two vertices of opposite charge: up to three of them, ascending.
struct ChordSet {
  static constexpr std::size_t kMost = 3;
  std::array<std::uint32_t, kMost> chords{Chords::kNone, Chords::kNone, Chords::kNone};

  friend auto operator<=>(const ChordSet&, const ChordSet&) = default;
};

// All sets that collapse to join two such vertices, one or two faces apart and on the same side of all lines.
// Each once, in ascending order; sets with chords that cannot collapse are left out.
[[nodiscard]] std::vector<ChordSet> find_chord_sets(const Mesh& mesh, const ConstraintTags& tags,
                                                    const Chords& chords, const SectorCharges& charges);

// Names the faces that go. A set of the same name in another round crosses the same faces, though a collapse
// beside it may have changed what it gains: then it is left as it was judged before.
[[nodiscard]] std::uint64_t key_of(const ChordSet& set, const Chords& chords);

}  // namespace quarry
