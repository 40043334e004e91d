#include "surface/lattice/join_shared.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

#include "kernels/local/collapse.hpp"
#include "kernels/local/star.hpp"
#include "surface/remesh/collapse_guard.hpp"

namespace quarry {
namespace {

class JoinShared {
 public:
  using Item = MeshEdge;
  using Plan = Collapse;

  JoinShared(const LatticeState& state, double lowest) : state_(state), guard_(state.base, lowest) {}

  [[nodiscard]] bool wanted(SideId s) const {
    const VertexId a = state_.base.mesh.origin(s);
    const VertexId b = state_.base.mesh.target(s);
    return (guard_.may_go(s, a) || guard_.may_go(s, b)) && state_.share_point(a, b);
  }

  bool propose(const Mesh& mesh, Item edge, Cavity& cavity, Plan& plan) const {
    const SideId s = state_.base.side_of(edge);
    if (!s.valid() || !wanted(s)) return false;
    const auto way = guard_.better_way(s, edge, [](Collapse) { return true; });
    if (!way) return false;
    plan = *way;
    claim_collapse(mesh, plan.gone, plan.kept, cavity);
    return true;
  }

  void apply(MeshEditor& editor, Item /*edge*/, const Plan& plan, NewIds /*ids*/,
             FollowUps<Item>& more) const {
    collapse_edge(editor, state_.base.tags, plan.gone, plan.kept);
    for_each_link_vertex(editor.mesh(), plan.kept, [&](VertexId v) {
      if (state_.share_point(plan.kept, v)) more.push_back({plan.kept, v});
    });
  }

 private:
  const LatticeState& state_;
  CollapseGuard guard_;
};

}  // namespace

PassReport join_shared_points(LatticeState& state, double lowest, const Progress& progress) {
  const JoinShared operation(state, lowest);
  return run_pass(state.base.mesh, operation,
                  edges_where(state.base.mesh, [&](SideId s) { return operation.wanted(s); }), PassOptions(),
                  progress);
}

std::size_t count_after_joins(const LatticeState& state) {
  const JoinShared operation(state, 0);
  const Mesh& mesh = state.base.mesh;
  std::vector<std::uint32_t> root(mesh.vertex_slots());
  std::iota(root.begin(), root.end(), 0U);
  const auto find = [&](std::uint32_t i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  std::size_t count = mesh.count_alive_vertices();
  for (const MeshEdge edge : edges_where(mesh, [&](SideId s) { return operation.wanted(s); })) {
    const std::uint32_t a = find(edge.a.value());
    const std::uint32_t b = find(edge.b.value());
    if (a == b) continue;
    root[std::max(a, b)] = std::min(a, b);
    --count;
  }
  return count;
}

}  // namespace quarry
