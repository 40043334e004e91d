#include "kernels/cleanup/patch_memory.hpp"

#include <algorithm>
#include <atomic>

#include "engine/base/random.hpp"
#include "engine/parallel/parallel.hpp"

namespace quarry {

void KeySet::place(std::uint64_t key) {
  std::size_t at = key & (slots_.size() - 1);
  while (slots_[at] != 0) at = (at + 1) & (slots_.size() - 1);
  slots_[at] = key;
}

void KeySet::insert(std::uint64_t key) {
  if (contains(key)) return;
  if (2 * (count_ + 1) > slots_.size()) {
    constexpr std::size_t kFirst = 64;
    std::vector<std::uint64_t> old(std::max(kFirst, 2 * slots_.size()), 0);
    std::swap(old, slots_);
    for (const std::uint64_t other : old)
      if (other != 0) place(other);
  }
  ++count_;
  place(key);
}

void KeySet::clear() {
  if (count_ > 0) std::fill(slots_.begin(), slots_.end(), 0);
  count_ = 0;
}

void PatchMemory::begin_class(Mesh& mesh) {
  courses_ = KeySet();
  signatures_ = mesh.find_tag<FaceId, std::uint64_t>(kSignatureTag);
  if (signatures_.valid()) return;
  signatures_ = mesh.add_tag<FaceId, std::uint64_t>(kSignatureTag, 0);
  parallel::for_each(mesh.face_slots(), [&](std::size_t i) { signatures_[FaceId(i)] = mix64(i); });
}

void PatchMemory::renew(const Mesh& mesh, std::span<const FaceId> made, std::span<const VertexId> rim,
                        std::uint64_t key) {
  Tag<FaceId, std::uint64_t> signatures = signatures_;
  // A face outside may touch two patches that are committed at the same time: sums do not ask for an order.
  for (const VertexId v : rim)
    for_each_side_around(mesh, v, [&](SideId s) {
      std::atomic_ref<std::uint64_t>(signatures[s.face()])
          .fetch_add(mix64(key ^ v.value()), std::memory_order_relaxed);
    });
  for (std::size_t i = 0; i < made.size(); ++i) signatures[made[i]] = mix64(key + i);
}

}  // namespace quarry
