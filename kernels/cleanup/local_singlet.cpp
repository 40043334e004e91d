#include <algorithm>

#include "kernels/cleanup/local_operators.hpp"

namespace quarry {
namespace {

// A face less leaves no other flat vertex with one face: with every opening there are fewer.
bool can_spare(const LocalView& view, VertexId v) {
  return view.can_lose(v) && (view.inside(v) || view.faces(v) > std::min(2, view.ideal(v)));
}

}  // namespace

bool SingletOpening::wants(const LocalView& view, VertexId v) {
  return view.faces(v) == 1 && view.ideal(v) >= 2 && !view.inside(v);
}

bool SingletOpening::find(const LocalView& view, VertexId v, std::uint32_t skip, Plan& plan) {
  if (!wants(view, v)) return false;
  const Mesh& mesh = view.mesh;
  BestOf<Plan> best(skip);
  for_each_strip_that_gives(view, v, [&](SideId rung, bool mirrored) {
    Strip strip;
    if (!strip.begin(view, rung) || !strip.extend(view)) return;
    const Strip::Plan way{rung, 2, mirrored};
    const VertexId a = mesh.origin(rung);
    const VertexId b = mesh.target(rung);
    // Both ends of a rung that is rotated lose a face.
    if (strip.can_shear(view, mirrored) && can_spare(view, a) && can_spare(view, b))
      best.offer(strip.gain_at_start(view, mirrored) + strip.gain_at_end(view, mirrored), {way, false});
    // A new vertex joined to v, to the far end of the rung and to the corner behind the near end, which loses
    // a face.
    const VertexId near = mirrored ? a : b;
    const SideId far = mesh.next(mesh.next(mesh.neighbour(rung)));
    const VertexId behind = mirrored ? mesh.origin(far) : mesh.target(far);
    if (can_spare(view, near))
      best.offer(
          view.gain(v, 1) + view.gain(near, -1) + view.gain(behind, 1) - view.cost(v, valence_energy(3, 4)),
          {way, true});
  });
  return best.take(plan);
}

void SingletOpening::build(const LocalView& view, const Plan& plan, VertexId fresh_vertex,
                           LocalChange& change) {
  if (!plan.opened) {
    Strip::build(view, plan.strip, change);
    return;
  }
  const Mesh& mesh = view.mesh;
  const SideId rung = plan.strip.rung;
  const SideId across = mesh.neighbour(rung);
  const SideId far = mesh.next(mesh.next(across));
  // The hexagon counter-clockwise from b[1]: b1, b0, a0, a1, a2, b2.
  const VertexId hexagon[6] = {mesh.target(rung),
                               mesh.target(mesh.next(rung)),
                               mesh.origin(mesh.previous(rung)),
                               mesh.origin(rung),
                               mesh.origin(far),
                               mesh.target(far)};
  change.old = {rung.face(), across.face()};
  change.placed = fresh_vertex;
  change.priced_as = hexagon[plan.strip.mirrored ? 2 : 1];  // the one that is opened
  change.mean_of.assign(hexagon, hexagon + 6);
  // b[0] is joined with its alternate corners, mirrored a[0].
  for (int i = plan.strip.mirrored ? 2 : 1, k = 0; k < 3; ++k, i += 2)
    change.fresh.push_back({fresh_vertex, hexagon[i % 6], hexagon[(i + 1) % 6], hexagon[(i + 2) % 6]});
}

}  // namespace quarry
