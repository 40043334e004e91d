#include "surface/remesh/collapse_short.hpp"

#include <array>

#include "kernels/local/collapse.hpp"
#include "kernels/local/star.hpp"
#include "surface/remesh/collapse_guard.hpp"

namespace quarry {
namespace {

// Triangles may become as low as this for the sake of a collapse: flips and moves mend them.
constexpr double kLowestAfter = 0.2;

class CollapseShort {
 public:
  using Item = MeshEdge;
  using Plan = Collapse;

  explicit CollapseShort(const RemeshState& state) : state_(state), guard_(state, kLowestAfter) {}

  [[nodiscard]] bool wanted(SideId s) const {
    const Mesh& mesh = state_.mesh;
    const VertexId a = mesh.origin(s);
    const VertexId b = mesh.target(s);
    return too_short(a, b) && (guard_.may_go(s, a) || guard_.may_go(s, b));
  }

  bool propose(const Mesh& mesh, Item edge, Cavity& cavity, Plan& plan) const {
    const SideId s = state_.side_of(edge);
    if (!s.valid() || !wanted(s)) return false;
    const auto way = guard_.better_way(s, edge, [&](Collapse tried) { return !makes_long_edge(tried); });
    if (!way) return false;
    plan = *way;
    claim_collapse(mesh, plan.gone, plan.kept, cavity);
    return true;
  }

  void apply(MeshEditor& editor, Item /*edge*/, const Plan& plan, NewIds /*ids*/,
             FollowUps<Item>& more) const {
    collapse_edge(editor, state_.tags, plan.gone, plan.kept);
    // What was too long to become longer may be so no more.
    for_each_link_vertex(editor.mesh(), plan.kept, [&](VertexId v) {
      if (too_short(plan.kept, v)) more.push_back({plan.kept, v});
    });
  }

 private:
  [[nodiscard]] bool too_short(VertexId a, VertexId b) const {
    return state_.relative_length(a, b) < state_.options.shortest;
  }
  [[nodiscard]] bool makes_long_edge(Collapse way) const {
    bool long_edge = false;
    for_each_link_vertex(state_.mesh, way.gone, [&](VertexId v) {
      long_edge = long_edge || state_.relative_length(way.kept, v) > state_.options.longest;
    });
    return long_edge;
  }

  const RemeshState& state_;
  CollapseGuard guard_;
};

}  // namespace

PassReport collapse_short_edges(RemeshState& state, const Progress& progress) {
  const CollapseShort operation(state);
  return run_pass(state.mesh, operation,
                  edges_where(state.mesh, [&](SideId s) { return operation.wanted(s); }), PassOptions(),
                  progress);
}

}  // namespace quarry
