// The part of a ray that lies in the box of a surface, in local floats: what a tree of boxes is asked with.
// Starting at the box keeps the floats exact enough for rays that come from afar.
#pragma once

#include "engine/geometry/vec.hpp"
#include "surface/project/float_frame.hpp"

namespace quarry {

class LocalRay {
 public:
  // box, frame: of the surface.
  LocalRay(const Box3& box, const FloatFrame& frame, Vec3 origin, Vec3 direction);

  // No triangle is on the way.
  [[nodiscard]] bool misses() const { return !(entry_ <= exit_); }
  [[nodiscard]] FloatPoint origin() const { return FloatFrame::rounded(origin_ + entry_ * direction_); }
  [[nodiscard]] FloatPoint direction() const { return FloatFrame::rounded(direction_); }
  [[nodiscard]] float length() const { return covering_length(exit_); }
  // To a parameter of the given ray, and a little farther.
  [[nodiscard]] float length_to(double parameter) const { return covering_length(parameter * unit_); }

 private:
  [[nodiscard]] float covering_length(double end) const;

  // Local coordinates; a direction of length 1.
  Vec3 origin_, direction_;
  double unit_ = 1;               // the local length of the given direction
  double entry_ = 0, exit_ = -1;  // local lengths from the origin
};

}  // namespace quarry
