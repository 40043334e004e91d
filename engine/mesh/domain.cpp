#include "engine/mesh/domain.hpp"

#include <utility>

#include "engine/mesh/build.hpp"

namespace quarry {
namespace {

bool on_outline(const Mesh& mesh, ConstraintTags tags, const PieceFinder& finder, const NodedLines& lines,
                SideId s) {
  if (!tags.constrained(s)) return false;
  const PieceId piece = finder.under_edge(tags.support[mesh.origin(s)], tags.support[mesh.target(s)]);
  return lines.pieces[piece].kind == PieceKindOf::kOutline;
}

template <class Visit>
void for_each_side_of(const Mesh& mesh, FaceId f, Visit&& visit) {
  for (int k = 0; k < mesh.corner_count(f); ++k) visit(SideId(f, k));
}

}  // namespace

std::size_t remove_outside(Mesh& mesh, ConstraintTags tags, const NodedLines& lines) {
  const PieceFinder finder(lines);
  enum Place : std::uint8_t { kUnknown, kOutside, kInside };
  std::vector<Place> place(mesh.face_slots(), kUnknown);
  std::vector<FaceId> todo;
  const auto reach = [&](FaceId f, Place there) {
    if (place[f.value()] != kUnknown) return;
    place[f.value()] = there;
    todo.push_back(f);
  };
  for (const FaceId f : mesh.faces()) {
    if (!mesh.alive(f)) continue;
    for_each_side_of(mesh, f, [&](SideId s) {
      if (!mesh.neighbour(s).valid()) reach(f, on_outline(mesh, tags, finder, lines, s) ? kInside : kOutside);
    });
  }
  while (!todo.empty()) {
    const FaceId f = todo.back();
    todo.pop_back();
    for_each_side_of(mesh, f, [&](SideId s) {
      const SideId t = mesh.neighbour(s);
      if (!t.valid() || place[t.face().value()] != kUnknown) return;
      const bool same = !on_outline(mesh, tags, finder, lines, s);
      reach(t.face(), same == (place[f.value()] == kInside) ? kInside : kOutside);
    });
  }

  std::size_t deleted = 0;
  for (const FaceId f : mesh.faces()) {
    if (!mesh.alive(f) || place[f.value()] == kInside) continue;
    for_each_side_of(mesh, f, [&](SideId s) {
      if (const SideId t = mesh.neighbour(s); t.valid()) mesh.set_neighbour(t, SideId());
    });
    mesh.delete_face(f);
    ++deleted;
  }
  if (deleted > 0) rebuild_sides_of_vertices(mesh);
  return deleted;
}

std::int32_t label_regions(Mesh& mesh, ConstraintTags tags) {
  auto region = mesh.find_tag<FaceId, std::int32_t>("region");
  if (!region.valid()) region = mesh.add_tag<FaceId, std::int32_t>("region", -1);
  for (auto& number : region.values()) number = -1;
  std::int32_t count = 0;
  std::vector<FaceId> todo;
  for (const FaceId seed : mesh.faces()) {
    if (!mesh.alive(seed) || region[seed] >= 0) continue;
    region[seed] = count;
    todo.push_back(seed);
    while (!todo.empty()) {
      const FaceId f = todo.back();
      todo.pop_back();
      for_each_side_of(mesh, f, [&](SideId s) {
        const SideId t = mesh.neighbour(s);
        if (!t.valid() || tags.constrained(s) || region[t.face()] >= 0) return;
        region[t.face()] = count;
        todo.push_back(t.face());
      });
    }
    ++count;
  }
  return count;
}

void extract_edges(Mesh& mesh, ConstraintTags tags, const NodedLines& lines) {
  const PieceFinder finder(lines);
  auto constraint = mesh.add_tag<EdgeId, std::int32_t>("constraint", -1);
  auto kind = mesh.add_tag<EdgeId, std::int32_t>("kind", kKindInterior);
  const auto add = [&](SideId s, std::int32_t line) {
    const EdgeId e = mesh.add_edge(mesh.origin(s), mesh.target(s));
    constraint[e] = line;
    kind[e] = mesh.neighbour(s).valid() ? kKindInterior : kKindBoundary;
  };
  for (const FaceId f : mesh.faces()) {
    if (!mesh.alive(f)) continue;
    for_each_side_of(mesh, f, [&](SideId s) {
      const SideId t = mesh.neighbour(s);
      if (t.valid() && (t < s || !tags.constrained(s))) return;
      if (!tags.constrained(s)) {
        add(s, -1);
        return;
      }
      const PieceId piece = finder.under_edge(tags.support[mesh.origin(s)], tags.support[mesh.target(s)]);
      const std::uint32_t begin = lines.line_begin[piece.value()];
      const std::uint32_t end = lines.line_begin[piece.value() + 1];
      for (std::uint32_t i = begin; i < end; ++i)
        add(s, static_cast<std::int32_t>(lines.line_numbers[i].value()));
      if (begin == end) add(s, -1);
    });
  }
}

}  // namespace quarry
