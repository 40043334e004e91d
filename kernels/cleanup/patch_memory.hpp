// What searches for patches remember, so that no stage of growth is looked at twice where nothing has
// changed: neighbouring seeds grow into the same patches, and each size class begins with those of the last.
//
// Every face has a signature, a random word that changes whenever a patch changes the face or the number of
// faces at one of its corners. The sum over the faces of a patch names the patch with all that the search for
// a fill depends on. Memory only spares work: what is known to fail would fail again.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/mesh/mesh.hpp"

namespace quarry {

// The face tag (uint64) of the signatures.
inline constexpr const char* kSignatureTag = "patch_signature";

// A set of words that are as good as random. It keeps 40 bits of each: of ten million words one lookup in a
// hundred thousand mistakes another for one of them.
class KeySet {
 public:
  [[nodiscard]] bool contains(std::uint64_t key) const { return !low_.empty() && holds(place_of(Word(key))); }
  void insert(std::uint64_t key);
  void clear();  // keeps its memory

 private:
  struct Word {
    // No word is 0, which is an empty place.
    explicit Word(std::uint64_t key)
        : low(static_cast<std::uint32_t>(key)), high(static_cast<std::uint8_t>(key >> 32)) {
      if (low == 0 && high == 0) low = 1;
    }
    Word(std::uint32_t low_bits, std::uint8_t high_bits) : low(low_bits), high(high_bits) {}

    std::uint32_t low;
    std::uint8_t high;
  };
  [[nodiscard]] bool holds(std::size_t place) const { return low_[place] != 0 || high_[place] != 0; }
  // Where the word is, or would be put.
  [[nodiscard]] std::size_t place_of(Word word) const {
    const std::size_t mask = low_.size() - 1;
    std::size_t at = word.low & mask;
    while (holds(at) && (low_[at] != word.low || high_[at] != word.high)) at = (at + 1) & mask;
    return at;
  }
  void put(Word word);

  // A power of two of places, at least a quarter of them empty.
  std::vector<std::uint32_t> low_;
  std::vector<std::uint8_t> high_;
  std::size_t count_ = 0;
};

// The same in parts by the first bits of a key, so that many can be put in at once.
class KeyParts {
 public:
  [[nodiscard]] bool contains(std::uint64_t key) const { return parts_[part_of(key)].contains(key); }
  void insert(std::uint64_t key) { parts_[part_of(key)].insert(key); }
  void insert(std::span<const std::uint64_t> keys);

 private:
  static constexpr int kBits = 5;
  static std::size_t part_of(std::uint64_t key) { return static_cast<std::size_t>(key >> (64 - kBits)); }
  std::array<KeySet, std::size_t{1} << kBits> parts_;
};

// What searches found out, as keys.
struct PatchFailures {
  std::vector<std::uint64_t> stages;   // patches without a fill that gains
  std::vector<std::uint64_t> courses;  // patches, ways of growth and classes that lead to none
};

class PatchMemory {
 public:
  // To be called at the start of each size class, for the mesh as it is numbered then. Gives all faces a
  // signature, if they have none, and forgets the courses, which are those of one class.
  void begin_class(Mesh& mesh);

  [[nodiscard]] std::uint64_t signature(FaceId f) const { return signatures_[f]; }
  // After a commit: new signatures for the faces that it made, and for those around the rim outside. key: of
  // the patch that was there. Called at the same time for patches that share no vertex.
  void renew(const Mesh& mesh, std::span<const FaceId> made, std::span<const VertexId> rim,
             std::uint64_t key);

  [[nodiscard]] bool knows_stage(std::uint64_t key) const { return stages_.contains(key); }
  [[nodiscard]] bool knows_course(std::uint64_t key) const { return courses_.contains(key); }
  void learn(const PatchFailures& failures) {
    stages_.insert(failures.stages);
    courses_.insert(failures.courses);
  }
  // Patches that were judged not good enough after smoothing.
  [[nodiscard]] bool is_refused(std::uint64_t key) const { return refused_.contains(key); }
  void refuse(std::uint64_t key) { refused_.insert(key); }

 private:
  Tag<FaceId, std::uint64_t> signatures_;
  KeyParts stages_, courses_, refused_;
};

}  // namespace quarry
