#include "kernels/cluster/patch.hpp"

#include <algorithm>

namespace quarry {

bool Patch::contains(FaceId f) const {
  const auto end = faces_.begin() + face_count_;
  return std::find(faces_.begin(), end, f) != end;
}

bool Patch::gather(const Mesh& mesh, ConstraintTags tags, std::span<const FaceId> faces) {
  face_count_ = static_cast<int>(faces.size());
  std::copy(faces.begin(), faces.end(), faces_.begin());
  int expected = 2;
  for (const FaceId f : faces) expected += mesh.corner_count(f) - 2;
  if (expected > kMostPolygonCorners) return false;

  const auto inside = [&](SideId s) {
    return mesh.neighbour(s).valid() && contains(mesh.neighbour(s).face());
  };
  SideId first;
  for (int k = 0; k < mesh.corner_count(faces[0]) && !first.valid(); ++k)
    if (!inside(SideId(faces[0], k))) first = SideId(faces[0], k);
  if (!first.valid()) return false;

  corner_count_ = 0;
  SideId s = first;
  do {
    if (corner_count_ == expected) return false;
    const VertexId v = mesh.origin(s);
    for (int i = 0; i < corner_count_; ++i)
      if (vertex(i) == v) return false;
    rim_[static_cast<std::size_t>(corner_count_)] = {v, mesh.neighbour(s), tags.constrained(s),
                                                     contains(mesh.side_of(v).face())};
    // Turn at the end of the side until the next one that leads out; the faces passed meet there.
    int passed = 1;
    s = mesh.next(s);
    for (; inside(s); s = mesh.next(mesh.neighbour(s)), ++passed)
      if (tags.constrained(s)) return false;
    ++corner_count_;
    faces_at_[static_cast<std::size_t>(corner_count_ % expected)] = passed;
  } while (s != first);
  // Fewer corners: a vertex inside, or sides shared twice.
  return corner_count_ == expected;
}

void Patch::apply(MeshEditor& editor, ConstraintTags tags, const Dissection& dissection, NewIds ids) const {
  std::array<SideId, kMostPolygonCorners * kMostPolygonCorners> seen;
  const auto slot = [](int from, int to) {
    return static_cast<std::size_t>(from * kMostPolygonCorners + to);
  };
  for (int i = 0; i < dissection.face_count; ++i) {
    const FaceId f = i < face_count_ ? faces_[static_cast<std::size_t>(i)] : ids.take_face();
    const auto& corner = dissection.faces[static_cast<std::size_t>(i)];
    const int count = corner[3] == Dissection::kNone ? 3 : 4;
    if (count == 3)
      editor.set_triangle(f, vertex(corner[0]), vertex(corner[1]), vertex(corner[2]));
    else
      editor.set_quad(f, vertex(corner[0]), vertex(corner[1]), vertex(corner[2]), vertex(corner[3]));
    std::uint8_t bits = 0;
    for (int k = 0; k < count; ++k) {
      const int from = corner[static_cast<std::size_t>(k)];
      const int to = corner[static_cast<std::size_t>((k + 1) % count)];
      seen[slot(from, to)] = SideId(f, k);
      if (to == (from + 1) % corner_count_ && rim_[static_cast<std::size_t>(from)].constrained)
        bits = static_cast<std::uint8_t>(bits | (1U << k));
    }
    editor.set(tags.sides, f, bits);
  }
  for (int i = dissection.face_count; i < face_count_; ++i)
    editor.delete_face(faces_[static_cast<std::size_t>(i)]);

  for (int from = 0; from < corner_count_; ++from) {
    const int next = (from + 1) % corner_count_;
    const RimSide& rim = rim_[static_cast<std::size_t>(from)];
    const SideId s = seen[slot(from, next)];
    editor.join(s, rim.across);
    // The rim side at a corner is the most clockwise of the patch there.
    if (rim.names_vertex) editor.set_side_of(rim.origin, s);
    for (int to = from + 2; to < corner_count_; ++to)
      if (seen[slot(from, to)].valid()) editor.join(seen[slot(from, to)], seen[slot(to, from)]);
  }
}

}  // namespace quarry
