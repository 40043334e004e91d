// What searches for patches remember, so that no stage of growth is looked at twice where nothing has
// changed: neighbouring seeds grow into the same patches, and each size class begins with those of the last.
//
// Every face has a signature, a random word that changes whenever a patch changes the face or the number of
// faces at one of its corners. The sum over the faces of a patch names the patch with all that the search for
// a fill depends on. Memory only spares work: what is known to fail would fail again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/mesh/mesh.hpp"

namespace quarry {

// The face tag (uint64) of the signatures.
inline constexpr const char* kSignatureTag = "patch_signature";

// A set of words that are as good as random, none of them 0.
class KeySet {
 public:
  [[nodiscard]] bool contains(std::uint64_t key) const {
    if (slots_.empty()) return false;
    std::size_t at = key & (slots_.size() - 1);
    while (slots_[at] != 0 && slots_[at] != key) at = (at + 1) & (slots_.size() - 1);
    return slots_[at] == key;
  }
  void insert(std::uint64_t key);
  void clear();

 private:
  void place(std::uint64_t key);

  std::vector<std::uint64_t> slots_;  // a power of two, at least half of them 0
  std::size_t count_ = 0;
};

class PatchMemory {
 public:
  // Gives all faces of the mesh a signature, if they have none. To be called again for the mesh that is
  // renumbered, or has other tags.
  void attach(Mesh& mesh);

  [[nodiscard]] std::uint64_t signature(FaceId f) const { return signatures_[f]; }
  // After a commit: new signatures for the faces that it made, and for those around the rim outside. key: of
  // the patch that was there. Called at the same time for patches that share no vertex.
  void renew(const Mesh& mesh, std::span<const FaceId> made, std::span<const VertexId> rim,
             std::uint64_t key);

  // Keys of what is known to fail.
  [[nodiscard]] bool knows(std::uint64_t key) const { return failed_.contains(key); }
  void learn(std::span<const std::uint64_t> keys) {
    for (const std::uint64_t key : keys) failed_.insert(key);
  }
  // Patches that were judged not good enough after smoothing.
  [[nodiscard]] bool is_refused(std::uint64_t key) const { return refused_.contains(key); }
  void refuse(std::uint64_t key) { refused_.insert(key); }

 private:
  Tag<FaceId, std::uint64_t> signatures_;
  KeySet failed_, refused_;
};

}  // namespace quarry
