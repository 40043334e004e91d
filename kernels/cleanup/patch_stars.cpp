#include "kernels/cleanup/patch_stars.hpp"

#include <algorithm>
#include <utility>

#include "engine/parallel/parallel.hpp"
#include "kernels/cleanup/ideal.hpp"

namespace quarry {
namespace {

constexpr int kStraight = 2;  // faces on each side of a straight line

}  // namespace

PatchStars::PatchStars(const Mesh& mesh, IrregularPrice price)
    : stars_(mesh.vertex_slots()),
      ideal_(mesh.find_tag<VertexId, std::uint8_t>(kIdealTag)),
      tags_(ConstraintTags::of(mesh)),
      price_(std::move(price)) {
  parallel::for_each(stars_.size(), [&](std::size_t i) { update(mesh, VertexId(i)); });
}

void PatchStars::update(const Mesh& mesh, VertexId v) {
  Star star;
  if (mesh.alive(v)) {
    star.ideal = ideal_[v];
    int faces = 0;
    const bool slides = tags_.support[v].slides();
    for_each_side_around(mesh, v, [&](SideId s) {
      ++faces;
      if (slides && tags_.constrained(s) && mesh.neighbour(s).valid()) star.flags |= kLine;
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

double PatchStars::energy(const Mesh& mesh, VertexId v) const {
  if (!on_line(v)) return energy(mesh, v, faces(v));
  // Faces of the side that the turn is in, and of the one that it began in, which it comes back to.
  int weight = 0, count = 0, begun = -1;
  for_each_side_around(mesh, v, [&](SideId s) {
    if (is_line(mesh, s)) {
      if (begun < 0)
        begun = count;
      else
        weight += valence_energy(count, kStraight);
      count = 0;
    }
    ++count;
  });
  if (on_boundary(v))
    weight += valence_energy(begun, kStraight) + valence_energy(count, kStraight);
  else
    weight += valence_energy(begun + count, kStraight);
  return price_ && weight != 0 ? weight * price_(mesh.point3(v)) : weight;
}

}  // namespace quarry
