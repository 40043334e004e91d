#include <array>

#include "kernels/cleanup/local_operators.hpp"

namespace quarry {
namespace {

// Stars with more faces are no case for one split.
constexpr int kMostFaces = 24;

// The faces of a vertex counter-clockwise, and its spokes: one more than faces on the boundary.
struct Fan {
  std::array<SideId, kMostFaces> sides;
  std::array<VertexId, kMostFaces + 1> spokes;
  int faces = 0;
  bool quads = true;

  Fan(const LocalView& view, VertexId v) {
    for_each_side_around(view.mesh, v, [&](SideId s) {
      if (faces == kMostFaces) return;
      quads = quads && view.quad(s.face());
      spokes[static_cast<std::size_t>(faces)] = view.mesh.target(s);
      sides[static_cast<std::size_t>(faces++)] = s;
    });
    spokes[static_cast<std::size_t>(faces)] =
        view.mesh.origin(view.mesh.previous(sides[static_cast<std::size_t>(faces - 1)]));
  }
  [[nodiscard]] SideId side(int i) const { return sides[static_cast<std::size_t>(i % faces)]; }
};

}  // namespace

bool VertexSplit::wants(const LocalView& view, VertexId v) {
  return view.excess(v) > 0 && view.faces(v) <= kMostFaces;
}

bool VertexSplit::find(const LocalView& view, VertexId v, std::uint32_t skip, Plan& plan) {
  if (!wants(view, v)) return false;
  const Fan fan(view, v);
  if (!fan.quads) return false;
  const bool inside = view.inside(v);
  const int faces = fan.faces;
  BestOf<Plan> best(skip);
  for (int first = 0; first < faces; ++first) {
    // Both vertices need three faces inside; on the boundary the old one may be left with the new quad alone.
    const int most = inside ? faces - 2 : faces - first;
    for (int moved = 2; moved <= most; ++moved) {
      // Inside, the other part with the vertices exchanged is the same split.
      if (inside && 2 * moved == faces && 2 * first >= faces) continue;
      const int last = inside ? (first + moved) % faces : first + moved;
      const int gain = view.gain(v, 1 - moved) - view.cost(v, valence_energy(moved + 1, 4)) +
                       view.gain(fan.spokes[static_cast<std::size_t>(first)], 1) +
                       view.gain(fan.spokes[static_cast<std::size_t>(last)], 1);
      if (gain > 0) best.offer(gain, {fan.side(first), static_cast<std::uint16_t>(moved)});
    }
  }
  return best.take(plan);
}

void VertexSplit::build(const LocalView& view, const Plan& plan, VertexId fresh_vertex, LocalChange& change) {
  const Mesh& mesh = view.mesh;
  const VertexId v = mesh.origin(plan.side);
  SideId s = plan.side;
  const VertexId first = mesh.target(s);
  VertexId last;
  change.placed = fresh_vertex;
  change.priced_as = v;
  // Faces not moved stay; what the new vertex is placed between are its own corners and the old vertex.
  change.mean_of.push_back(v);
  change.mean_of.push_back(first);
  for (int i = 0; i < plan.moved; ++i) {
    change.old.push_back(s.face());
    change.fresh.push_back(LocalChange::exchanged(mesh, s.face(), v, fresh_vertex));
    last = mesh.origin(mesh.previous(s));
    change.mean_of.push_back(last);
    s = mesh.turn_left(s);
  }
  change.fresh.push_back({v, first, fresh_vertex, last});
}

}  // namespace quarry
