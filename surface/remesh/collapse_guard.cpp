#include "surface/remesh/collapse_guard.hpp"

#include <algorithm>

#include "kernels/local/collapse.hpp"

namespace quarry {

double CollapseGuard::worst_after(SideId s, Collapse way) const {
  const Mesh& mesh = state_.mesh;
  if (!may_go(s, way.gone) || !can_collapse(mesh, way.gone, way.kept)) return -1;
  if (!state_.tags.support[way.gone].is_free() && !keeps_feature(way)) return -1;
  double before = 1;
  double after = 1;
  bool fits = true;
  for_each_side_around(mesh, way.gone, [&](SideId side) {
    const FaceId f = side.face();
    auto corners = state_.corners(f);
    auto points = state_.points(corners);
    before = std::min(before, lo_measure(points[0], points[1], points[2]));
    if (std::find(corners.begin(), corners.end(), way.kept) != corners.end()) return;
    const Vec3 old_normal = unit_normal(points[0], points[1], points[2]);
    const auto k = static_cast<std::size_t>(side.index());
    corners[k] = way.kept;
    points[k] = state_.point(way.kept);
    after = std::min(after, lo_measure(points[0], points[1], points[2]));
    fits = fits && guard_.faces_up(corners, points) &&
           guard_.agrees(unit_normal(points[0], points[1], points[2]), old_normal);
  });
  return fits && (after >= lowest_ || after > before) ? after : -1;
}

// The feature from the vertex before the one that goes to the one that stays, nearly straight; and not so
// short a closed one that it would fold.
bool CollapseGuard::keeps_feature(Collapse way) const {
  const Mesh& mesh = state_.mesh;
  VertexId before;
  for_each_constrained_neighbour(mesh, state_.tags, way.gone, [&](VertexId v) {
    if (v != way.kept) before = v;
  });
  if (!before.valid() || mesh.find_side(before, way.kept).valid() || mesh.find_side(way.kept, before).valid())
    return false;
  const Vec3 a = state_.point(before);
  const Vec3 d = state_.point(way.kept) - a;
  const PieceId curve = state_.tags.support[way.gone].piece();
  const double most = state_.options.feature_deviation * state_.wanted_edge(way.gone);
  for (const double share : {0.25, 0.5, 0.75}) {
    const Vec3 place = a + share * d;
    if (length(state_.network.project(curve, place) - place) > most) return false;
  }
  const Vec3 off = cross(state_.point(way.gone) - a, d);
  return dot(off, off) <= most * most * dot(d, d);
}

}  // namespace quarry
