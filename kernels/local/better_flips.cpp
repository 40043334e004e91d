#include "kernels/local/better_flips.hpp"

#include <algorithm>
#include <vector>

#include "engine/mesh/constraint.hpp"
#include "kernels/local/flip.hpp"
#include "kernels/quality/element.hpp"

namespace quarry {
namespace {

// A gain of rounding size would flip an edge of a square for ever.
constexpr double kLeastGain = 1e-6;
// A look takes less time than what it looks at takes to come from memory: all of a window is looked at in
// each round, and is small enough to stay near.
constexpr PassOptions kPass{.window = 4096, .cutoff = 1};

class FlipIfBetter {
 public:
  // An edge by its ends: a side may be turned by the flip of another edge.
  struct Item {
    VertexId a, b;
    SideId last_seen;  // where the edge a-b was
  };
  struct Plan {};

  explicit FlipIfBetter(ConstraintTags tags) : tags_(tags) {}

  [[nodiscard]] bool is_better(const Mesh& mesh, SideId s) const {
    if (!mesh.neighbour(s).valid() || tags_.constrained(s)) return false;
    const EdgeDiamond diamond = diamond_of(mesh, s);
    const Vec2 a = mesh.point(diamond.a), b = mesh.point(diamond.b);
    const Vec2 c = mesh.point(diamond.c), d = mesh.point(diamond.d);
    const double before = std::min(lo_measure(a, b, c), lo_measure(b, a, d));
    const double after = std::min(lo_measure(c, a, d), lo_measure(d, b, c));
    return after > before + kLeastGain && can_flip(mesh, s);
  }

  bool propose(const Mesh& mesh, Item item, Cavity& cavity, Plan& /*plan*/) const {
    const SideId s = side_of(mesh, item);
    if (!s.valid() || !is_better(mesh, s)) return false;
    claim_flip(mesh, s, cavity);
    return true;
  }

  void apply(MeshEditor& editor, Item item, const Plan& /*plan*/, NewIds /*ids*/,
             FollowUps<Item>& follow_ups) const {
    const Mesh& mesh = editor.mesh();
    const SideId s = side_of(mesh, item);
    const auto [a, b, c, d] = diamond_of(mesh, s);
    const SideId left = flip_edge(editor, tags_, s);  // c -> d, with b on its left
    const SideId right = mesh.neighbour(left);
    for (const Item outer : {Item{a, d, mesh.previous(right)}, Item{d, b, mesh.next(left)},
                             Item{b, c, mesh.previous(left)}, Item{c, a, mesh.next(right)}})
      follow_ups.push_back(outer);
  }

 private:
  // Most edges are where they were.
  static SideId side_of(const Mesh& mesh, Item item) {
    const SideId s = item.last_seen;
    if (mesh.origin(s) == item.a && mesh.target(s) == item.b) return s;
    return mesh.find_side(item.a, item.b);
  }

  ConstraintTags tags_;
};

}  // namespace

PassReport flip_to_better(Mesh& mesh, const Progress& progress) {
  const FlipIfBetter operation(ConstraintTags::of(mesh));
  const auto sides = parallel::filter_indices(4 * mesh.face_slots(), [&](std::size_t i) {
    const SideId s(static_cast<std::uint32_t>(i));
    if (s.index() == 3 || !mesh.alive(s.face())) return false;
    return mesh.origin(s) < mesh.target(s) && operation.is_better(mesh, s);
  });
  std::vector<FlipIfBetter::Item> work;
  work.reserve(sides.size());
  for (const std::uint32_t i : sides)
    work.push_back({mesh.origin(SideId(i)), mesh.target(SideId(i)), SideId(i)});
  PassReport report = run_pass(mesh, operation, std::move(work), kPass, progress);
  report.name = "flips to better triangles";
  return report;
}

}  // namespace quarry
