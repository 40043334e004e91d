// A strip of quads side by side, and its shear: every rung between its ends is drawn from one rail to the
// next place of the other. Rotating an edge is the shear of two quads.
//
//   a0--a1--a2--a3        rungs a[i] - b[i]; quad i has the rungs i and i + 1
//   |   |   |   |         shear, not mirrored: the rungs become a[i+1] - b[i-1]
//   b0--b1--b2--b3        mirrored:            the rungs become b[i+1] - a[i-1]     (i = 1 .. count - 1)
//
// Whatever the length, four vertices change their number of faces: the shear that is not mirrored gives one
// more to b[0] and a[count], and one less to a[1] and b[count - 1]. So a pair of a vertex with three faces at
// b[0] and one with five at a[1] moves to the other end in one operation.
#pragma once

#include <array>
#include <cstdint>

#include "kernels/cleanup/local_change.hpp"
#include "kernels/cleanup/local_view.hpp"

namespace quarry {

class Strip {
 public:
  static constexpr int kMostQuads = 12;

  // A shear by its first inner rung a[1] -> b[1], as a side of the first quad, and the number of quads.
  struct Plan {
    SideId rung;
    std::uint8_t quads = 2;
    bool mirrored = false;
  };

  // Starts with the quad of the rung; false if it is none.
  bool begin(const LocalView& view, SideId rung);
  // Adds the quad across the last rung. False at the boundary, at a triangle, where the strip meets itself,
  // or when it has kMostQuads.
  bool extend(const LocalView& view);
  [[nodiscard]] int quads() const { return count_; }

  // What a shear of the strip so far gains in energy, its beginning and its end.
  [[nodiscard]] int gain_at_start(const LocalView& view, bool mirrored) const;
  [[nodiscard]] int gain_at_end(const LocalView& view, bool mirrored) const;
  // False if a vertex would be left with too few faces, or an edge made that is there already.
  [[nodiscard]] bool can_shear(const LocalView& view, bool mirrored) const;
  void shear(bool mirrored, LocalChange& change) const;

  // The change that a plan stands for.
  static void build(const LocalView& view, const Plan& plan, LocalChange& change);

 private:
  [[nodiscard]] bool meets(VertexId v) const;
  [[nodiscard]] VertexId a(int i) const { return a_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] VertexId b(int i) const { return b_[static_cast<std::size_t>(i)]; }

  int count_ = 0;
  SideId last_;  // the last rung as a side of the last quad
  std::array<VertexId, kMostQuads + 1> a_, b_;
  std::array<FaceId, kMostQuads> faces_;
};

}  // namespace quarry
