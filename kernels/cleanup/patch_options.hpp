// Options of one-defect patches.
#pragma once

#include <cstddef>

#include "kernels/cleanup/patch_stars.hpp"
#include "kernels/smooth/local_smoother.hpp"

namespace quarry {

struct PatchOptions {
  std::size_t largest = 512;  // faces a patch may have: the size class
  int partners = 4;           // nearest irregular vertices that a seed is paired with, one after the other
  // Then by single rows, and on one side of the seed only along so many of its edges; 0: never. Not in
  // classes in which seeds times faces are more than `most_work` times the mesh's faces: near lines most
  // seeds of large patches are hopeless.
  int directions = 4;
  double most_work = 6;
  // Faces of a fill, as a share of those before: near lines small patches need room to change, while large
  // ones of another number of faces stretch many quads.
  double fewest_faces = 0.6, most_faces = 1.7;
  double fewest_faces_of_large = 0.75, most_faces_of_large = 1.35;
  std::size_t large = 128;  // more faces than these
  // The whole mesh: fills that take its number of faces further than these shares from `wanted_faces` (0:
  // those at the start) are left out.
  double most_growth = 0.1, most_shrinkage = 0.1;
  std::size_t wanted_faces = 0;
  // A fill is kept if its smallest scaled Jacobian, with the ring around it and after smoothing, is at least
  // the smaller of this and what it was.
  double least_jacobian = 0.3;
  // And if their mean over its faces is by no more than this below what it was: fills of sheared rows are
  // valid, and look it.
  double most_mean_loss = 0.15;
  // Nor may the longest edge of one of its faces by the shortest be more than this, or than it was before.
  double largest_edge_ratio = 6;
  // Nor may an edge be longer than so many times the root of the mean area of the faces before, or than there
  // was one before. 0: any may.
  double longest_edge = 0;
  // Fills of more faces than these start at harmonic places, see patch_placement.hpp: fewer of them are
  // refused.
  std::size_t harmonic_from = 0;
  // Of the fills that are folded after six sweeps of untangling one in two hundred would ever be kept.
  LocalShapeOptions smoothing{.untangling_sweeps = 6, .sweeps = 4};
  // The mesh, in the plane, is sewn along its lines (sew_pieces, with find_regular_nodes of these slots):
  // only patches that a line crosses are looked for. None: it is cut open along all of them.
  const NodeSlots* over_lines = nullptr;
  IrregularPrice price;  // empty: all places cost the same
  bool reverse = false;  // commit winners last to first: a test that they are independent
};

}  // namespace quarry
