#include "surface/remesh/split_long.hpp"

#include <array>

#include "kernels/local/split.hpp"

namespace quarry {
namespace {

class SplitLong {
 public:
  using Item = MeshEdge;
  struct Plan {};

  explicit SplitLong(const RemeshState& state) : state_(state), guard_(state.guard()) {}

  // Too long, and the longest of one of its triangles, of the edges that may be split; of equals that with
  // the smaller ends.
  [[nodiscard]] bool wanted(SideId s) const {
    const Mesh& mesh = state_.mesh;
    if (!(state_.relative_length(mesh.origin(s), mesh.target(s)) > state_.options.longest) || is_kept(s))
      return false;
    const double squared = state_.squared_length(mesh.origin(s), mesh.target(s));
    const auto longest_of = [&](SideId side) {
      for (SideId other = mesh.next(side); other != side; other = mesh.next(other)) {
        if (is_kept(other)) continue;
        const double theirs = state_.squared_length(mesh.origin(other), mesh.target(other));
        if (theirs > squared || (theirs == squared && key(other) < key(side))) return false;
      }
      return true;
    };
    const SideId t = mesh.neighbour(s);
    return longest_of(s) || (t.valid() && longest_of(t));
  }

  bool propose(const Mesh& mesh, Item edge, Cavity& cavity, Plan& /*plan*/) const {
    const SideId s = state_.side_of(edge);
    if (!s.valid() || !wanted(s)) return false;
    claim_split_edge(mesh, s, cavity);
    return true;
  }

  // The place is found here, by the edges alone that win: of the spokes of a wheel one does in each round.
  void apply(MeshEditor& editor, Item edge, const Plan& /*plan*/, NewIds ids,
             FollowUps<Item>& /*more*/) const {
    const SideId s = state_.side_of(edge);
    const Middle middle = middle_of(editor.mesh(), s);
    const SideId t = editor.mesh().neighbour(s);
    // The new faces in the order in which they are taken.
    editor.set(state_.groups, ids.face, state_.groups[s.face()]);
    if (t.valid()) editor.set(state_.groups, FaceId(ids.face.value() + 1), state_.groups[t.face()]);
    const VertexId m = split_edge(editor, state_.tags, s, middle.point, middle.support, ids);
    editor.set(state_.normals, m, middle.normal);
    editor.set(state_.wanted, m, middle.wanted);
  }

 private:
  [[nodiscard]] bool is_kept(SideId s) const {
    if (state_.mesh.neighbour(s).valid()) return false;
    const auto [a, b] = key(s);
    return state_.options.keep_rims ||
           !state_.network.may_halve_outer(state_.tags.support[a], state_.tags.support[b],
                                           0.5 * (state_.point(a) + state_.point(b)));
  }
  [[nodiscard]] std::pair<VertexId, VertexId> key(SideId s) const {
    return std::minmax(state_.mesh.origin(s), state_.mesh.target(s));
  }

  struct Middle {
    Vec3 point, normal;
    double wanted;
    Support support;
  };

  [[nodiscard]] Middle middle_of(const Mesh& mesh, SideId s) const {
    const auto [a, b] = key(s);
    const Vec3 middle = 0.5 * (state_.point(a) + state_.point(b));
    const double wanted = 0.5 * (state_.wanted[a] + state_.wanted[b]);
    if (state_.tags.constrained(s)) {
      const PieceId curve = state_.network.under_edge(state_.tags.support[a], state_.tags.support[b], middle);
      const Vec3 place = curve.valid() ? state_.network.project(curve, middle) : middle;
      return {fits(s, place) ? place : middle, Vec3(), wanted,
              curve.valid() ? Support::on(curve) : Support::fixed()};
    }
    const Vec3 around = state_.normal_of(s.face()) + state_.normal_of(mesh.neighbour(s).face());
    const SurfacePoint foot = state_.model.nearest({middle, around});
    return {fits(s, foot.position) ? foot.position : middle, state_.model.with_normal(foot).up,
            state_.sizes.at(foot), Support()};
  }

  // The parts of each triangle at the edge have areas and face as it does.
  [[nodiscard]] bool fits(SideId s, Vec3 place) const {
    const Mesh& mesh = state_.mesh;
    for (const SideId side : {s, mesh.neighbour(s)}) {
      if (!side.valid()) continue;
      const Vec3 whole = state_.normal_of(side.face());
      const Vec3 apex = state_.point(mesh.origin(mesh.previous(side)));
      for (const Vec3 part : {unit_normal(state_.point(mesh.origin(side)), place, apex),
                              unit_normal(place, state_.point(mesh.target(side)), apex)})
        if (part == Vec3() || !guard_.agrees(part, whole)) return false;
    }
    return true;
  }

  const RemeshState& state_;
  TriangleGuard guard_;
};

}  // namespace

PassReport split_long_edges(RemeshState& state, const Progress& progress) {
  const SplitLong operation(state);
  return run_pass(state.mesh, operation,
                  edges_where(state.mesh, [&](SideId s) { return operation.wanted(s); }), PassOptions(),
                  progress);
}

}  // namespace quarry
