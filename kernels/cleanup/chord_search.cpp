#include "kernels/cleanup/chord_search.hpp"

#include <algorithm>
#include <cmath>

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

}  // namespace

std::optional<double> ChordSearch::gain(const ChordSet& set, double least_gain, ChordReject& reason) {
  gather(set);
  reason = ChordReject::kLines;
  if (!keeps_lines()) return std::nullopt;
  gather_sectors(false);
  const double gain = energy_fall();
  reason = ChordReject::kNoGain;
  if (!(gain > 0) || gain < least_gain * static_cast<double>(faces_.size())) return std::nullopt;
  return gain;
}

std::optional<ChordProposal> ChordSearch::propose(const ChordSet& set, double least_gain,
                                                  ChordReject& reason) {
  const std::optional<double> gained = gain(set, least_gain, reason);
  if (!gained) return std::nullopt;
  gather_sectors(true);
  ChordProposal proposal;
  if (!gather_beside(proposal, reason)) return std::nullopt;
  proposal.crossed = faces_;
  proposal.gain = *gained;
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
  const auto add_rung = [&](SideId s) {
    const std::uint32_t a = number(mesh_->origin(s));
    const std::uint32_t b = number(mesh_->target(s));
    ++vertices_[a].rungs;
    ++vertices_[b].rungs;
    rungs_.push_back({s, a, b});
  };
  for (const std::uint32_t chord : set.chords) {
    if (chord == Chords::kNone) continue;
    chords_->for_each_face(chord, [&](SideId s) {
      if (crossed_.insert(stamped_key(s.face())).is_new) faces_.push_back(s.face());
      const SideId t = Chords::opposite(s);
      add_rung(s);
      if (!mesh_->neighbour(t).valid()) add_rung(t);
    });
  }
  for (const auto& [s, a, b] : rungs_) {
    vertices_[root_of(vertices_, &Vertex::group, b)].group = root_of(vertices_, &Vertex::group, a);
    if (tags_.constrained(s))
      vertices_[root_of(vertices_, &Vertex::line, b)].line = root_of(vertices_, &Vertex::line, a);
  }
}

// Two sectors without charge that only one rung joins, which are most, change nothing: they are left out
// unless all are asked for.
void ChordSearch::gather_sectors(bool all) {
  sector_numbers_.clear(4 * faces_.size());
  sectors_.clear();
  for (const auto& [s, a, b] : rungs_) {
    const bool alone = vertices_[a].rungs == 1 && vertices_[b].rungs == 1;
    join_along(s, all || !alone);
    if (const SideId t = mesh_->neighbour(s); t.valid()) join_along(t, all || !alone);
  }
}

void ChordSearch::join_along(SideId s, bool all) {
  const SideId next = mesh_->next(s);
  if (all || (*charges_)[s] != 0 || (*charges_)[next] != 0) join_sectors(s, next);
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
  const SideId first = first_side(s);
  const auto [number, is_new] = sector_numbers_.insert(first.value());
  if (is_new) {
    const VertexId v = mesh_->origin(s);
    number = static_cast<std::uint32_t>(sectors_.size());
    const int charge = (*charges_)[s];
    sectors_.push_back({v, first, number, charge, energy_at(v, charge), 0, !is_held(*mesh_, tags_, v)});
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

double ChordSearch::energy_fall() {
  double fall = 0;
  for (std::uint32_t i = 0; i < sectors_.size(); ++i) {
    const Sector& sector = sectors_[i];
    if (sector.parent != i) continue;
    fall += sector.energy - energy_at(kept(sector.vertex), sector.charge);
  }
  return fall;
}

bool ChordSearch::gather_beside(ChordProposal& proposal, ChordReject& reason) {
  reason = ChordReject::kNotWhole;
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
  reason = ChordReject::kFewFaces;
  return fill_sectors();
}

// Whether the faces that are left in each sector can have corners of less than a half turn. Lines keep their
// directions at the vertex that is kept.
bool ChordSearch::fill_sectors() {
  for (std::uint32_t i = 0; i < sectors_.size(); ++i) {
    const Sector& root = sectors_[root_of(sectors_, &Sector::parent, i)];
    if (root.faces < (root.inside ? kLeastFacesInside : 1)) return false;
    const VertexId v = sectors_[i].vertex;
    if (root.faces == 1 && kept(v) == v && !one_fills(sectors_[i].first)) return false;
  }
  return true;
}

// Whether one face can fill the sector of a vertex on lines.
bool ChordSearch::one_fills(SideId first) const {
  constexpr double kLeastSine = 1e-6;  // far below what is judged good enough
  const VertexId v = mesh_->origin(first);
  if (!tags_.support[v].is_fixed()) return false;
  SideId last = mesh_->previous(first);
  while (!tags_.constrained(last) && mesh_->neighbour(last).valid())
    last = mesh_->previous(mesh_->neighbour(last));
  const Vec2 right = mesh_->point(mesh_->target(first)) - mesh_->point(v);
  const Vec2 left = mesh_->point(mesh_->origin(last)) - mesh_->point(v);
  return cross(right, left) > kLeastSine * std::sqrt(dot(right, right) * dot(left, left));
}

bool ChordSearch::write_fresh(FaceId f, ChordProposal& proposal) {
  const int corners = mesh_->corner_count(f);
  FaceCorners fresh{};
  SectorCharges::OfFace charges{};
  std::uint8_t bits = 0;
  for (int k = 0; k < corners; ++k) {
    charges[static_cast<std::size_t>(k)] = SectorCharges::stored(charge_after(SideId(f, k)));
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
  proposal.charges.push_back(charges);
  return true;
}

// Sectors that become one have the sum of their charges; what no chord touches keeps its own.
int ChordSearch::charge_after(SideId s) {
  const std::uint32_t* sector = sector_numbers_.find(first_side(s).value());
  return sector != nullptr ? sectors_[root_of(sectors_, &Sector::parent, *sector)].charge : (*charges_)[s];
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
