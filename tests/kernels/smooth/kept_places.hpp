// What every smoother leaves in place.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "engine/geometry/segment.hpp"
#include "tests/kernels/smooth/quads_with_lines.hpp"

namespace quarry::test {

// Smooths, and expects that fixed vertices keep their bits, and that sliding ones lie on their pieces (within
// a rounding of the coordinates of synthetic meshes), some of them elsewhere than before.
template <class Smooth>
void expect_fixed_and_sliders_kept(QuadsWithLines& quads, const Smooth& smooth) {
  const ConstraintTags tags = ConstraintTags::of(quads.mesh);
  std::vector<Vec2> before;
  for (const VertexId v : quads.mesh.vertices()) before.push_back(quads.mesh.point(v));
  smooth();
  const double ulp = std::numeric_limits<double>::epsilon() * 6.8e6;
  std::size_t slid = 0;
  for (const VertexId v : quads.mesh.vertices()) {
    const Vec2 now = quads.mesh.point(v);
    if (tags.support[v].is_fixed()) {
      EXPECT_EQ(now, before[v.value()]);
    }
    if (!tags.support[v].slides()) continue;
    slid += now == before[v.value()] ? 0 : 1;
    const Piece& piece = quads.lines.pieces[tags.support[v].piece()];
    EXPECT_LE(squared_distance(now, quads.lines.nodes[piece.from], quads.lines.nodes[piece.to]), ulp * ulp);
  }
  EXPECT_GT(slid, 0U);
}

}  // namespace quarry::test
