#include "kernels/cluster/merge.hpp"

#include <span>
#include <utility>
#include <vector>

#include "engine/parallel/parallel.hpp"

namespace quarry {
namespace {

// Numbers the sides of the merged mesh. With t the smaller triangle of a pair, merged across its side k, and
// u the other one, merged across l, the quad's sides are t.k+1, t.k+2, u.l+1, u.l+2. A single triangle keeps
// its sides.
class MergedSides {
 public:
  MergedSides(const Mesh& mesh, const Pairing& pairing)
      : mesh_(mesh), merged_(pairing.merged), face_(mesh.face_slots() + 1) {
    parallel::for_each(mesh.face_slots(), [&](std::size_t i) { face_[i] = leads(FaceId(i)) ? 1 : 0; });
    count_ = parallel::exclusive_scan(std::span(face_));
  }

  [[nodiscard]] std::size_t count() const { return count_; }

  // True if f stands for its face of the merged mesh.
  [[nodiscard]] bool leads(FaceId f) const {
    if (!mesh_.alive(f)) return false;
    return !merged_[f].valid() || mesh_.neighbour(merged_[f]).face() > f;
  }

  // The side of the merged mesh that a side of a triangle becomes. Must not be a side that vanishes.
  [[nodiscard]] SideId operator()(SideId s) const {
    const FaceId f = s.face();
    const SideId across = merged_[f];
    if (!across.valid()) return {FaceId(face_[f.value()]), s.index()};
    const int place = (s.index() - across.index() + 2) % 3;
    if (leads(f)) return {FaceId(face_[f.value()]), place};
    return {FaceId(face_[mesh_.neighbour(across).face().value()]), place + 2};
  }

  [[nodiscard]] bool vanishes(SideId s) const { return merged_[s.face()] == s; }

 private:
  const Mesh& mesh_;
  const IdVector<FaceId, SideId>& merged_;
  std::vector<std::uint32_t> face_;
  std::uint32_t count_ = 0;
};

void copy_vertices(const Mesh& from, ConstraintTags from_tags, const MergedSides& sides, Mesh& to,
                   ConstraintTags to_tags) {
  parallel::for_each(from.vertex_slots(), [&](std::size_t i) {
    const VertexId v(i);
    to_tags.support[v] = from_tags.support[v];
    copy_point(from, v, to, v);
    if (!from.alive(v)) return;
    // A side that vanishes is inside, so that the next one clockwise exists, and does not vanish too.
    SideId s = from.side_of(v);
    if (sides.vanishes(s)) s = from.turn_right(s);
    to.set_side_of(v, sides(s));
  });
}

}  // namespace

Mesh merge_pairs(Mesh&& triangles, const Pairing& pairing) {
  const Mesh from = std::move(triangles);
  const ConstraintTags from_tags = ConstraintTags::of(from);
  const MergedSides sides(from, pairing);
  Mesh to;
  if (!from.planar()) to.make_spatial();
  ConstraintTags to_tags = ConstraintTags::add_to(to);
  to.grow_vertices(from.vertex_slots());
  to.grow_faces(sides.count());
  copy_vertices(from, from_tags, sides, to, to_tags);
  parallel::for_each(from.face_slots(), [&](std::size_t i) {
    const FaceId f(i);
    // Triangles write their own sides of a quad. The bits are a byte a quad, which its leader writes for
    // both.
    if (!from.alive(f)) return;
    for (int k = 0; k < 3; ++k) {
      const SideId s(f, k);
      if (sides.vanishes(s)) continue;
      const SideId across = from.neighbour(s);
      to.set_corner(sides(s), from.origin(s));
      to.set_neighbour(sides(s), across.valid() ? sides(across) : SideId());
    }
    if (!sides.leads(f)) return;
    const auto carry_bits = [&](FaceId part) {
      for (int k = 0; k < 3; ++k)
        if (const SideId s(part, k); !sides.vanishes(s) && from_tags.constrained(s))
          to_tags.set_constrained(sides(s), true);
    };
    carry_bits(f);
    if (pairing.merged[f].valid()) carry_bits(from.neighbour(pairing.merged[f]).face());
  });
  return to;
}

}  // namespace quarry
