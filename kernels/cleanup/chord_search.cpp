#include "kernels/cleanup/chord_search.hpp"

#include <algorithm>

#include "engine/base/random.hpp"
#include "engine/parallel/parallel.hpp"

namespace quarry {
namespace {

constexpr int kLeastFacesInside = 3;

template <class Node>
std::uint32_t root_of(std::vector<Node>& nodes, std::uint32_t Node::*parent, std::uint32_t i) {
  while (nodes[i].*parent != i) {
    nodes[i].*parent = nodes[nodes[i].*parent].*parent;
    i = nodes[i].*parent;
  }
  return i;
}

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

std::optional<ChordProposal> ChordSearch::find(const ChordSet& set, double least_gain, ChordReject& reason) {
  const auto reject = [&](ChordReject why) {
    reason = why;
    return std::nullopt;
  };
  gather(set);
  if (!keeps_lines()) return reject(ChordReject::kLines);
  ChordProposal proposal;
  gather_sectors(set);
  proposal.gain = gain();
  if (!(proposal.gain > 0) || proposal.gain < least_gain * static_cast<double>(faces_.size()))
    return reject(ChordReject::kNoGain);
  if (!gather_beside(proposal)) return reject(ChordReject::kNotWhole);
  proposal.crossed = faces_;
  proposal.key = key_of(set, *chords_);
  return proposal;
}

// The faces and rungs of the chords, with what becomes one along them.
void ChordSearch::gather(const ChordSet& set) {
  std::size_t most = 0;
  for (const std::uint32_t chord : set.chords)
    if (chord != Chords::kNone) most += (*chords_)[chord].faces;
  crossed_.clear(most);
  numbers_.clear(2 * most + 4);
  rungs_.clear();
  faces_.clear();
  vertices_.clear();
  for (const std::uint32_t chord : set.chords) {
    if (chord == Chords::kNone) continue;
    chords_->for_each_face(chord, [&](SideId s) {
      if (crossed_.insert(stamped_key(s.face())).is_new) faces_.push_back(s.face());
      const SideId t = Chords::opposite(s);
      rungs_.push_back(s);
      if (!mesh_->neighbour(t).valid()) rungs_.push_back(t);
    });
  }
  for (const SideId s : rungs_) {
    const std::uint32_t a = number(mesh_->origin(s));
    const std::uint32_t b = number(mesh_->target(s));
    vertices_[root_of(vertices_, &Vertex::group, b)].group = root_of(vertices_, &Vertex::group, a);
    if (tags_.constrained(s) || !mesh_->neighbour(s).valid())
      vertices_[root_of(vertices_, &Vertex::line, b)].line = root_of(vertices_, &Vertex::line, a);
  }
}

void ChordSearch::gather_sectors(const ChordSet& set) {
  sector_numbers_.clear(4 * faces_.size());
  sectors_.clear();
  for (const std::uint32_t chord : set.chords) {
    if (chord == Chords::kNone) continue;
    chords_->for_each_face(chord, [&](SideId s) {
      const SideId t = Chords::opposite(s);
      join_sectors(s, mesh_->next(s));
      join_sectors(t, mesh_->next(t));
    });
  }
}

std::uint32_t ChordSearch::number(VertexId v) {
  const auto [i, is_new] = numbers_.number(v);
  if (is_new) vertices_.push_back({v, i, i, Chords::kNone, VertexId()});
  return i;
}

// The side that a sector is named by: its most clockwise one, and where no line bounds it side_of().
SideId ChordSearch::first_side(SideId s) const {
  SideId first = s;
  while (!tags_.constrained(first) && mesh_->neighbour(first).valid()) {
    first = mesh_->turn_right(first);
    if (first == s) return mesh_->side_of(mesh_->origin(s));
  }
  return first;
}

std::uint32_t ChordSearch::sector_of(SideId s) {
  const auto [number, is_new] = sector_numbers_.insert(first_side(s).value());
  if (is_new) {
    const VertexId v = mesh_->origin(s);
    number = static_cast<std::uint32_t>(sectors_.size());
    const int charge = (*charges_)[s];
    sectors_.push_back({v, number, charge, price_at(v) * charge * charge, 0, !is_held(*mesh_, tags_, v)});
  }
  return number;
}

void ChordSearch::join_sectors(SideId a, SideId b) {
  const std::uint32_t to = root_of(sectors_, &Sector::parent, sector_of(a));
  const std::uint32_t from = root_of(sectors_, &Sector::parent, sector_of(b));
  if (to == from) return;
  Sector& all = sectors_[to];
  const Sector& other = sectors_[from];
  all.charge += other.charge;
  all.energy += other.energy;
  all.inside = all.inside && other.inside;
  sectors_[from].parent = to;
}

// Each group has at most one fixed vertex, and what of it lies on lines becomes one along them. Names who is
// kept: a fixed vertex, or one on a line, or any.
bool ChordSearch::keeps_lines() {
  for (std::uint32_t i = 0; i < vertices_.size(); ++i) {
    const VertexId v = vertices_[i].vertex;
    Vertex& root = vertices_[root_of(vertices_, &Vertex::group, i)];
    const bool fixed = tags_.support[v].is_fixed();
    if (is_held(*mesh_, tags_, v)) {
      const std::uint32_t line = root_of(vertices_, &Vertex::line, i);
      if (root.held == Chords::kNone) {
        root.held = line;
        root.kept = v;
      }
      if (root.held != line) return false;
      const bool kept_is_fixed = tags_.support[root.kept].is_fixed();
      if (fixed && kept_is_fixed && root.kept != v) return false;
      if (fixed || (!kept_is_fixed && v < root.kept)) root.kept = v;
    } else if (root.held == Chords::kNone && (!root.kept.valid() || v < root.kept)) {
      root.kept = v;
    }
  }
  return true;
}

VertexId ChordSearch::kept(VertexId v) {
  const std::uint32_t before = numbers_.count();
  const auto [i, is_new] = numbers_.number(v);
  if (is_new) {
    vertices_.push_back({v, before, before, Chords::kNone, v});
    return v;
  }
  return vertices_[root_of(vertices_, &Vertex::group, i)].kept;
}

double ChordSearch::gain() {
  double gain = 0;
  for (std::uint32_t i = 0; i < sectors_.size(); ++i) {
    const Sector& sector = sectors_[i];
    if (sector.parent != i) continue;
    gain += sector.energy - price_at(kept(sector.vertex)) * sector.charge * sector.charge;
  }
  return gain;
}

bool ChordSearch::gather_beside(ChordProposal& proposal) {
  const std::size_t count = vertices_.size();
  std::vector<std::uint32_t> order(count);
  for (std::uint32_t i = 0; i < count; ++i) order[i] = i;
  const auto root = [&](std::uint32_t i) { return root_of(vertices_, &Vertex::group, i); };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return root(a) < root(b); });
  for (std::size_t i = 0; i < count;) {
    const std::uint32_t group = root(order[i]);
    const auto begin = static_cast<std::uint32_t>(proposal.members.size());
    for (; i < count && root(order[i]) == group; ++i) proposal.members.push_back(vertices_[order[i]].vertex);
    proposal.groups.push_back(
        {vertices_[group].kept, begin, static_cast<std::uint32_t>(proposal.members.size())});
  }
  std::size_t faces = 0;
  for (const VertexId v : proposal.members) for_each_side_around(*mesh_, v, [&](SideId) { ++faces; });
  beside_.clear(faces);
  sides_.clear(4 * faces);
  for (const VertexId v : proposal.members) {
    bool whole = true;
    for_each_side_around(*mesh_, v, [&](SideId s) {
      if (crossed(s.face())) return;
      // What no chord touches keeps its faces.
      if (const std::uint32_t* sector = sector_numbers_.find(first_side(s).value()))
        ++sectors_[root_of(sectors_, &Sector::parent, *sector)].faces;
      if (beside_.insert(stamped_key(s.face())).is_new) whole = whole && write_fresh(s.face(), proposal);
    });
    if (!whole) return false;
  }
  for (std::uint32_t i = 0; i < sectors_.size(); ++i)
    if (sectors_[i].parent == i && sectors_[i].faces < (sectors_[i].inside ? kLeastFacesInside : 1))
      return false;
  return true;
}

bool ChordSearch::write_fresh(FaceId f, ChordProposal& proposal) {
  const int corners = mesh_->corner_count(f);
  FaceCorners fresh{};
  std::uint8_t bits = 0;
  for (int k = 0; k < corners; ++k) {
    fresh[static_cast<std::size_t>(k)] = kept(mesh_->corner(f, k));
    if (constrained_past(SideId(f, k))) bits = static_cast<std::uint8_t>(bits | (1U << k));
  }
  for (int k = 0; k < corners; ++k) {
    const VertexId a = fresh[static_cast<std::size_t>(k)];
    const VertexId b = fresh[static_cast<std::size_t>((k + 1) % corners)];
    if (a == b || a == fresh[static_cast<std::size_t>((k + 2) % corners)]) return false;
    if (!sides_.insert(stamped_key(a, b)).is_new) return false;
  }
  proposal.beside.push_back(f);
  proposal.fresh.push_back(fresh);
  proposal.sides.push_back(bits);
  return true;
}

// A side beside chords becomes one with those across them.
bool ChordSearch::constrained_past(SideId s) {
  bool constrained = tags_.constrained(s);
  for (SideId t = mesh_->neighbour(s); t.valid() && crossed(t.face());) {
    const SideId out = Chords::opposite(t);
    constrained = constrained || tags_.constrained(out);
    t = mesh_->neighbour(out);
  }
  return constrained;
}

}  // namespace quarry
