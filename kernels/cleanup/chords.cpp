#include "kernels/cleanup/chords.hpp"

#include "engine/base/random.hpp"

namespace quarry {
namespace {

bool may_vanish(const Mesh& mesh, const ConstraintTags& tags, SideId rung) {
  const VertexId a = mesh.origin(rung);
  const VertexId b = mesh.target(rung);
  if (tags.constrained(rung)) return !tags.support[a].is_fixed() || !tags.support[b].is_fixed();
  return !is_held(mesh, tags, a) || !is_held(mesh, tags, b);
}

}  // namespace

Chords::Chords(const Mesh& mesh, const ConstraintTags& tags)
    : mesh_(&mesh), chord_of_(2 * mesh.face_slots(), kNone) {
  for (const FaceId f : mesh.faces()) {
    if (!mesh.alive(f) || mesh.corner_count(f) != 4) continue;
    for (const int side : {0, 1}) {
      if (across(SideId(f, side)) == kNone) follow(SideId(f, side), tags);
    }
  }
}

// Back to where the chord begins, then along it.
void Chords::follow(SideId from, const ConstraintTags& tags) {
  Chord chord;
  chord.first = from;
  const auto is_quad = [&](SideId s) { return mesh_->corner_count(s.face()) == 4; };
  bool closed = false;
  while (!closed) {
    const SideId back = mesh_->neighbour(chord.first);
    if (!back.valid()) break;
    if (!is_quad(back)) {
      chord.collapsible = false;
      break;
    }
    chord.first = opposite(back);
    closed = chord.first == from;
  }
  SideId s = chord.first;
  do {
    ++chord.faces;
    chord.signature += mix64(s.face().value());
    chord.collapsible =
        chord.collapsible && may_vanish(*mesh_, tags, s) && may_vanish(*mesh_, tags, opposite(s));
    chord_of_[2 * s.face().value() + (s.value() & 1U)] = count();
    s = mesh_->neighbour(opposite(s));
    if (s.valid() && !is_quad(s)) {
      chord.collapsible = false;
      break;
    }
  } while (s.valid() && s != chord.first);
  chords_.push_back(chord);
}

}  // namespace quarry
