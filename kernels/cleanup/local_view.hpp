// What the local operators see of a mesh that is cut open along its constraints: who may move, how many faces
// each vertex has and should have, and what a change would gain.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "engine/mesh/constraint.hpp"
#include "engine/mesh/mesh.hpp"
#include "kernels/cleanup/ideal.hpp"

namespace quarry {

inline constexpr int kPriceUnit = 16;
inline constexpr int kHighestPrice = 64 * kPriceUnit;  // a vertex of hundreds of faces stays within an int

struct LocalTags {
  ConstraintTags constraints;
  Tag<VertexId, std::uint8_t> ideal;   // kIdealTag
  Tag<VertexId, std::uint16_t> faces;  // how many a vertex has; kept up to date by every operation
  // What a vertex costs, in units of 1 / kPriceUnit; no such tag if all cost the same. A number of the vertex
  // and not of its place, so that no vertex that moves undoes what a change has gained.
  Tag<VertexId, std::uint16_t> price = {};
};

struct LocalView {
  const Mesh& mesh;
  const LocalTags& tags;

  [[nodiscard]] int faces(VertexId v) const { return tags.faces[v]; }
  [[nodiscard]] int ideal(VertexId v) const { return tags.ideal[v]; }
  // Faces beyond the ideal; negative if some are missing.
  [[nodiscard]] int excess(VertexId v) const { return faces(v) - ideal(v); }
  [[nodiscard]] bool inside(VertexId v) const { return !mesh.on_boundary(v); }
  // Free and inside: may be moved and may vanish.
  [[nodiscard]] bool movable(VertexId v) const { return tags.constraints.support[v].is_free() && inside(v); }
  // What so much energy costs at v.
  [[nodiscard]] int cost(VertexId v, int energy) const {
    return tags.price.valid() ? tags.price[v] * energy : energy;
  }
  // By how much the cost falls if v gets so many faces more.
  [[nodiscard]] int gain(VertexId v, int more) const {
    return cost(v, valence_energy(faces(v), ideal(v)) - valence_energy(faces(v) + more, ideal(v)));
  }
  // A face less leaves a vertex that can be valid.
  [[nodiscard]] bool can_lose(VertexId v) const { return faces(v) > (inside(v) ? 3 : 1); }
  [[nodiscard]] bool joined(VertexId a, VertexId b) const {
    return mesh.find_side(a, b).valid() || mesh.find_side(b, a).valid();
  }
  [[nodiscard]] bool quad(FaceId f) const { return mesh.corner_count(f) == 4; }
};

// Picks among the ways of an operator at one vertex: the one that gains most, or the second or third where
// those before were tried and failed. Of equals the one that was offered first.
template <class Plan>
class BestOf {
 public:
  explicit BestOf(std::uint32_t skip) : skip_(skip) {}

  void offer(int gain, const Plan& plan) {
    if (count_ < gains_.size()) {
      gains_[count_] = gain;
      plans_[count_++] = plan;
    }
  }
  // False if fewer were offered than are to be skipped.
  bool take(Plan& plan) {
    if (count_ <= skip_) return false;
    for (std::uint32_t i = 0; i < skip_; ++i) *best() = kTaken;
    plan = plans_[static_cast<std::size_t>(best() - gains_.begin())];
    return true;
  }

 private:
  // Stars of hundreds of faces have more ways than are worth a look.
  static constexpr std::size_t kMost = 96;
  static constexpr int kTaken = -1'000'000;
  auto best() {
    return std::max_element(gains_.begin(), gains_.begin() + static_cast<std::ptrdiff_t>(count_));
  }

  std::uint32_t skip_;
  std::size_t count_ = 0;
  std::array<int, kMost> gains_;
  std::array<Plan, kMost> plans_;
};

}  // namespace quarry
