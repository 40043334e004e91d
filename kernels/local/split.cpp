#include "kernels/local/split.hpp"

#include <algorithm>
#include <limits>

#include "engine/geometry/predicates.hpp"
#include "engine/mesh/point_of.hpp"
#include "kernels/quality/element.hpp"
#include "kernels/quality/space_face.hpp"

namespace quarry {
namespace {

// A side that is about to be rewritten: what lies across and whether it is constrained.
struct OldSide {
  SideId side, across;
  bool constrained;
};

OldSide remember(const Mesh& mesh, const ConstraintTags& tags, SideId s) {
  return {s, mesh.neighbour(s), tags.constrained(s)};
}

// The new side takes the place of the old one, also as the first side of its origin.
void replace_side(MeshEditor& editor, ConstraintTags tags, const OldSide& old, SideId now) {
  editor.join(now, old.across);
  if (old.constrained) tags.set_constrained(now, true);
  const VertexId v = editor.mesh().origin(now);
  if (editor.side_of(v) == old.side) editor.set_side_of(v, now);
}

// Halves the face of s = a -> b with apex c: the face keeps (a, m, c), the new one is (m, b, c).
void halve_face(MeshEditor& editor, ConstraintTags tags, SideId s, VertexId m, FaceId second) {
  const Mesh& mesh = editor.mesh();
  const FaceId first = s.face();
  const VertexId a = mesh.origin(s);
  const VertexId b = mesh.target(s);
  const VertexId c = mesh.origin(mesh.previous(s));
  const OldSide edge = remember(mesh, tags, s);
  const OldSide bc = remember(mesh, tags, mesh.next(s));
  const OldSide ca = remember(mesh, tags, mesh.previous(s));
  const bool a_starts_here = editor.side_of(a) == s;
  editor.set_triangle(first, a, m, c);
  editor.set_triangle(second, m, b, c);
  editor.set(tags.sides, first, std::uint8_t{0});
  editor.set(tags.sides, second, std::uint8_t{0});
  replace_side(editor, tags, bc, SideId(second, 1));
  replace_side(editor, tags, ca, SideId(first, 2));
  if (a_starts_here) editor.set_side_of(a, SideId(first, 0));
  if (edge.constrained) {
    tags.set_constrained(SideId(first, 0), true);
    tags.set_constrained(SideId(second, 0), true);
  }
  editor.join(SideId(first, 1), SideId(second, 2));
}

}  // namespace

bool can_split_edge(const Mesh& mesh, SideId s, Vec2 p) {
  const auto halves_turn_left = [&](SideId side) {
    const Vec2 a = mesh.point(mesh.origin(side));
    const Vec2 b = mesh.point(mesh.target(side));
    const Vec2 c = mesh.point(mesh.origin(mesh.previous(side)));
    return orient2d(a, p, c) > 0 && orient2d(p, b, c) > 0;
  };
  const SideId t = mesh.neighbour(s);
  return halves_turn_left(s) && (!t.valid() || halves_turn_left(t));
}

namespace {

// Calls visit(a, b, c) with the corners of each triangle that splitting the edge of s at p would make.
template <class Point>
void for_each_part(const Mesh& mesh, SideId s, Point p, const auto& visit) {
  const auto point = [&](VertexId v) { return point_of<Point>(mesh, v); };
  for (const SideId side : {s, mesh.neighbour(s)}) {
    if (!side.valid()) continue;
    const Point c = point(mesh.origin(mesh.previous(side)));
    visit(point(mesh.origin(side)), p, c);
    visit(p, point(mesh.target(side)), c);
  }
}

template <class Point>
double worst_part(const Mesh& mesh, SideId s, Point p) {
  double worst = 1;
  for_each_part(mesh, s, p, [&](Point a, Point b, Point c) { worst = std::min(worst, lo_measure(a, b, c)); });
  return worst;
}

}  // namespace

double worst_of_edge_split(const Mesh& mesh, SideId s, Vec2 p) { return worst_part(mesh, s, p); }
double worst_of_edge_split(const Mesh& mesh, SideId s, Vec3 p) { return worst_part(mesh, s, p); }

double lowest_of_edge_split(const Mesh& mesh, SideId s, Vec2 p) {
  double lowest = std::numeric_limits<double>::infinity();
  for_each_part(mesh, s, p, [&](Vec2 a, Vec2 b, Vec2 c) {
    const double longest = std::max({distance(a, b), distance(b, c), distance(c, a)});
    lowest = std::min(lowest, doubled_area(a, b, c) / longest);
  });
  return lowest;
}

double worst_of_face_split(const Mesh& mesh, FaceId f, Vec2 p) {
  const Vec2 a = mesh.point(mesh.corner(f, 0));
  const Vec2 b = mesh.point(mesh.corner(f, 1));
  const Vec2 c = mesh.point(mesh.corner(f, 2));
  return std::min({lo_measure(a, b, p), lo_measure(b, c, p), lo_measure(c, a, p)});
}

void claim_split_edge(const Mesh& mesh, SideId s, Cavity& cavity) {
  cavity.claim(mesh.origin(s));
  cavity.claim(mesh.target(s));
  cavity.claim(mesh.origin(mesh.previous(s)));
  const SideId t = mesh.neighbour(s);
  if (t.valid()) cavity.claim(mesh.origin(mesh.previous(t)));
  cavity.will_create(1, t.valid() ? 2 : 1);
}

namespace {

// Joins the vertex m, which is in place, to all corners of the faces at the edge.
void split_edge_at(MeshEditor& editor, ConstraintTags tags, SideId s, VertexId m, NewIds ids) {
  const SideId t = editor.mesh().neighbour(s);
  const FaceId f2 = ids.take_face();
  if (!t.valid()) {
    halve_face(editor, tags, s, m, f2);
    editor.join(SideId(s.face(), 0), SideId());
    editor.join(SideId(f2, 0), SideId());
  } else {
    const FaceId g2 = ids.take_face();
    halve_face(editor, tags, s, m, f2);
    halve_face(editor, tags, t, m, g2);
    editor.join(SideId(s.face(), 0), SideId(g2, 0));
    editor.join(SideId(f2, 0), SideId(t.face(), 0));
  }
  editor.set_side_of(m, SideId(f2, 0));
}

}  // namespace

VertexId split_edge(MeshEditor& editor, ConstraintTags tags, SideId s, Vec2 p, Support support, NewIds ids) {
  const VertexId m = ids.take_vertex();
  editor.set_point(m, p);
  editor.set(tags.support, m, support);
  split_edge_at(editor, tags, s, m, ids);
  return m;
}

VertexId split_edge(MeshEditor& editor, ConstraintTags tags, SideId s, Vec3 p, Support support, NewIds ids) {
  const VertexId m = ids.take_vertex();
  editor.set_point3(m, p);
  editor.set(tags.support, m, support);
  split_edge_at(editor, tags, s, m, ids);
  return m;
}

bool can_split_face(const Mesh& mesh, FaceId f, Vec2 p) {
  for (int i = 0; i < 3; ++i)
    if (!(orient2d(mesh.point(mesh.corner(f, i)), mesh.point(mesh.corner(f, (i + 1) % 3)), p) > 0))
      return false;
  return true;
}

void claim_split_face(const Mesh& mesh, FaceId f, Cavity& cavity) {
  for (int i = 0; i < 3; ++i) cavity.claim(mesh.corner(f, i));
  cavity.will_create(1, 2);
}

VertexId split_face(MeshEditor& editor, ConstraintTags tags, FaceId f, Vec2 p, Support support, NewIds ids) {
  const Mesh& mesh = editor.mesh();
  const VertexId m = ids.take_vertex();
  const FaceId faces[3] = {f, ids.take_face(), ids.take_face()};
  editor.set_point(m, p);
  editor.set(tags.support, m, support);
  OldSide old[3];
  VertexId corners[3];
  for (int i = 0; i < 3; ++i) {
    old[i] = remember(mesh, tags, SideId(f, i));
    corners[i] = mesh.corner(f, i);
  }
  for (int i = 0; i < 3; ++i) {
    editor.set_triangle(faces[i], corners[i], corners[(i + 1) % 3], m);
    editor.set(tags.sides, faces[i], std::uint8_t{0});
  }
  // Side 0 of face 0 keeps its number; sides 1 and 2 move to the new faces.
  for (int i = 0; i < 3; ++i) replace_side(editor, tags, old[i], SideId(faces[i], 0));
  for (int i = 0; i < 3; ++i) editor.join(SideId(faces[i], 1), SideId(faces[(i + 1) % 3], 2));
  editor.set_side_of(m, SideId(faces[0], 2));
  return m;
}

}  // namespace quarry
