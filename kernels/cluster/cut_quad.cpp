#include "kernels/cluster/cut_quad.hpp"

#include <algorithm>
#include <array>

#include "engine/geometry/predicates.hpp"
#include "kernels/quality/element.hpp"

namespace quarry {
namespace {

// What surrounds one side of the quad.
struct Rim {
  VertexId origin;
  SideId across;
  bool constrained;
  bool names_vertex;  // the side from which the turn around its origin starts
};

QuadCut cut_from(const Mesh& mesh, FaceId f, int from) {
  const auto p = [&](int i) { return mesh.point(mesh.corner(f, (from + i) & 3)); };
  if (!(orient2d(p(0), p(1), p(2)) > 0 && orient2d(p(0), p(2), p(3)) > 0)) return {from, -1};
  // What turns left is valid, however rounding measures it.
  return {from,
          std::max(0.0, std::min(scaled_jacobian(p(0), p(1), p(2)), scaled_jacobian(p(0), p(2), p(3))))};
}

void write_side(Mesh& mesh, ConstraintTags& tags, SideId s, const Rim& rim) {
  mesh.set_corner(s, rim.origin);
  mesh.set_neighbour(s, rim.across);
  if (rim.across.valid()) mesh.set_neighbour(rim.across, s);
  tags.set_constrained(s, rim.constrained);
}

}  // namespace

QuadCut best_cut(const Mesh& mesh, FaceId f) {
  const QuadCut first = cut_from(mesh, f, 0);
  const QuadCut second = cut_from(mesh, f, 1);
  return first.quality >= second.quality ? first : second;
}

void cut_quad(Mesh& mesh, FaceId f, int from) {
  ConstraintTags tags = ConstraintTags::of(mesh);
  std::array<Rim, 4> rim;
  for (int i = 0; i < 4; ++i) {
    const SideId s(f, (from + i) & 3);
    rim[static_cast<std::size_t>(i)] = {mesh.origin(s), mesh.neighbour(s), tags.constrained(s),
                                        mesh.side_of(mesh.origin(s)) == s};
  }
  const FaceId g = mesh.grow_faces(1);
  mesh.set_corner(SideId(f, 3), VertexId());
  mesh.set_neighbour(SideId(f, 3), SideId());
  tags.sides[f] = 0;
  tags.sides[g] = 0;
  const std::array<SideId, 4> place = {SideId(f, 0), SideId(f, 1), SideId(g, 1), SideId(g, 2)};
  for (std::size_t i = 0; i < 4; ++i) {
    write_side(mesh, tags, place[i], rim[i]);
    if (rim[i].names_vertex) mesh.set_side_of(rim[i].origin, place[i]);
  }
  mesh.set_corner(SideId(f, 2), rim[2].origin);
  mesh.set_corner(SideId(g, 0), rim[0].origin);
  mesh.set_neighbour(SideId(f, 2), SideId(g, 0));
  mesh.set_neighbour(SideId(g, 0), SideId(f, 2));
}

}  // namespace quarry
