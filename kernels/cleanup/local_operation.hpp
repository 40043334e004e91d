// A local operator as an operation of the pass: looks for the best way at a vertex, claims all that the
// change and the smoothing after it read, and carries it out.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/operation/pass.hpp"
#include "kernels/cleanup/local_attempt.hpp"
#include "kernels/cleanup/local_operators.hpp"
#include "kernels/cleanup/model_face.hpp"

namespace quarry {

// The scratch memory of this thread, for this model.
template <GeometryModel Model>
LocalAttempt<Model>& attempt_of_thread(const Model& model) {
  thread_local std::optional<LocalAttempt<Model>> attempt;
  if (!attempt || &attempt->model() != &model) attempt.emplace(model);
  return *attempt;
}

template <GeometryModel Model, class Operator>
class LocalOperation {
 public:
  // A vertex, and how many ways have failed there since it was last put on the list.
  struct Item {
    VertexId vertex;
    std::uint32_t failed = 0;
  };
  using Plan = typename Operator::Plan;
  using Rules = typename LocalAttempt<Model>::Rules;

  LocalOperation(const Model& model, const LocalTags& tags, const Rules& rules, std::uint32_t most_ways)
      : model_(model), tags_(tags), rules_(rules), most_ways_(most_ways) {}

  [[nodiscard]] bool wants(const Mesh& mesh, VertexId v) const {
    return mesh.alive(v) && Operator::wants(LocalView{mesh, tags_}, v);
  }

  bool propose(const Mesh& mesh, Item item, Cavity& cavity, Plan& plan) const {
    if (!wants(mesh, item.vertex)) return false;
    const LocalView view{mesh, tags_};
    if (!Operator::find(view, item.vertex, item.failed, plan)) return false;
    thread_local LocalReach reach;
    LocalChange& change = attempt_of_thread(model_).change;
    change.clear();
    Operator::build(view, plan, VertexId(), change);
    reach.gather(view, change);
    if (Operator::kMends && !any_bad(mesh, change.old)) return false;
    reach.claim(mesh, cavity);
    cavity.will_create(Operator::kNewVertices, Operator::kNewFaces);
    return true;
  }

  void apply(MeshEditor& editor, Item item, const Plan& plan, NewIds ids, FollowUps<Item>& follow_ups) const {
    LocalAttempt<Model>& attempt = attempt_of_thread(model_);
    LocalChange& change = attempt.change;
    const Mesh& mesh = editor.mesh();
    const LocalView view{mesh, tags_};
    change.clear();
    Operator::build(view, plan, Operator::kNewVertices > 0 ? ids.take_vertex() : VertexId(), change);
    const Verdict verdict = attempt.run(editor, tags_, rules_, ids);
    counts_[static_cast<std::size_t>(verdict)].fetch_add(1, std::memory_order_relaxed);
    if (verdict != Verdict::kWon) {
      if (item.failed + 1 < most_ways_) follow_ups.push_back({item.vertex, item.failed + 1});
      return;
    }
    for (const FaceCorners& face : change.fresh)
      for (const VertexId v : face)
        if (v.valid() && Operator::wants(view, v)) follow_ups.push_back({v, 0});
  }

  // How many attempts had this verdict. Integer sums: the order of the additions does not matter.
  [[nodiscard]] std::uint64_t count(Verdict verdict) const {
    return counts_[static_cast<std::size_t>(verdict)];
  }

 private:
  [[nodiscard]] bool any_bad(const Mesh& mesh, std::span<const FaceId> faces) const {
    for (const FaceId f : faces)
      if (signed_scaled_jacobian(mesh, model_, f) < rules_.floor) return true;
    return false;
  }

  const Model& model_;
  LocalTags tags_;
  Rules rules_;
  std::uint32_t most_ways_;
  mutable std::array<std::atomic<std::uint64_t>, 3> counts_{};
};

}  // namespace quarry
