#include "kernels/matching/subtree_parity.hpp"

#include <atomic>
#include <bit>

#include "engine/parallel/parallel.hpp"

namespace quarry {
namespace {

// The state of a face while leaves are peeled: the arcs that are left, and the parity of what was peeled off
// through the others, itself included.
constexpr std::uint8_t kArcs = 7;
constexpr std::uint8_t kOdd = 8;

class Peeling {
 public:
  Peeling(const Mesh& mesh, const DualArcs& forest)
      : mesh_(mesh), forest_(forest), state_(forest.size()), join_(forest.size(), 0) {
    parallel::for_each(forest.size(), [&](std::size_t i) {
      state_[FaceId(i)] = static_cast<std::uint8_t>(forest_[FaceId(i)] | kOdd);
    });
  }

  DualArcs run() {
    parallel::for_each(forest_.size(), [&](std::size_t i) {
      const FaceId f(i);
      if (matching::degree(forest_[f]) == 1) peel_from(f);
    });
    return matching::seen_from_both_faces(mesh_, join_);
  }

 private:
  // Peels a leaf, and the face behind it if that is a leaf now. Two faces that are left with the arc between
  // them may peel it from both ends: in an even tree both find the same. The order of memory accesses is
  // that of the one word of a face; join_[f] is written only by who peels f, once.
  void peel_from(FaceId f) {
    std::uint8_t state = static_cast<std::uint8_t>(forest_[f] | kOdd);
    while (matching::degree(state & kArcs) == 1) {
      const int side = std::countr_zero(static_cast<unsigned>(state & kArcs));
      const auto odd = static_cast<std::uint8_t>(state & kOdd);
      if (odd != 0) join_[f] = matching::bit_of(side);
      const SideId across = mesh_.neighbour(SideId(f, side));
      const auto change = static_cast<std::uint8_t>(matching::bit_of(across.index()) | odd);
      const std::uint8_t before =
          std::atomic_ref(state_[across.face()]).fetch_xor(change, std::memory_order_relaxed);
      state = static_cast<std::uint8_t>(before ^ change);
      f = across.face();
    }
  }

  const Mesh& mesh_;
  const DualArcs& forest_;
  IdVector<FaceId, std::uint8_t> state_;
  DualArcs join_;
};

}  // namespace

DualArcs subtree_parity_join(const Mesh& mesh, const DualArcs& forest) { return Peeling(mesh, forest).run(); }

}  // namespace quarry
