#include "kernels/cleanup/local_operators.hpp"

namespace quarry {
namespace {

struct Corners {
  VertexId gone, left, kept, right;  // counter-clockwise around the quad
};

Corners corners_from(const Mesh& mesh, SideId s) {
  return {mesh.origin(s), mesh.target(s), mesh.target(mesh.next(s)), mesh.origin(mesh.previous(s))};
}

int gain_of(const LocalView& view, const Corners& c) {
  const int merged = view.faces(c.gone) + view.faces(c.kept) - 2;
  return view.cost(c.gone, valence_energy(view.faces(c.gone), view.ideal(c.gone))) +
         view.gain(c.kept, merged - view.faces(c.kept)) + view.gain(c.left, -1) + view.gain(c.right, -1);
}

// The faces around the corner that goes must make faces with the kept one in its place, and no edge that is
// there already.
bool can_merge(const LocalView& view, const Corners& c, FaceId closed) {
  const Mesh& mesh = view.mesh;
  bool fits = true;
  for_each_side_around(mesh, c.gone, [&](SideId s) {
    if (!fits || s.face() == closed) return;
    for (SideId t = mesh.next(s); t != s; t = mesh.next(t)) fits = fits && mesh.origin(t) != c.kept;
    const VertexId joined = mesh.target(s);
    if (joined != c.left && joined != c.right) fits = fits && !view.joined(joined, c.kept);
  });
  return fits;
}

}  // namespace

bool FaceCollapse::wants(const LocalView& view, VertexId v) { return view.excess(v) != 0; }

bool FaceCollapse::find(const LocalView& view, VertexId v, std::uint32_t skip, Plan& plan) {
  const Mesh& mesh = view.mesh;
  BestOf<Plan> best(skip);
  const auto offer = [&](SideId s) {
    // Of two free corners the one with fewer faces goes.
    const SideId opposite = mesh.next(mesh.next(s));
    Corners c = corners_from(mesh, s);
    if (!view.movable(c.gone) || (view.movable(c.kept) && view.faces(c.kept) < view.faces(c.gone))) {
      s = opposite;
      c = corners_from(mesh, s);
    }
    if (!view.movable(c.gone)) return;
    const int gain = gain_of(view, c);
    const int merged = view.faces(c.gone) + view.faces(c.kept) - 2;
    if (gain <= 0 || (view.inside(c.kept) && merged < 3) || !view.can_lose(c.left) || !view.can_lose(c.right))
      return;
    if (can_merge(view, c, s.face())) best.offer(gain, {s});
  };
  for_each_side_around(mesh, v, [&](SideId s) {
    if (!view.quad(s.face())) return;
    offer(s);
    offer(mesh.next(s));
  });
  return best.take(plan);
}

void FaceCollapse::build(const LocalView& view, const Plan& plan, VertexId /*fresh_vertex*/,
                         LocalChange& change) {
  const Mesh& mesh = view.mesh;
  const Corners c = corners_from(mesh, plan.side);
  for_each_side_around(mesh, c.gone, [&](SideId s) {
    change.old.push_back(s.face());
    if (s.face() != plan.side.face())
      change.fresh.push_back(LocalChange::exchanged(mesh, s.face(), c.gone, c.kept));
  });
  if (!view.movable(c.kept)) return;
  change.placed = c.kept;
  change.mean_of = {c.gone, c.kept};
}

}  // namespace quarry
