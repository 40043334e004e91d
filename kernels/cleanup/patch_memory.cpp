#include "kernels/cleanup/patch_memory.hpp"

#include <algorithm>
#include <atomic>
#include <utility>

#include "engine/base/random.hpp"
#include "engine/parallel/parallel.hpp"

namespace quarry {

void KeySet::put(Word word) {
  const std::size_t at = place_of(word);
  low_[at] = word.low;
  high_[at] = word.high;
}

void KeySet::insert(std::uint64_t key) {
  if (contains(key)) return;
  if (4 * (count_ + 1) > 3 * low_.size()) {
    constexpr std::size_t kFirst = 64;
    const std::size_t places = std::max(kFirst, 2 * low_.size());
    const std::vector<std::uint32_t> low = std::exchange(low_, std::vector<std::uint32_t>(places, 0));
    const std::vector<std::uint8_t> high = std::exchange(high_, std::vector<std::uint8_t>(places, 0));
    for (std::size_t i = 0; i < low.size(); ++i)
      if (low[i] != 0 || high[i] != 0) put(Word(low[i], high[i]));
  }
  ++count_;
  put(Word(key));
}

void KeySet::clear() {
  if (count_ > 0) {
    std::fill(low_.begin(), low_.end(), 0);
    std::fill(high_.begin(), high_.end(), std::uint8_t{0});
  }
  count_ = 0;
}

void KeyParts::insert(std::span<const std::uint64_t> keys) {
  // Every part reads the list once: cheap beside where its own keys are put.
  parallel::for_each(
      parts_.size(),
      [&](std::size_t part) {
        for (const std::uint64_t key : keys)
          if (part_of(key) == part) parts_[part].insert(key);
      },
      1);
}

void PatchMemory::begin_class(Mesh& mesh) {
  courses_ = KeyParts();
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
