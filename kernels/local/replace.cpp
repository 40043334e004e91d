#include "kernels/local/replace.hpp"

#include <algorithm>
#include <cassert>

namespace quarry {
namespace {

std::uint64_t key_of(const Mesh& mesh, SideId s) { return stamped_key(mesh.origin(s), mesh.target(s)); }

template <class Visit>
void for_each_side_of(const Mesh& mesh, FaceId f, Visit&& visit) {
  const int count = mesh.corner_count(f);
  for (int k = 0; k < count; ++k) visit(SideId(f, k));
}

}  // namespace

std::span<const FaceId> FaceReplacer::replace(MeshEditor& editor, ConstraintTags tags,
                                              std::span<const FaceId> old, std::span<const FaceCorners> fresh,
                                              NewIds& ids) {
  // In this order, since `old` may be what the last call returned.
  replaced_.assign(old.begin(), old.end());
  const std::size_t kept = std::min(old.size(), fresh.size());
  slots_.assign(replaced_.begin(), replaced_.begin() + static_cast<std::ptrdiff_t>(kept));
  while (slots_.size() < fresh.size()) slots_.push_back(ids.take_face());
  commit(editor, tags, replaced_, fresh, slots_);
  return slots_;
}

void FaceReplacer::undo(MeshEditor& editor, ConstraintTags tags, std::span<const FaceCorners> saved) {
  assert(saved.size() == replaced_.size());
  commit(editor, tags, slots_, saved, replaced_);
}

void FaceReplacer::commit(MeshEditor& editor, ConstraintTags tags, std::span<const FaceId> old,
                          std::span<const FaceCorners> fresh, std::span<const FaceId> slots) {
  gather(editor, tags, old, fresh.size());
  write(editor, old, fresh, slots);
  join(editor, tags, slots);
  name_sides(editor, slots);
}

void FaceReplacer::gather(const MeshEditor& editor, const ConstraintTags& tags, std::span<const FaceId> old,
                          std::size_t fresh_count) {
  const Mesh& mesh = editor.mesh();
  sides_.clear(4 * (old.size() + fresh_count));
  vertices_.clear(4 * (old.size() + fresh_count));
  met_.clear();
  for (const FaceId f : old) {
    if (!mesh.alive(f)) continue;
    for_each_side_of(mesh, f, [&](SideId s) {
      const auto [side, is_new] = sides_.insert(key_of(mesh, s));
      assert(is_new);
      side.old = s;
      side.across = mesh.neighbour(s);
      side.constrained = tags.constrained(s);
    });
  }
  for (const FaceId f : old) {
    if (!mesh.alive(f)) continue;
    for_each_side_of(mesh, f, [&](SideId s) {
      const VertexId v = mesh.origin(s);
      const auto [vertex, is_new] = vertices_.insert(stamped_key(v));
      if (!is_new) return;
      met_.push_back(v);
      const SideId first = editor.side_of(v);
      const Side* named = sides_.find(key_of(mesh, first));
      vertex.wants_side = named != nullptr && named->old == first;
    });
  }
}

void FaceReplacer::write(MeshEditor& editor, std::span<const FaceId> old, std::span<const FaceCorners> fresh,
                         std::span<const FaceId> slots) {
  // The lists of slots begin alike; what is left of the old ones dies.
  for (std::size_t i = 0; i < fresh.size(); ++i) {
    const FaceId f = slots[i];
    const auto& [a, b, c, d] = fresh[i];
    if (d.valid())
      editor.set_quad(f, a, b, c, d);
    else
      editor.set_triangle(f, a, b, c);
    for_each_side_of(editor.mesh(), f, [&](SideId s) {
      Side& side = sides_.insert(key_of(editor.mesh(), s)).value;
      assert(!side.fresh.valid());
      side.fresh = s;
    });
  }
  for (std::size_t i = fresh.size(); i < old.size(); ++i) editor.delete_face(old[i]);
}

// An old side stays as it is unless its other face was replaced as well.
bool FaceReplacer::on_rim(const Mesh& mesh, SideId fresh, const Side& side) {
  if (!side.old.valid()) return false;
  if (!side.across.valid()) return true;
  const Side* back = sides_.find(stamped_key(mesh.target(fresh), mesh.origin(fresh)));
  return back == nullptr || back->old != side.across;
}

void FaceReplacer::join(MeshEditor& editor, ConstraintTags tags, std::span<const FaceId> slots) {
  const Mesh& mesh = editor.mesh();
  for (const FaceId f : slots) {
    std::uint8_t bits = 0;
    for_each_side_of(mesh, f, [&](SideId s) {
      const Side& side = *sides_.find(key_of(mesh, s));
      if (side.constrained) bits = static_cast<std::uint8_t>(bits | (1U << s.index()));
      if (on_rim(mesh, s, side)) {
        editor.join(s, side.across);
        return;
      }
      const Side* back = sides_.find(stamped_key(mesh.target(s), mesh.origin(s)));
      assert(back == nullptr || back->fresh.valid());
      if (back == nullptr)
        editor.join(s, {});  // a part of a boundary side
      else if (s < back->fresh)
        editor.join(s, back->fresh);
    });
    editor.set(tags.sides, f, bits);
  }
}

void FaceReplacer::name_sides(MeshEditor& editor, std::span<const FaceId> slots) {
  const Mesh& mesh = editor.mesh();
  for (const FaceId f : slots) {
    for_each_side_of(mesh, f, [&](SideId s) {
      const VertexId v = mesh.origin(s);
      const auto [vertex, is_new] = vertices_.insert(stamped_key(v));
      if (is_new) {
        met_.push_back(v);
        vertex.wants_side = true;
      }
      vertex.used = true;
      if (!vertex.first.valid() || !mesh.neighbour(s).valid()) vertex.first = s;
    });
  }
  for (const VertexId v : met_) {
    const Vertex& vertex = *vertices_.find(stamped_key(v));
    if (!vertex.used)
      editor.delete_vertex(v);
    else if (vertex.wants_side)
      editor.set_side_of(v, vertex.first);
  }
}

}  // namespace quarry
