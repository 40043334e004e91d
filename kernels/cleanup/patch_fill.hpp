// Closed forms: which patches of 3 to 6 sides can be filled with quads around at most one defect (or a pair
// of a 3-valent and a 5-valent vertex), and the counts of such a fill. Bunin, "Non-local topological
// clean-up", 15th IMR 2006; the whole-number solutions are those of Jaal's matrices with the conditions on
// parity and sign that truncation hides.
//
// One interior vertex O of valence n has n spokes; spoke i ends on side i, has s_i edges, and its neighbours
// cut side i so that L_i = s_(i-1) + s_(i+1). A four-sided patch of equal opposite sides is a plain grid.
// Where they differ, two grids hang from a vertex (the apex) of the shorter side and a three-sided patch lies
// between them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

namespace quarry {

enum class FillKind : std::uint8_t { kThree, kGrid, kPair, kFive, kSix };
inline constexpr std::size_t kFillKinds = 5;

// A way to fill a patch. Sides are numbered from `first` on, cyclically.
struct PatchFill {
  FillKind kind = FillKind::kGrid;
  std::uint8_t first = 0;
  // Edges of the spokes to the sides first, first + 1, ...; of kPair those to the three sides of the part
  // between the grids, which are as long as side first + 1, the difference, and side first + 3.
  std::array<std::uint32_t, 6> spokes{};
  // Of kPair: edges from the first corner of side `first` to the apex.
  std::uint32_t split = 0;

  friend bool operator==(const PatchFill&, const PatchFill&) = default;
};

// Spokes of the fill around one vertex of valence 3, 5 or 6; none if no whole numbers of at least 1 solve it.
// lengths: edges of the sides, as many as the valence.
[[nodiscard]] std::optional<std::array<std::uint32_t, 6>> solve_spokes(
    std::span<const std::uint32_t> lengths);

// The fill of a patch with 3, 5 or 6 sides, or of 4 if it is a plain grid; none where there is none.
[[nodiscard]] std::optional<PatchFill> solve_fill(std::span<const std::uint32_t> lengths);

// The fill with a pair in which side `first` is the shorter one that bears the apex, as yet at its first
// vertex: split may be any of 1 to lengths[first] - 1. None where no such fill exists. lengths: four.
[[nodiscard]] std::optional<PatchFill> solve_pair(std::span<const std::uint32_t> lengths, std::uint8_t first);

// Pushing a side outwards by a row of quads lengthens its spoke by one and changes no other. Bits of the
// sides that would have to be pushed before a patch without a fill can have one; 0 where no pushing helps,
// because of the parity.
[[nodiscard]] std::uint32_t sides_to_push(std::span<const std::uint32_t> lengths);

// Quads of the fill. lengths: of the sides of the patch.
[[nodiscard]] std::uint64_t count_faces(const PatchFill& fill, std::span<const std::uint32_t> lengths);

}  // namespace quarry
