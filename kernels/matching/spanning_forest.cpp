#include "kernels/matching/spanning_forest.hpp"

#include <atomic>
#include <bit>

#include "engine/parallel/parallel.hpp"

namespace quarry {
namespace {

constexpr std::uint64_t kNobody = ~std::uint64_t{0};

// Unsigned integers in the reverse order of the floats: the best worth is the smallest. Adding zero makes -0
// and 0 one worth.
std::uint32_t inverted_order(float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value + 0.0F);
  return (bits >> 31) != 0 ? bits : ~(bits | 0x80000000U);
}

class ForestGrower {
 public:
  ForestGrower(const Mesh& mesh, std::span<const float> worth)
      : mesh_(mesh),
        worth_(worth),
        link_(mesh.face_slots()),
        forest_{DualArcs(mesh.face_slots(), 0), {}, 0} {}

  SpanningForest run() {
    hook_faces();
    jump_all();
    collect_arcs();
    std::vector<std::uint32_t> roots =
        parallel::filter_indices(link_.size(), [&](std::size_t i) { return is_root(i) && alive(i); });
    best_.assign(mesh_.face_slots(), kNobody);
    while (!arcs_.empty()) {
      ++forest_.rounds;
      choose();
      hook(roots);
      jump(roots);
      roots = select(roots, [&](std::uint32_t root) { return is_root(root); });
      drop_inner_arcs();
    }
    label();
    forest_.arcs = matching::seen_from_both_faces(mesh_, forest_.arcs);
    return std::move(forest_);
  }

 private:
  // An arc between two trees, which their roots stand for.
  struct Arc {
    SideId side;
    std::uint32_t a, b;
  };

  [[nodiscard]] bool alive(std::size_t i) const { return mesh_.alive(FaceId(i)); }
  [[nodiscard]] bool is_root(std::size_t i) const { return link_[i] == i; }

  template <class Keep>
  static std::vector<std::uint32_t> select(const std::vector<std::uint32_t>& list, const Keep& keep) {
    const auto kept = parallel::filter_indices(list.size(), [&](std::size_t i) { return keep(list[i]); });
    std::vector<std::uint32_t> result(kept.size());
    parallel::for_each(kept.size(), [&](std::size_t i) { result[i] = list[kept[i]]; });
    return result;
  }

  [[nodiscard]] std::uint64_t key(SideId s) const {
    return (std::uint64_t{inverted_order(worth_[s.value()])} << 32) | matching::canonical(mesh_, s).value();
  }

  // The best side of a face, a pure function, so that a face may ask for its neighbour's.
  [[nodiscard]] SideId choice(FaceId f) const {
    SideId best;
    std::uint64_t best_key = kNobody;
    for (int k = 0; k < 3; ++k) {
      const SideId s(f, k);
      if (worth_[s.value()] <= kNoArc) continue;
      if (const std::uint64_t mine = key(s); mine < best_key) {
        best_key = mine;
        best = s;
      }
    }
    return best;
  }

  // The first round: every face is a tree and hooks itself to its best neighbour. Two that choose each other
  // would make a cycle: the smaller stays a root.
  void hook_faces() {
    parallel::for_each(mesh_.face_slots(), [&](std::size_t i) {
      link_[i] = static_cast<std::uint32_t>(i);
      const FaceId f(i);
      if (!mesh_.alive(f)) return;
      const SideId s = choice(f);
      if (!s.valid()) return;
      forest_.arcs[f] = matching::bit_of(s.index());
      const SideId t = mesh_.neighbour(s);
      if (f < t.face() && choice(t.face()) == t) return;
      link_[i] = t.face().value();
    });
    ++forest_.rounds;
  }

  // Moves a link towards its root; true if it was not there. Others move links at the same time, always along
  // the same path, so that whatever is read lies on it.
  bool shorten(std::uint32_t i) {
    std::atomic_ref<std::uint32_t> link(link_[i]);
    const std::uint32_t parent = link.load(std::memory_order_relaxed);
    const std::uint32_t beyond = std::atomic_ref(link_[parent]).load(std::memory_order_relaxed);
    if (beyond == parent) return false;
    link.store(beyond, std::memory_order_relaxed);
    return true;
  }

  template <class ItemAt>
  void jump_until_still(std::size_t size, const ItemAt& item_at) {
    const auto jump_all_once = [&] {
      return parallel::reduce_ordered(
          size, 0U,
          [&](std::size_t begin, std::size_t end) {
            std::uint32_t moved = 0;
            for (std::size_t i = begin; i < end; ++i) moved |= shorten(item_at(i)) ? 1U : 0U;
            return moved;
          },
          [](std::uint32_t a, std::uint32_t b) { return a | b; });
    };
    while (jump_all_once() != 0) {
    }
  }
  void jump_all() {
    jump_until_still(link_.size(), [](std::size_t i) { return static_cast<std::uint32_t>(i); });
  }
  void jump(const std::vector<std::uint32_t>& roots) {
    jump_until_still(roots.size(), [&](std::size_t i) { return roots[i]; });
  }

  void collect_arcs() {
    const auto sides = parallel::filter_indices(4 * mesh_.face_slots(), [&](std::size_t i) {
      if (worth_[i] <= kNoArc) return false;
      const SideId s(static_cast<std::uint32_t>(i));
      const SideId t = mesh_.neighbour(s);
      return s < t && link_[s.face().value()] != link_[t.face().value()];
    });
    arcs_.resize(sides.size());
    parallel::for_each(sides.size(), [&](std::size_t i) {
      const SideId s(sides[i]);
      arcs_[i] = {s, link_[s.face().value()], link_[mesh_.neighbour(s).face().value()]};
    });
  }

  // Tells both trees of each arc; each keeps its best. Arcs stay in the order of their sides, so that their
  // positions order ties as the sides would.
  void choose() {
    parallel::for_each(arcs_.size(), [&](std::size_t i) {
      const Arc& arc = arcs_[i];
      const std::uint64_t mine = (std::uint64_t{inverted_order(worth_[arc.side.value()])} << 32) | i;
      for (const std::uint32_t root : {arc.a, arc.b}) {
        std::atomic_ref<std::uint64_t> word(best_[root]);
        std::uint64_t seen = word.load(std::memory_order_relaxed);
        while (mine < seen && !word.compare_exchange_weak(seen, mine, std::memory_order_relaxed)) {
        }
      }
    });
  }

  void hook(const std::vector<std::uint32_t>& roots) {
    parallel::for_each(roots.size(), [&](std::size_t i) {
      const std::uint32_t root = roots[i];
      if (best_[root] == kNobody) return;
      const Arc& arc = arcs_[best_[root] & 0xffffffffU];
      const std::uint32_t other = arc.a == root ? arc.b : arc.a;
      if (root < other && best_[other] == best_[root]) return;
      link_[root] = other;
      std::atomic_ref(forest_.arcs[arc.side.face()])
          .fetch_or(matching::bit_of(arc.side.index()), std::memory_order_relaxed);
    });
    parallel::for_each(roots.size(), [&](std::size_t i) { best_[roots[i]] = kNobody; });
  }

  void drop_inner_arcs() {
    const auto kept = parallel::filter_indices(
        arcs_.size(), [&](std::size_t i) { return link_[arcs_[i].a] != link_[arcs_[i].b]; });
    std::vector<Arc> rest(kept.size());
    parallel::for_each(kept.size(), [&](std::size_t i) {
      const Arc& arc = arcs_[kept[i]];
      rest[i] = {arc.side, link_[arc.a], link_[arc.b]};
    });
    arcs_ = std::move(rest);
  }

  // A face's link leads to its root of the first round, and on from there, a step a round at most.
  void label() {
    forest_.root.resize(mesh_.face_slots());
    parallel::for_each(mesh_.face_slots(), [&](std::size_t i) {
      std::uint32_t root = link_[i];
      while (link_[root] != root) root = link_[root];
      forest_.root[FaceId(i)] = FaceId(root);
    });
  }

  const Mesh& mesh_;
  std::span<const float> worth_;
  std::vector<std::uint32_t> link_;
  std::vector<std::uint64_t> best_;  // of each root: worth and position of its best arc
  std::vector<Arc> arcs_;
  SpanningForest forest_;
};

}  // namespace

namespace matching {

DualArcs seen_from_both_faces(const Mesh& mesh, const DualArcs& arcs) {
  DualArcs both(arcs.size());
  parallel::for_each(arcs.size(), [&](std::size_t i) {
    const FaceId f(i);
    std::uint8_t bits = arcs[f];
    if (!mesh.alive(f)) return;
    for (int k = 0; k < 3; ++k) {
      const SideId t = mesh.neighbour(SideId(f, k));
      if (t.valid() && contains(arcs, t)) bits |= bit_of(k);
    }
    both[f] = bits;
  });
  return both;
}

}  // namespace matching

SpanningForest maximum_spanning_forest(const Mesh& mesh, std::span<const float> worth) {
  return ForestGrower(mesh, worth).run();
}

}  // namespace quarry
