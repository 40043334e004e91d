// Which collapses of edges leave a surface mesh sound, and how good the star is that comes of them.
#pragma once

#include "surface/remesh/state.hpp"

namespace quarry {

struct Collapse {
  VertexId gone, kept;
};

class CollapseGuard {
 public:
  // Triangles may become as low as `lowest` for the sake of a collapse, and lower only where one was lower
  // before.
  CollapseGuard(const RemeshState& state, double lowest)
      : state_(state), guard_(state.guard()), lowest_(lowest) {}

  // A free vertex may leave along any edge, one on a feature along that feature only.
  [[nodiscard]] bool may_go(SideId s, VertexId v) const {
    const Support support = state_.tags.support[v];
    return support.is_free() || (support.slides() && state_.tags.constrained(s));
  }
  // The measure of the worst triangle that changes; -1 if the collapse along s may not be: the mesh would be
  // none, a triangle would face another way or become low, or the feature would be left by more than the
  // options allow.
  [[nodiscard]] double worst_after(SideId s, Collapse way) const;

 private:
  [[nodiscard]] bool keeps_feature(Collapse way) const;

  const RemeshState& state_;
  TriangleGuard guard_;
  double lowest_;
};

}  // namespace quarry
