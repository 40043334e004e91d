// Quads with constraints, made from a synthetic triangle mesh by pairing and halving; not smoothed.
#pragma once

#include <utility>

#include "kernels/cluster/merge.hpp"
#include "kernels/cluster/subdivide.hpp"
#include "tests/support/synthetic_mesh.hpp"

namespace quarry::test {

struct QuadsWithLines {
  Mesh mesh;
  NodedLines lines;
};

inline QuadsWithLines make_quads(const SyntheticOptions& options) {
  SyntheticMesh made = make_synthetic(options);
  PairingReport paired;
  const Pairing pairing = pair_triangles(made.mesh, made.tags, {}, paired, Progress());
  SubdivideReport report;
  Mesh quads = subdivide(merge_pairs(std::move(made.mesh), pairing), made.lines, report, Progress());
  return {std::move(quads), std::move(made.lines)};
}

}  // namespace quarry::test
