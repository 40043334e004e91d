#include "kernels/cleanup/local_operators.hpp"

namespace quarry {

bool DoubletRemoval::wants(const LocalView& view, VertexId v) {
  return view.faces(v) == 2 && view.movable(v);
}

bool DoubletRemoval::find(const LocalView& view, VertexId v, std::uint32_t skip, Plan& plan) {
  if (skip > 0 || !wants(view, v)) return false;
  const Mesh& mesh = view.mesh;
  const SideId s = mesh.side_of(v);
  const SideId t = mesh.turn_left(s);
  if (!view.quad(s.face()) || !view.quad(t.face())) return false;
  // The corners across: equal if the two faces are a closed bubble.
  if (mesh.target(mesh.next(s)) == mesh.target(mesh.next(t))) return false;
  plan.side = s;
  return true;
}

void DoubletRemoval::build(const LocalView& view, const Plan& plan, VertexId /*fresh_vertex*/,
                           LocalChange& change) {
  const Mesh& mesh = view.mesh;
  const SideId s = plan.side;
  const SideId t = mesh.turn_left(s);
  change.old = {s.face(), t.face()};
  change.fresh.push_back(
      {mesh.target(s), mesh.target(mesh.next(s)), mesh.target(t), mesh.target(mesh.next(t))});
}

}  // namespace quarry
