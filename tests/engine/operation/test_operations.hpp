// Operations to try the pass with: flips towards Delaunay, longest-edge bisection, and a queue at one vertex.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <utility>
#include <vector>

#include "engine/base/random.hpp"
#include "engine/geometry/predicates.hpp"
#include "engine/mesh/constraint.hpp"
#include "engine/operation/pass.hpp"
#include "kernels/local/flip.hpp"
#include "kernels/local/split.hpp"
#include "tests/support/mesh_zoo.hpp"

namespace quarry::test {

// An edge by its ends, which survive flips of other edges.
struct EdgeItem {
  VertexId a, b;
};
struct NoPlan {};

// Calls add(EdgeItem) for each side of the face.
template <class Add>
void for_each_edge_of(const Mesh& mesh, FaceId f, Add&& add) {
  for (int k = 0; k < 3; ++k) add(EdgeItem{mesh.origin(SideId(f, k)), mesh.target(SideId(f, k))});
}

inline std::vector<EdgeItem> edges_of(const Mesh& mesh) {
  std::vector<EdgeItem> edges;
  for (const FaceId f : mesh.faces())
    for_each_edge_of(mesh, f, [&](EdgeItem item) {
      const SideId t = mesh.find_side(item.b, item.a);
      if (item.a < item.b || !t.valid()) edges.push_back(item);
    });
  return edges;
}

// Flips edges whose circle holds the point across. forgets_a_claim plants a bug: one vertex of the diamond is
// left out.
class FlipToDelaunay {
 public:
  using Item = EdgeItem;
  using Plan = NoPlan;

  FlipToDelaunay(ConstraintTags tags, bool forgets_a_claim)
      : tags_(tags), forgets_a_claim_(forgets_a_claim) {}

  bool propose(const Mesh& mesh, Item item, Cavity& cavity, Plan& /*plan*/) const {
    const SideId s = mesh.find_side(item.a, item.b);
    if (!s.valid() || !mesh.neighbour(s).valid() || tags_.constrained(s)) return false;
    const auto [a, b, c, d] = diamond_of(mesh, s);
    if (!(incircle(mesh.point(a), mesh.point(b), mesh.point(c), mesh.point(d)) > 0)) return false;
    if (forgets_a_claim_)
      for (const VertexId v : {a, b, c}) cavity.claim(v);
    else
      claim_flip(mesh, s, cavity);
    return true;
  }

  void apply(MeshEditor& editor, Item item, const Plan& /*plan*/, NewIds /*ids*/,
             FollowUps<Item>& follow_ups) const {
    const SideId s = editor.mesh().find_side(item.a, item.b);
    const auto [a, b, c, d] = diamond_of(editor.mesh(), s);
    flip_edge(editor, tags_, s);
    ++applied_;
    for (const EdgeItem outer : {EdgeItem{a, d}, EdgeItem{d, b}, EdgeItem{b, c}, EdgeItem{c, a}})
      follow_ups.push_back(outer);
  }

  [[nodiscard]] std::uint64_t applied() const { return applied_; }

 private:
  ConstraintTags tags_;
  bool forgets_a_claim_;
  mutable std::atomic<std::uint64_t> applied_{0};
};

// Halves edges longer than a limit that are the longest of their triangles, until there is none.
class BisectLongEdges {
 public:
  using Item = EdgeItem;
  using Plan = NoPlan;

  BisectLongEdges(ConstraintTags tags, double limit) : tags_(tags), limit_(limit) {}

  bool propose(const Mesh& mesh, Item item, Cavity& cavity, Plan& /*plan*/) const {
    SideId s = mesh.find_side(item.a, item.b);
    if (!s.valid()) s = mesh.find_side(item.b, item.a);
    if (!s.valid() || length_of(mesh, s) <= limit_) return false;
    const SideId t = mesh.neighbour(s);
    if (!longest(mesh, s) || (t.valid() && !longest(mesh, t))) return false;
    claim_split_edge(mesh, s, cavity);
    return true;
  }

  void apply(MeshEditor& editor, Item item, const Plan& /*plan*/, NewIds ids,
             FollowUps<Item>& follow_ups) const {
    const Mesh& mesh = editor.mesh();
    SideId s = mesh.find_side(item.a, item.b);
    if (!s.valid()) s = mesh.find_side(item.b, item.a);
    const Vec2 p = midpoint(mesh.point(mesh.origin(s)), mesh.point(mesh.target(s)));
    const VertexId m = split_edge(editor, tags_, s, p, Support(), ids);
    ++applied_;
    for_each_side_around(mesh, m, [&](SideId around) {
      for_each_edge_of(mesh, around.face(), [&](EdgeItem edge) { follow_ups.push_back(edge); });
    });
  }

  [[nodiscard]] std::uint64_t applied() const { return applied_; }

 private:
  static double length_of(const Mesh& mesh, SideId s) {
    return distance(mesh.point(mesh.origin(s)), mesh.point(mesh.target(s)));
  }
  static bool longest(const Mesh& mesh, SideId s) {
    const double own = length_of(mesh, s);
    return own >= length_of(mesh, mesh.next(s)) && own >= length_of(mesh, mesh.previous(s));
  }

  ConstraintTags tags_;
  double limit_;
  mutable std::atomic<std::uint64_t> applied_{0};
};

// All items want the same vertex. Applying one adds one to a counter there; may cancel the job on the way.
class QueueAtOneVertex {
 public:
  using Item = std::uint32_t;
  using Plan = NoPlan;

  explicit QueueAtOneVertex(CancellationToken* token, std::uint64_t cancel_after)
      : token_(token), cancel_after_(cancel_after) {}

  bool propose(const Mesh& /*mesh*/, Item /*item*/, Cavity& cavity, Plan& /*plan*/) const {
    cavity.claim(VertexId(0U));
    return true;
  }
  void apply(MeshEditor& editor, Item /*item*/, const Plan& /*plan*/, NewIds /*ids*/,
             FollowUps<Item>&) const {
    editor.set_point(VertexId(0U), editor.point(VertexId(0U)) - Vec2{1, 0});
    if (++applied_ == cancel_after_) token_->cancel();
  }
  [[nodiscard]] std::uint64_t applied() const { return applied_; }

 private:
  CancellationToken* token_;
  std::uint64_t cancel_after_;
  mutable std::atomic<std::uint64_t> applied_{0};
};

// A lattice with its inner points shaken, so that many edges want to be flipped and some are constraints.
struct TrialMesh {
  Mesh mesh;
  ConstraintTags tags;
};

inline TrialMesh trial_mesh(std::uint32_t cells, std::uint64_t seed) {
  TrialMesh trial;
  trial.mesh = triangle_lattice(cells, cells, {465'000, 6'691'000});
  trial.tags = ConstraintTags::add_to(trial.mesh);
  for (const VertexId v : trial.mesh.vertices()) {
    if (trial.mesh.on_boundary(v)) continue;
    const auto shake = [&](std::uint64_t k) { return 0.4 * (uniform01(seed, 2 * v.value() + k) - 0.5); };
    trial.mesh.set_point(v, trial.mesh.point(v) + Vec2{shake(0), shake(1)});
  }
  for (const FaceId f : trial.mesh.faces()) {
    if (mix32(f.value()) % 16 != 0) continue;
    const SideId s(f, 1);
    const SideId t = trial.mesh.neighbour(s);
    trial.tags.set_constrained(s, true);
    if (t.valid()) trial.tags.set_constrained(t, true);
  }
  return trial;
}

}  // namespace quarry::test
