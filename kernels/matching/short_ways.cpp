#include "kernels/matching/short_ways.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <limits>

#include "engine/parallel/parallel.hpp"
#include "kernels/matching/spanning_forest.hpp"

namespace quarry {
namespace {

constexpr std::uint32_t kFar = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint64_t kUnclaimed = ~std::uint64_t{0};

class AlternatingTrees {
 public:
  AlternatingTrees(const Mesh& mesh, std::span<const float> shapes, const ShortWayOptions& options)
      : mesh_(mesh),
        shapes_(shapes),
        smallest_(static_cast<float>(options.smallest_shape)),
        mate_(mesh.face_slots()),
        best_(mesh.face_slots()),
        parent_arcs_(mesh.face_slots(), 0),
        level_(mesh.face_slots(), kFar),
        claim_(mesh.face_slots(), kUnclaimed) {}

  std::vector<float> run() {
    pair();
    grow();
    std::vector<float> worths(shapes_.size());
    parallel::for_each(worths.size(),
                       [&](std::size_t i) { worths[i] = worth(SideId(static_cast<std::uint32_t>(i))); });
    return worths;
  }

 private:
  [[nodiscard]] bool single(FaceId f) const { return !mate_[f].valid(); }
  [[nodiscard]] FaceId beyond(SideId s) const { return mesh_.neighbour(s).face(); }
  [[nodiscard]] bool is_arc(SideId s) const { return shapes_[s.value()] > kNoArc; }

  [[nodiscard]] bool good(SideId s) const { return shapes_[s.value()] >= smallest_; }

  // Greedy pairs by rounds: who point at each other are paired.
  void pair() {
    auto open =
        parallel::filter_indices(mesh_.face_slots(), [&](std::size_t i) { return mesh_.alive(FaceId(i)); });
    while (!open.empty()) {
      parallel::for_each(open.size(),
                         [&](std::size_t i) { best_[FaceId(open[i])] = best_side(FaceId(open[i])); });
      parallel::for_each(open.size(), [&](std::size_t i) {
        const SideId s = best_[FaceId(open[i])];
        if (s.valid() && best_[beyond(s)] == mesh_.neighbour(s)) mate_[s.face()] = s;
      });
      const auto kept = parallel::filter_indices(open.size(), [&](std::size_t i) {
        return single(FaceId(open[i])) && best_[FaceId(open[i])].valid();
      });
      std::vector<std::uint32_t> rest(kept.size());
      parallel::for_each(kept.size(), [&](std::size_t i) { rest[i] = open[kept[i]]; });
      open = std::move(rest);
    }
  }

  [[nodiscard]] SideId best_side(FaceId f) const {
    SideId best;
    for (int k = 0; k < 3; ++k) {
      const SideId s(f, k);
      const float mine = shapes_[s.value()];
      if (!good(s) || !single(beyond(s))) continue;
      const bool better =
          !best.valid() || mine > shapes_[best.value()] ||
          (mine == shapes_[best.value()] && matching::canonical(mesh_, s) < matching::canonical(mesh_, best));
      if (better) best = s;
    }
    return best;
  }

  // Breadth first from the single triangles, two arcs a step: to a pair that no tree has, and across it. Of
  // several that reach a pair at once the side of smallest number has it.
  void grow() {
    auto frontier = parallel::filter_indices(
        mesh_.face_slots(), [&](std::size_t i) { return mesh_.alive(FaceId(i)) && single(FaceId(i)); });
    for (const std::uint32_t i : frontier) level_[FaceId(i)] = 0;
    for (std::uint32_t level = 0; !frontier.empty(); level += 2) {
      parallel::for_each(frontier.size(), [&](std::size_t i) {
        for_each_way(FaceId(frontier[i]), [&](SideId s) { claim(pair_of(beyond(s)), s); });
      });
      std::vector<std::array<FaceId, 3>> reached(frontier.size());
      parallel::for_each(frontier.size(),
                         [&](std::size_t i) { reached[i] = take(FaceId(frontier[i]), level); });
      const auto kept = parallel::filter_indices(
          3 * reached.size(), [&](std::size_t i) { return reached[i / 3][i % 3].valid(); });
      frontier.resize(kept.size());
      parallel::for_each(kept.size(),
                         [&](std::size_t i) { frontier[i] = reached[kept[i] / 3][kept[i] % 3].value(); });
    }
  }

  // Calls visit(side) for the arcs from f to pairs that were in no tree when the round began, or that f has
  // claimed in it.
  template <class Visit>
  void for_each_way(FaceId f, const Visit& visit) const {
    for (int k = 0; k < 3; ++k) {
      const SideId s(f, k);
      if (good(s) && s != mate_[f] && !single(beyond(s))) visit(s);
    }
  }
  [[nodiscard]] FaceId pair_of(FaceId f) const { return std::min(f, beyond(mate_[f])); }

  // Pairs taken in earlier rounds keep their claims, which are smaller: the round is part of the key.
  void claim(FaceId pair, SideId s) {
    std::atomic_ref<std::uint64_t> word(claim_[pair]);
    const std::uint64_t mine = key(s);
    std::uint64_t seen = word.load(std::memory_order_relaxed);
    while (mine < seen && !word.compare_exchange_weak(seen, mine, std::memory_order_relaxed)) {
    }
  }
  [[nodiscard]] std::uint64_t key(SideId s) const {
    return (std::uint64_t{level_[s.face()]} << 32) | s.value();
  }

  // The far triangles of the pairs that f has won.
  std::array<FaceId, 3> take(FaceId f, std::uint32_t level) {
    std::array<FaceId, 3> far;
    for_each_way(f, [&](SideId s) {
      const FaceId near = beyond(s);
      if (claim_[pair_of(near)] != key(s)) return;
      parent_arcs_[f] |= matching::bit_of(s.index());
      far[static_cast<std::size_t>(s.index())] = beyond(mate_[near]);
      level_[near] = level + 1;
      level_[beyond(mate_[near])] = level + 2;
    });
    return far;
  }

  [[nodiscard]] float worth(SideId s) const {
    if (!is_arc(s)) return kNoArc;
    if (mate_[s.face()] == s) return 4;
    const SideId t = mesh_.neighbour(s);
    if (matching::contains(parent_arcs_, s) || matching::contains(parent_arcs_, t)) return 3;
    const auto length = [&](SideId side) {
      return std::min<float>(static_cast<float>(level_[side.face()]), 1e6F);
    };
    const bool closes_a_way = good(s) && level_[s.face()] % 2 == 0 && level_[t.face()] % 2 == 0;
    const float nearness = 1 / (2 + length(s) + length(t)) + 1e-4F * shapes_[s.value()];
    return closes_a_way ? 1 + nearness : 0.5F * nearness;
  }

  const Mesh& mesh_;
  std::span<const float> shapes_;
  float smallest_;
  IdVector<FaceId, SideId> mate_;  // the side across which a triangle is paired
  IdVector<FaceId, SideId> best_;
  DualArcs parent_arcs_;                   // towards the leaves
  IdVector<FaceId, std::uint32_t> level_;  // arcs from the root; even where a way may end or go on by any arc
  IdVector<FaceId, std::uint64_t> claim_;  // of the smaller triangle of each pair
};

}  // namespace

std::vector<float> short_way_worths(const Mesh& mesh, std::span<const float> shapes,
                                    const ShortWayOptions& options) {
  return AlternatingTrees(mesh, shapes, options).run();
}

}  // namespace quarry
