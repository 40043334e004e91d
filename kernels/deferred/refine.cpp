#include "kernels/deferred/refine.hpp"

#include "kernels/local/split.hpp"

namespace quarry::deferred {
namespace {

double squared_edge(const Mesh& mesh, SideId s) {
  return squared_length(mesh.point(mesh.target(s)) - mesh.point(mesh.origin(s)));
}

// What a vertex on the edge is bound to.
Support support_on_edge(const Mesh& mesh, const State& state, SideId s) {
  if (state.tags.constrained(s))
    return Support::on(
        state.finder.under_edge(state.tags.support[mesh.origin(s)], state.tags.support[mesh.target(s)]));
  return mesh.neighbour(s).valid() ? Support::free() : Support::fixed();
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

std::optional<Refinement> propose_refinement(const Mesh& mesh, const State& state, SideId s, Cavity& cavity) {
  if (squared_edge(mesh, s) < state.floor_length * state.floor_length) return std::nullopt;
  const SideId side = edge_to_split_first(mesh, state, s);
  const Vec2 middle = midpoint(mesh.point(mesh.origin(side)), mesh.point(mesh.target(side)));
  if (!can_split_edge(mesh, side, middle)) return std::nullopt;
  claim_split_edge(mesh, side, cavity);
  return Refinement{side, middle, support_on_edge(mesh, state, side)};
}

}  // namespace quarry::deferred
