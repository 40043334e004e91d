#include "kernels/deferred/refine.hpp"

namespace quarry::deferred {
namespace {

double squared_edge(const Mesh& mesh, SideId s) {
  return squared_length(mesh.point(mesh.target(s)) - mesh.point(mesh.origin(s)));
}

}  // namespace

SideId longest_side(const Mesh& mesh, FaceId f) {
  SideId longest(f, 0);
  double best = squared_edge(mesh, longest);
  for (int k = 1; k < 3; ++k) {
    const double length2 = squared_edge(mesh, SideId(f, k));
    if (length2 > best) {
      best = length2;
      longest = SideId(f, k);
    }
  }
  return longest;
}

SideId edge_to_split_first(const Mesh& mesh, const State& state, SideId s) {
  const double share2 = state.options.close_to_longest * state.options.close_to_longest;
  for (;;) {
    SideId longer;
    for (const SideId side : {s, mesh.neighbour(s)}) {
      if (!side.valid()) continue;
      const SideId longest = longest_side(mesh, side.face());
      if (longest != side && squared_edge(mesh, s) < share2 * squared_edge(mesh, longest)) {
        longer = longest;
        break;
      }
    }
    if (!longer.valid()) return s;
    s = longer;
  }
}

Vec2 split_point(const Mesh& mesh, SideId s) {
  return midpoint(mesh.point(mesh.origin(s)), mesh.point(mesh.target(s)));
}

Support support_on_edge(const Mesh& mesh, const State& state, SideId s) {
  if (state.tags.constrained(s))
    return Support::on(
        state.finder.under_edge(state.tags.support[mesh.origin(s)], state.tags.support[mesh.target(s)]));
  return mesh.neighbour(s).valid() ? Support::free() : Support::fixed();
}

}  // namespace quarry::deferred
