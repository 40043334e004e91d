// What the patches of one size class were asked, and what came of it.
#pragma once

#include <array>
#include <cstdint>

#include "engine/operation/pass.hpp"
#include "kernels/cleanup/patch_fill.hpp"

namespace quarry {

// Why a convex stage of a growing patch, or the patch that was found, is not put into the mesh.
enum class PatchReject : std::uint8_t {
  kNoDisk,       // a hole, or a line inside
  kFewSides,     // fewer than three
  kManySides,    // more than six, or more reflex corners than cuts take away
  kNoSolution3,  // the closed form has no whole numbers; by sides
  kNoSolution4,
  kNoSolution5,
  kNoSolution6,
  kFaceBand,    // too many faces, or too few
  kNoGain,      // the valence energy would not fall
  kLines,       // a line inside does not pass; over lines also: there is none
  kDoubleEdge,  // two rim vertices would be joined twice
  kQuality,     // judged after smoothing
};
inline constexpr std::size_t kPatchRejects = 12;

struct PatchReport {
  std::uint64_t largest = 0;                         // faces a patch might have
  bool over_lines = false;                           // patches that lines cross
  std::uint64_t seeds = 0;                           // irregular vertices at the start
  std::uint64_t searches = 0;                        // of patches around a seed
  std::uint64_t stages = 0;                          // convex stages that were looked at
  std::uint64_t grown_faces = 0;                     // taken in by all searches together
  std::uint64_t found = 0;                           // patches that searches returned
  std::uint64_t duplicates = 0;                      // of them another search had found as well
  std::uint64_t proposals = 0;                       // of the rest those that overlap no better one
  std::uint64_t waves = 0;                           // of searches
  PassReport commits;                                // without a name
  std::array<std::uint64_t, kFillKinds> proposed{};  // by kind of fill
  std::array<std::uint64_t, kFillKinds> won{};
  std::array<std::uint64_t, kPatchRejects> rejected{};
  double search_seconds = 0, commit_seconds = 0;

  [[nodiscard]] std::uint64_t count_won() const {
    std::uint64_t sum = 0;
    for (const std::uint64_t count : won) sum += count;
    return sum;
  }
  void reject(PatchReject reason) { ++rejected[static_cast<std::size_t>(reason)]; }
  // Adds the counts of another report; `largest` stays.
  void add(const PatchReport& other);
};

}  // namespace quarry
