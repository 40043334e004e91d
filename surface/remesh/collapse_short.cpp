#include "surface/remesh/collapse_short.hpp"

#include <algorithm>
#include <array>

#include "kernels/local/collapse.hpp"
#include "kernels/local/star.hpp"

namespace quarry {
namespace {

// Triangles may become as low as this for the sake of a collapse: flips and moves mend them.
constexpr double kLowestAfter = 0.2;

class CollapseShort {
 public:
  using Item = MeshEdge;
  struct Plan {
    VertexId gone, kept;
  };

  explicit CollapseShort(const RemeshState& state) : state_(state), guard_(state.guard()) {}

  [[nodiscard]] bool wanted(SideId s) const {
    const Mesh& mesh = state_.mesh;
    const VertexId a = mesh.origin(s);
    const VertexId b = mesh.target(s);
    return too_short(a, b) && (may_go(s, a) || may_go(s, b));
  }

  bool propose(const Mesh& mesh, Item edge, Cavity& cavity, Plan& plan) const {
    const SideId s = state_.side_of(edge);
    if (!s.valid() || !wanted(s)) return false;
    // Of both ways that which leaves the better star.
    double best = -1;
    for (const Plan way : {Plan{edge.a, edge.b}, Plan{edge.b, edge.a}}) {
      const double worst = worst_after(s, way);
      if (worst <= best) continue;
      best = worst;
      plan = way;
    }
    if (best < 0) return false;
    claim_collapse(mesh, plan.gone, plan.kept, cavity);
    return true;
  }

  void apply(MeshEditor& editor, Item /*edge*/, const Plan& plan, NewIds /*ids*/,
             FollowUps<Item>& more) const {
    collapse_edge(editor, state_.tags, plan.gone, plan.kept);
    // What was too long to become longer may be so no more.
    for_each_link_vertex(editor.mesh(), plan.kept, [&](VertexId v) {
      if (too_short(plan.kept, v)) more.push_back({plan.kept, v});
    });
  }

 private:
  [[nodiscard]] bool too_short(VertexId a, VertexId b) const {
    return state_.relative_length(a, b) < state_.options.shortest;
  }
  // A vertex on a feature goes along that feature only.
  [[nodiscard]] bool may_go(SideId s, VertexId v) const {
    const Support support = state_.tags.support[v];
    return support.is_free() || (support.slides() && state_.tags.constrained(s));
  }

  // The measure of the worst triangle at the vertex that stays; -1 if the collapse may not be.
  [[nodiscard]] double worst_after(SideId s, Plan way) const {
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
    for_each_link_vertex(mesh, way.gone, [&](VertexId v) {
      fits = fits && state_.relative_length(way.kept, v) <= state_.options.longest;
    });
    return fits && (after >= kLowestAfter || after > before) ? after : -1;
  }

  // The feature from the vertex before the one that goes to the one that stays, nearly straight; and not so
  // short a closed one that it would fold.
  [[nodiscard]] bool keeps_feature(Plan way) const {
    const Mesh& mesh = state_.mesh;
    VertexId before;
    for_each_constrained_neighbour(mesh, state_.tags, way.gone, [&](VertexId v) {
      if (v != way.kept) before = v;
    });
    if (!before.valid() || mesh.find_side(before, way.kept).valid() ||
        mesh.find_side(way.kept, before).valid())
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

  const RemeshState& state_;
  TriangleGuard guard_;
};

}  // namespace

std::uint64_t collapse_short_edges(RemeshState& state, const Progress& progress) {
  const CollapseShort operation(state);
  return run_pass(state.mesh, operation,
                  edges_where(state.mesh, [&](SideId s) { return operation.wanted(s); }), PassOptions(),
                  progress)
      .won;
}

}  // namespace quarry
