// Which collapses of edges leave a surface mesh sound, and how good the star is that comes of them.
#pragma once

#include <optional>

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
  // Of both ways to collapse an edge (s is a side of it), of those that allowed(Collapse) lets pass, that
  // which leaves the better star; none if neither may be.
  template <class Allowed>
  [[nodiscard]] std::optional<Collapse> better_way(SideId s, MeshEdge edge, const Allowed& allowed) const {
    std::optional<Collapse> better;
    double best = -1;
    for (const Collapse way : {Collapse{edge.a, edge.b}, Collapse{edge.b, edge.a}}) {
      if (!allowed(way)) continue;
      const double worst = worst_after(s, way);
      if (worst <= best) continue;
      best = worst;
      better = way;
    }
    return better;
  }

 private:
  [[nodiscard]] bool keeps_feature(Collapse way) const;

  const RemeshState& state_;
  TriangleGuard guard_;
  double lowest_;
};

}  // namespace quarry
