#include "kernels/cleanup/patch_stars.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <optional>
#include <utility>

#include "engine/parallel/parallel.hpp"
#include "kernels/cleanup/ideal.hpp"

namespace quarry {

PatchStars::PatchStars(const Mesh& mesh, IrregularPrice price, const NodeSlots* slots)
    : stars_(mesh.vertex_slots()),
      ideal_(mesh.find_tag<VertexId, std::uint8_t>(kIdealTag)),
      tags_(ConstraintTags::of(mesh)),
      price_(std::move(price)),
      slots_(slots) {
  parallel::for_each(stars_.size(), [&](std::size_t i) { update(mesh, VertexId(i)); });
}

void PatchStars::update(const Mesh& mesh, VertexId v) {
  Star star;
  if (mesh.alive(v)) {
    star.ideal = ideal_[v];
    int faces = 0;
    const bool joins = slots_ != nullptr && (tags_.support[v].slides() || tags_.support[v].is_node());
    for_each_side_around(mesh, v, [&](SideId s) {
      ++faces;
      if (joins && tags_.constrained(s) && mesh.neighbour(s).valid()) star.flags |= kLine;
      if (mesh.corner_count(s.face()) == 3) star.flags |= kTriangle;
    });
    // More faces than fit are as bad as the most that do.
    star.faces = static_cast<std::uint8_t>(std::min(faces, 255));
    if (mesh.on_boundary(v))
      star.flags |= kBoundary;
    else if ((star.flags & kLine) == 0 && !tags_.support[v].is_free())
      star.flags |= kPinned;
  }
  stars_[v.value()] = star;
}

double PatchStars::energy(const Mesh& mesh, VertexId v, int faces) const {
  const int weight = valence_energy(faces, ideal(v));
  return price_ && weight != 0 ? weight * price_(mesh.point3(v)) : weight;
}

NodeArms PatchStars::arms(const Mesh& mesh, VertexId v) const {
  const std::optional<NodeArms> arms = slots_->arms_of(mesh, tags_, v);
  assert(arms);
  return *arms;
}

double PatchStars::energy(const Mesh& mesh, VertexId v) const {
  if (!on_line(v)) return energy(mesh, v, faces(v));
  const NodeArms around = arms(mesh, v);
  // The turn comes back to the sector in which it began, the last one.
  std::array<int, NodeArms::kSlots> faces{};
  int met = 0, begun = 0;
  for_each_side_around(mesh, v, [&](SideId s) {
    if (met < around.count() && s == around.side(met)) ++met;
    ++(met == 0 ? begun : faces[static_cast<std::size_t>(met - 1)]);
  });
  faces[static_cast<std::size_t>(met - 1)] += begun;
  int weight = 0;
  for (int i = 0; i < met; ++i) weight += valence_energy(faces[static_cast<std::size_t>(i)], around.ideal(i));
  return price_ && weight != 0 ? weight * price_(mesh.point3(v)) : weight;
}

}  // namespace quarry
