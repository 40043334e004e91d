// One ray against many triangles, such that no ray slips through where triangles meet. The ray is turned into
// the origin of a plane: each corner is sheared along the ray (Woop, Benthin & Wald 2013), which gives the
// same bits in every triangle that has it, and which side of an edge the origin lies on is then decided
// exactly. So the decisions are right for a surface whose corners lie a few roundings from where they were
// given, the same ones for all of its triangles: if that is closed, so is this.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "engine/geometry/vec.hpp"
#include "surface/project/triangle_point.hpp"

namespace quarry {

// Where a ray meets a triangle.
struct RayCrossing {
  double parameter = 0;  // in lengths of the ray's direction
  CornerWeights weights{};
  // Whether the ray comes from the side that the triangle's normal points to.
  bool from_front = false;
};

class ShearedRay {
 public:
  // direction: not zero; of any length.
  ShearedRay(Vec3 origin, Vec3 direction);

  // Where the whole line meets the closed triangle, edges and corners included: at an edge or a corner with
  // the same bits of the parameter for all triangles that have it. None for a triangle seen edge on, whose
  // neighbours have its edges.
  [[nodiscard]] std::optional<RayCrossing> touch(const TriangleCorners& corners) const;

  // The same for the line moved sideways by next to nothing, always the same way: at an edge it crosses one
  // of two triangles that form a sheet, both or none of two that form a crest. What counts crossings needs
  // this.
  [[nodiscard]] std::optional<RayCrossing> cross(const TriangleCorners& corners) const;

 private:
  struct Sheared {
    Vec2 across;   // where the corner lies as seen along the ray
    double along;  // how far along the ray it lies
  };
  using ShearedCorners = std::array<Sheared, 3>;
  using Sides = std::array<double, 3>;

  [[nodiscard]] ShearedCorners shear(const TriangleCorners& corners) const;
  [[nodiscard]] static Sides sides_of(const ShearedCorners& corners);
  [[nodiscard]] RayCrossing crossing(const ShearedCorners& corners, const Sides& sides,
                                     bool from_front) const;

  Vec3 origin_;
  std::size_t x_ = 0, y_ = 1, z_ = 2;  // axes; z_ is the one that the direction has most of
  double shear_x_ = 0, shear_y_ = 0, stretch_z_ = 1;
};

}  // namespace quarry
