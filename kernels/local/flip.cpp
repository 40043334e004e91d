#include "kernels/local/flip.hpp"

#include <cassert>

#include "engine/geometry/predicates.hpp"

namespace quarry {

EdgeDiamond diamond_of(const Mesh& mesh, SideId s) {
  const SideId t = mesh.neighbour(s);
  return {mesh.origin(s), mesh.origin(t), mesh.origin(mesh.previous(s)), mesh.origin(mesh.previous(t))};
}

bool can_flip(const Mesh& mesh, SideId s) {
  const auto [a, b, c, d] = diamond_of(mesh, s);
  const Vec2 pa = mesh.point(a), pb = mesh.point(b), pc = mesh.point(c), pd = mesh.point(d);
  return orient2d(pc, pa, pd) > 0 && orient2d(pd, pb, pc) > 0;
}

void claim_flip(const Mesh& mesh, SideId s, Cavity& cavity) {
  const auto [a, b, c, d] = diamond_of(mesh, s);
  for (const VertexId v : {a, b, c, d}) cavity.claim(v);
}

SideId flip_edge(MeshEditor& editor, ConstraintTags tags, SideId s) {
  const Mesh& mesh = editor.mesh();
  const SideId t = mesh.neighbour(s);
  assert(t.valid() && !tags.constrained(s));
  const auto [a, b, c, d] = diamond_of(mesh, s);
  const FaceId f = s.face();
  const FaceId g = t.face();

  // The four outer sides, old and new: c -> a, a -> d, d -> b, b -> c.
  const SideId old_sides[4] = {mesh.previous(s), mesh.next(t), mesh.previous(t), mesh.next(s)};
  const SideId new_sides[4] = {SideId(f, 0), SideId(f, 1), SideId(g, 0), SideId(g, 1)};
  const VertexId origins[4] = {c, a, d, b};
  SideId across[4];
  bool constrained[4];
  bool first_of_origin[4];
  for (int i = 0; i < 4; ++i) {
    across[i] = mesh.neighbour(old_sides[i]);
    constrained[i] = tags.constrained(old_sides[i]);
    const SideId first = editor.side_of(origins[i]);
    first_of_origin[i] = first == old_sides[i] || first == s || first == t;
  }
  editor.set_triangle(f, c, a, d);
  editor.set_triangle(g, d, b, c);
  editor.set(tags.sides, f, std::uint8_t{0});
  editor.set(tags.sides, g, std::uint8_t{0});
  for (int i = 0; i < 4; ++i) {
    editor.join(new_sides[i], across[i]);
    if (constrained[i]) tags.set_constrained(new_sides[i], true);
    if (first_of_origin[i]) editor.set_side_of(origins[i], new_sides[i]);
  }
  editor.join(SideId(f, 2), SideId(g, 2));
  return SideId(g, 2);
}

}  // namespace quarry
