// A few neighbouring faces of a mixed mesh seen as one polygon, to be cut anew.
#pragma once

#include <array>
#include <span>

#include "engine/mesh/constraint.hpp"
#include "engine/operation/editor.hpp"
#include "kernels/cluster/dissection.hpp"

namespace quarry {

// One side of the polygon.
struct RimSide {
  VertexId origin;
  SideId across;
  bool constrained;
  bool names_vertex;  // side_of its origin lies in the patch
};

class Patch {
 public:
  static constexpr int kMostFaces = 5;

  // Joins the faces; each but the first shares an unconstrained side with one before it. False if their union
  // is no simple polygon of at most kMostPolygonCorners corners, or if a constraint runs inside.
  [[nodiscard]] bool gather(const Mesh& mesh, ConstraintTags tags, std::span<const FaceId> faces);

  [[nodiscard]] int corners() const { return corner_count_; }
  [[nodiscard]] VertexId vertex(int i) const { return rim_[static_cast<std::size_t>(i)].origin; }
  // The side across the side that starts at a corner; none on the rim of the mesh.
  [[nodiscard]] SideId across(int i) const { return rim_[static_cast<std::size_t>(i)].across; }
  // How many of the faces meet at a corner.
  [[nodiscard]] int faces_at(int i) const { return faces_at_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] std::span<const FaceId> faces() const {
    return std::span(faces_).first(static_cast<std::size_t>(face_count_));
  }

  // Puts the faces of a dissection of this polygon in the place of the old ones. Slots that are left over
  // die; where there are too few, new ids are taken.
  void apply(MeshEditor& editor, ConstraintTags tags, const Dissection& dissection, NewIds ids) const;

 private:
  [[nodiscard]] bool contains(FaceId f) const;

  int face_count_ = 0;
  int corner_count_ = 0;
  std::array<FaceId, kMostFaces> faces_;
  std::array<RimSide, kMostPolygonCorners> rim_;
  std::array<int, kMostPolygonCorners> faces_at_{};
};

}  // namespace quarry
