#include "surface/remesh/flip_better.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "kernels/local/flip.hpp"
#include "kernels/local/star.hpp"

namespace quarry {
namespace {

// A gain of rounding size would flip the edge of a square for ever.
constexpr double kLeastGain = 1e-3;
// The cosine of the angle between two triangles up to which they count as one piece of surface.
constexpr double kFlat = 0.7;
// For the sake of valences triangles may become as low as this, and no lower.
constexpr double kLowestForValence = 0.5;

class FlipBetter {
 public:
  using Item = MeshEdge;
  struct Plan {};

  FlipBetter(const RemeshState& state, FlipAim aim) : state_(state), guard_(state.guard()), aim_(aim) {}

  [[nodiscard]] bool wanted(SideId s) const {
    const Mesh& mesh = state_.mesh;
    if (!mesh.neighbour(s).valid() || state_.tags.constrained(s)) return false;
    const auto [a, b, c, d] = diamond_of(mesh, s);
    if (c == d) return false;
    const Vec3 pa = state_.point(a), pb = state_.point(b), pc = state_.point(c), pd = state_.point(d);
    const double least = aim_ == FlipAim::kValence
                             ? kLowestForValence
                             : std::min(lo_measure(pa, pb, pc), lo_measure(pb, pa, pd)) + kLeastGain;
    if (!(lo_measure(pc, pa, pd) >= least) || !(lo_measure(pd, pb, pc) >= least)) return false;
    const Vec3 old_1 = unit_normal(pa, pb, pc);
    const Vec3 old_2 = unit_normal(pb, pa, pd);
    const Vec3 new_1 = unit_normal(pc, pa, pd);
    const Vec3 new_2 = unit_normal(pd, pb, pc);
    // Flat triangles have no say.
    if (!(old_1 == Vec3()) && !(old_2 == Vec3()) && dot(old_1, old_2) < kFlat) return false;
    if (!(dot(new_1, new_2) >= kFlat)) return false;
    for (const Vec3 n : {new_1, new_2})
      if (!guard_.agrees(n, old_1) || !guard_.agrees(n, old_2)) return false;
    if (!guard_.faces_up({c, a, d}, {pc, pa, pd}) || !guard_.faces_up({d, b, c}, {pd, pb, pc})) return false;
    if (aim_ == FlipAim::kValence && !gains_valence({a, b}, {c, d}, [&](VertexId v) { return excess(v); }))
      return false;
    // Last: it takes as long as all else, and few come so far.
    return !mesh.find_side(c, d).valid() && !mesh.find_side(d, c).valid();
  }

  // The wanted edges of the whole mesh; for valences those are looked at that would come nearer to six.
  [[nodiscard]] std::vector<MeshEdge> all_wanted() const {
    const Mesh& mesh = state_.mesh;
    if (aim_ == FlipAim::kMeasure) return edges_where(mesh, [&](SideId s) { return wanted(s); });
    std::vector<int> excesses(mesh.vertex_slots());
    parallel::for_each(excesses.size(), [&](std::size_t i) {
      if (mesh.alive(VertexId(i))) excesses[i] = excess(VertexId(i));
    });
    return edges_where(mesh, [&](SideId s) {
      if (!mesh.neighbour(s).valid()) return false;
      const auto [a, b, c, d] = diamond_of(mesh, s);
      return gains_valence({a, b}, {c, d}, [&](VertexId v) { return excesses[v.value()]; }) && wanted(s);
    });
  }

  bool propose(const Mesh& mesh, Item edge, Cavity& cavity, Plan& /*plan*/) const {
    const SideId s = state_.side_of(edge);
    if (!s.valid() || !wanted(s)) return false;
    claim_flip(mesh, s, cavity);
    // The stars that valences are read from change only with claims on their centres, which are these four.
    return true;
  }

  void apply(MeshEditor& editor, Item edge, const Plan& /*plan*/, NewIds /*ids*/,
             FollowUps<Item>& more) const {
    const SideId s = state_.side_of(edge);
    const auto [a, b, c, d] = diamond_of(editor.mesh(), s);
    flip_edge(editor, state_.tags, s);
    for (const Item outer : {Item{a, d}, Item{d, b}, Item{b, c}, Item{c, a}}) more.push_back(outer);
  }

 private:
  // How far the number of triangles is from the ideal: 6, and 3 on the rim.
  [[nodiscard]] int excess(VertexId v) const {
    int faces = 0;
    for_each_side_around(state_.mesh, v, [&](SideId) { ++faces; });
    return faces - (state_.mesh.on_boundary(v) ? 3 : 6);
  }

  template <class Excess>
  [[nodiscard]] static bool gains_valence(std::array<VertexId, 2> less, std::array<VertexId, 2> more,
                                          const Excess& excess_of) {
    int gain = 0;
    for (const VertexId v : less) {
      const int e = excess_of(v);
      gain += e * e - (e - 1) * (e - 1);
    }
    for (const VertexId v : more) {
      const int e = excess_of(v);
      gain += e * e - (e + 1) * (e + 1);
    }
    return gain > 0;
  }

  const RemeshState& state_;
  TriangleGuard guard_;
  FlipAim aim_;
};

}  // namespace

PassReport flip_edges(RemeshState& state, FlipAim aim, const Progress& progress) {
  const FlipBetter operation(state, aim);
  return run_pass(state.mesh, operation, operation.all_wanted(), PassOptions(), progress);
}

}  // namespace quarry
