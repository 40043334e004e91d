#include "kernels/cleanup/chord_sets.hpp"

#include <algorithm>
#include <initializer_list>

#include "engine/base/random.hpp"
#include "engine/parallel/parallel.hpp"

namespace quarry {
namespace {

class SetFinder {
 public:
  SetFinder(const Mesh& mesh, const ConstraintTags& tags, const Chords& chords, const SectorCharges& charges)
      : mesh_(mesh), tags_(tags), chords_(chords), charges_(charges) {}

  void look(FaceId f, std::vector<ChordSet>& found) const {
    for (int k = 0; k < 4; ++k) {
      const SideId s(f, k);
      const SideId next(f, (k + 1) % 4);
      if (opposite(s, next)) add({chords_.across(s)}, found);
      if (opposite(s, SideId(f, (k + 2) % 4))) add({chords_.across(s), chords_.across(next)}, found);
      const SideId t = mesh_.neighbour(s);
      if (!t.valid() || tags_.constrained(s) || t < s || mesh_.corner_count(t.face()) != 4) continue;
      look_across(s, t, found);
    }
  }

 private:
  // Two faces side by side, and their corners away from the edge between them.
  void look_across(SideId s, SideId t, std::vector<ChordSet>& found) const {
    const SideId a = mesh_.previous(s);
    const SideId b = Chords::opposite(s);
    const SideId c = mesh_.previous(t);
    const SideId d = Chords::opposite(t);
    const std::uint32_t here = chords_.across(a);
    const std::uint32_t there = chords_.across(c);
    if (opposite(a, d) || opposite(b, c)) add({here, there}, found);
    if (opposite(a, c) || opposite(b, d)) add({here, there, chords_.across(s)}, found);
  }

  [[nodiscard]] bool opposite(SideId a, SideId b) const { return charges_[a] * charges_[b] < 0; }

  void add(std::initializer_list<std::uint32_t> chords, std::vector<ChordSet>& found) const {
    ChordSet set;
    std::copy(chords.begin(), chords.end(), set.chords.begin());
    std::sort(set.chords.begin(), set.chords.end());
    std::fill(std::unique(set.chords.begin(), set.chords.end()), set.chords.end(), Chords::kNone);
    for (const std::uint32_t chord : set.chords)
      if (chord != Chords::kNone && !chords_[chord].collapsible) return;
    found.push_back(set);
  }

  const Mesh& mesh_;
  const ConstraintTags& tags_;
  const Chords& chords_;
  const SectorCharges& charges_;
};

}  // namespace

std::vector<ChordSet> find_chord_sets(const Mesh& mesh, const ConstraintTags& tags, const Chords& chords,
                                      const SectorCharges& charges) {
  const SetFinder finder(mesh, tags, chords, charges);
  std::vector<ChordSet> sets = parallel::reduce_ordered(
      mesh.face_slots(), std::vector<ChordSet>(),
      [&](std::size_t begin, std::size_t end) {
        std::vector<ChordSet> found;
        for (std::size_t i = begin; i < end; ++i)
          if (mesh.alive(FaceId(i)) && mesh.corner_count(FaceId(i)) == 4) finder.look(FaceId(i), found);
        return found;
      },
      [](std::vector<ChordSet> all, const std::vector<ChordSet>& part) {
        all.insert(all.end(), part.begin(), part.end());
        return all;
      });
  std::sort(sets.begin(), sets.end());
  sets.erase(std::unique(sets.begin(), sets.end()), sets.end());
  return sets;
}

std::uint64_t key_of(const ChordSet& set, const Chords& chords) {
  std::uint64_t key = 0;
  for (const std::uint32_t chord : set.chords)
    if (chord != Chords::kNone) key += mix64(chords[chord].signature);
  return key;
}

}  // namespace quarry
