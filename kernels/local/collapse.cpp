#include "kernels/local/collapse.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <vector>

#include "kernels/local/star.hpp"

namespace quarry {
namespace {

// Faces at v, counted up to a limit.
int count_faces(const Mesh& mesh, VertexId v, int limit) {
  int count = 0;
  const SideId first = mesh.side_of(v);
  for (SideId s = first; s.valid() && count < limit;) {
    ++count;
    s = mesh.turn_left(s);
    if (s == first) break;
  }
  return count;
}

// The sides of an edge, from either end: one or two are valid.
std::array<SideId, 2> sides_of_edge(const Mesh& mesh, VertexId a, VertexId b) {
  return {mesh.find_side(a, b), mesh.find_side(b, a)};
}

bool joined(const Mesh& mesh, VertexId a, VertexId b) {
  return mesh.find_side(a, b).valid() || mesh.find_side(b, a).valid();
}

// Takes the face of s = x -> y with apex c out: what lies across its other two sides is joined.
void close_face(MeshEditor& editor, ConstraintTags tags, SideId s) {
  const Mesh& mesh = editor.mesh();
  const SideId after = mesh.next(s);       // y -> c
  const SideId before = mesh.previous(s);  // c -> x
  const VertexId apex = mesh.origin(before);
  const SideId across_after = mesh.neighbour(after);
  const SideId across_before = mesh.neighbour(before);
  const bool constrained = tags.constrained(after) || tags.constrained(before);
  if (editor.side_of(apex) == before) editor.set_side_of(apex, across_after);
  if (across_after.valid())
    editor.join(across_after, across_before);
  else
    editor.join(across_before, SideId());
  for (const SideId side : {across_after, across_before})
    if (side.valid() && constrained) tags.set_constrained(side, true);
  editor.delete_face(s.face());
}

// The most clockwise side at v, from any of its sides on.
SideId most_clockwise(const Mesh& mesh, SideId from) {
  SideId s = from;
  for (;;) {
    const SideId right = mesh.turn_right(s);
    if (!right.valid() || right == from) return right.valid() ? from : s;
    s = right;
  }
}

}  // namespace

bool can_collapse(const Mesh& mesh, VertexId a, VertexId b) {
  const auto sides = sides_of_edge(mesh, a, b);
  std::array<VertexId, 2> apexes;
  int faces = 0;
  for (const SideId s : sides) {
    if (!s.valid()) continue;
    const VertexId apex = mesh.origin(mesh.previous(s));
    const int least = mesh.on_boundary(apex) ? 2 : 4;
    if (count_faces(mesh, apex, least) < least) return false;
    apexes[static_cast<std::size_t>(faces++)] = apex;
  }
  if (faces == 0 || (faces == 2 && apexes[0] == apexes[1])) return false;
  if (faces == 2 && mesh.on_boundary(a) && mesh.on_boundary(b)) return false;
  // A face between two boundary sides of the edge's ends would leave nothing to join.
  for (const SideId s : sides)
    if (s.valid() && !mesh.neighbour(mesh.next(s)).valid() && !mesh.neighbour(mesh.previous(s)).valid())
      return false;
  bool apart = true;
  for_each_link_vertex(mesh, a, [&](VertexId v) {
    if (v != b && v != apexes[0] && v != apexes[1] && joined(mesh, v, b)) apart = false;
  });
  return apart;
}

void claim_collapse(const Mesh& mesh, VertexId a, VertexId b, Cavity& cavity) {
  claim_star(mesh, a, cavity);
  claim_star(mesh, b, cavity);
}

void collapse_edge(MeshEditor& editor, ConstraintTags tags, VertexId a, VertexId b) {
  const Mesh& mesh = editor.mesh();
  const auto sides = sides_of_edge(mesh, a, b);
  // A side at b that outlives the two faces: every face around a that has not b, or across the dying ones.
  std::array<FaceId, 2> dying;
  for (std::size_t i = 0; i < 2; ++i) dying[i] = sides[i].valid() ? sides[i].face() : FaceId();
  std::vector<FaceId> moved;
  for_each_side_around(mesh, a, [&](SideId s) {
    if (s.face() != dying[0] && s.face() != dying[1]) moved.push_back(s.face());
  });
  SideId kept;
  for_each_side_around(mesh, b, [&](SideId s) {
    if (!kept.valid() && s.face() != dying[0] && s.face() != dying[1]) kept = s;
  });
  for (const SideId s : sides)
    if (s.valid()) close_face(editor, tags, s);
  for (const FaceId f : moved) {
    std::array<VertexId, 3> corners;
    for (int k = 0; k < 3; ++k) {
      const VertexId v = mesh.corner(f, k);
      corners[static_cast<std::size_t>(k)] = v == a ? b : v;
      if (v == a && !kept.valid()) kept = SideId(f, k);
    }
    editor.set_triangle(f, corners[0], corners[1], corners[2]);
  }
  assert(kept.valid());
  editor.set_side_of(b, most_clockwise(mesh, kept));
  editor.delete_vertex(a);
}

}  // namespace quarry
