// What collapses of chords were asked, and what came of it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "engine/operation/pass.hpp"

namespace quarry {

// Why the chords between two vertices of opposite charge are not collapsed.
enum class ChordReject : std::uint8_t {
  kLong,      // too long to be looked at
  kLines,     // fixed vertices, or lines, would become one
  kNotWhole,  // a face or an edge would be lost beside them
  kFewFaces,  // around a vertex: a corner would be a half turn or more
  kNoGain,    // the valence energy would not fall, or by too little for their faces
  kOverlap,   // they touch others that gain more: looked at anew in the next round, if there is one
  kFaceBand,  // the mesh would have too few faces
  kQuality,   // judged after smoothing
};
inline constexpr std::size_t kChordRejects = 8;

struct ChordReport {
  std::uint64_t chords = 0;       // at the start
  std::uint64_t collapsible = 0;  // of them
  std::uint64_t sets = 0;         // of chords between vertices of opposite charge, looked at in all rounds
  std::uint64_t rounds = 0;
  std::uint64_t tried = 0, won = 0;
  std::uint64_t faces = 0;  // that went with those that won
  double gained = 0;        // valence energy
  std::array<std::uint64_t, kChordRejects> rejected{};
  PassReport commits;  // without a name

  void reject(ChordReject reason, std::uint64_t times = 1) {
    rejected[static_cast<std::size_t>(reason)] += times;
  }
};

}  // namespace quarry
