// Options and report of lattices on surfaces.
#pragma once

#include <cstdint>

#include "engine/operation/pass.hpp"
#include "kernels/crossfield/cross_field.hpp"
#include "kernels/crossfield/position_field.hpp"
#include "kernels/crossfield/spacing_field.hpp"

namespace quarry {

struct LatticeOptions {
  CrossFieldOptions crosses = {};
  PositionFieldOptions positions = {};
  // Of the cells, which are larger and smaller where the crosses turn.
  SpacingFieldOptions spacing = {};
  // How many cells there are to be; 0: as many as the spacing gives. The spacing is corrected until they are
  // within so much of it, in at most so many attempts.
  double wanted_cells = 0;
  double cell_tolerance = 0.015;
  int attempts = 3;
  // Triangles may become as low as this (Lo's measure) when vertices with one lattice point are joined: moves
  // and flips mend them.
  double lowest_joined = 0.1;
  // Joining vertices along features may not leave them by more than this share of the spacing.
  double feature_deviation = 0.25;
  // Rounds of flips and of moves to the lattice points, as far as no triangle becomes lower than `content`
  // for it; right-angled ones with equal legs have 0.87.
  int rounds = 3;
  int sweeps = 4;
  double content = 0.5;
  // Then rounds of repair: edges shorter than so many spacings are collapsed, if none longer than so many
  // comes of it; corners of triangles that are lower than `content` move to the middle of their stars; flips.
  double shortest = 0.4, longest = 1.7;
  int repair_rounds = 6;
};

struct LatticeReport {
  std::uint64_t vertices = 0;       // that the fields were found at
  std::uint64_t singularities = 0;  // of the crosses
  // Vertices that went into another one with the same lattice point; edges collapsed that were too short;
  // flips, those of the repair among them.
  PassReport joins{.name = "joins to lattice points"}, collapses{.name = "collapses to lattice points"};
  PassReport flips{.name = "flips of the lattice"};
  std::uint64_t moves = 0, repairs = 0;
  double scale = 1;  // of the spacing, as corrected
  double cross_seconds = 0, position_seconds = 0, change_seconds = 0;
};

}  // namespace quarry
