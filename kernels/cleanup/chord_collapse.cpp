#include "kernels/cleanup/chord_collapse.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>

#include "engine/mesh/balance.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/cleanup/chord_commit.hpp"
#include "kernels/cleanup/patch_memory.hpp"

namespace quarry {
namespace {

// Sets a chunk: each walks some hundred faces.
constexpr std::size_t kSearchChunk = 16;

class ChordCollapse {
 public:
  ChordCollapse(Mesh& mesh, SectorCharges charges, const ChordOptions& options)
      : mesh_(mesh),
        charges_(std::move(charges)),
        options_(options),
        faces_(mesh.count_alive_faces()),
        balance_(mesh) {}

  ChordReport run(const Progress& progress) {
    const std::size_t wanted = options_.wanted_faces > 0 ? options_.wanted_faces : faces_;
    fewest_ = (1 - options_.most_shrinkage) * static_cast<double>(wanted);
    for (int round = 0; round < options_.most_rounds; ++round) {
      progress.throw_if_cancelled();
      if (!run_round(progress)) break;
    }
    return report_;
  }

 private:
  struct Gain {
    std::uint64_t key = 0;  // of the set
    double energy = 0;
    std::size_t faces = 0;
    [[nodiscard]] double worth() const { return energy / static_cast<double>(faces); }
  };

  // False if no chord went.
  bool run_round(const Progress& progress);
  void search(const Chords& chords);
  void keep_shortest(const Chords& chords, std::vector<ChordSet>& sets);
  // Of a set that the last round looked at; none of others.
  [[nodiscard]] std::optional<Gain> recall(std::uint64_t key) const;
  void choose(const Chords& chords, ChordSearch& search, const std::vector<ChordSet>& sets,
              const std::vector<std::optional<Gain>>& gains);
  [[nodiscard]] bool is_free(const Chords& chords, const ChordSet& set) const;
  [[nodiscard]] bool take(const ChordProposal& proposal);
  void count(const ChordCommit& operation);

  Mesh& mesh_;
  SectorCharges charges_;  // of the mesh as it is now
  const ChordOptions& options_;
  std::size_t faces_;
  double fewest_ = 0;
  double least_gain_ = 0;  // for each face
  std::vector<ChordProposal> proposals_;
  std::vector<Gain> known_;          // of the sets of the last round, by rising key
  std::vector<std::uint64_t> keys_;  // of the proposals
  std::vector<std::uint8_t> taken_;  // by vertex: of a face of a proposal
  KeySet refused_;                   // sets that cannot collapse, gain nothing or were judged not good enough
  ChordReport report_;
  BalanceGuard balance_;
};

bool ChordCollapse::run_round(const Progress& progress) {
  const Chords chords(mesh_, ConstraintTags::of(mesh_));
  if (report_.rounds++ == 0) {
    report_.chords = chords.count();
    for (std::uint32_t i = 0; i < chords.count(); ++i) report_.collapsible += chords[i].collapsible ? 1 : 0;
  }
  search(chords);
  if (proposals_.empty()) return false;
  const ChordCommit operation(mesh_, options_, proposals_);
  std::vector<std::uint32_t> work(proposals_.size());
  std::iota(work.begin(), work.end(), 0U);
  PassOptions pass;
  pass.window = work.size();
  pass.cutoff = 1;
  pass.chunk = 1;
  report_.commits.add(run_pass(mesh_, operation, std::move(work), pass, progress));
  balance_.check("collapse of chords", mesh_, GeometryCheck::kNone);
  const std::uint64_t won_before = report_.won;
  count(operation);
  return report_.won > won_before;
}

void ChordCollapse::search(const Chords& chords) {
  const ConstraintTags tags = ConstraintTags::of(mesh_);
  std::vector<ChordSet> sets = find_chord_sets(mesh_, tags, chords, charges_);
  std::erase_if(sets, [&](const ChordSet& set) { return refused_.contains(key_of(set, chords)); });
  keep_shortest(chords, sets);
  report_.sets += sets.size();
  ScratchPool<ChordSearch> searches(
      [&] { return std::make_unique<ChordSearch>(mesh_, tags, chords, charges_, options_.price); });
  least_gain_ = options_.least_gain / std::sqrt(static_cast<double>(faces_));
  std::vector<std::optional<Gain>> gains(sets.size());
  std::vector<ChordReject> reasons(sets.size());
  parallel::for_each_chunk(sets.size(), kSearchChunk, [&](std::size_t begin, std::size_t end) {
    const ScratchPool<ChordSearch>::Loan search(searches);
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint64_t key = key_of(sets[i], chords);
      gains[i] = recall(key);
      if (gains[i]) continue;
      if (const auto gain = search->gain(sets[i], least_gain_, reasons[i]))
        gains[i] = {key, *gain, search->count_crossed()};
    }
  });
  for (std::size_t i = 0; i < sets.size(); ++i) {
    if (gains[i]) continue;
    report_.reject(reasons[i]);
    refused_.insert(key_of(sets[i], chords));
  }
  const ScratchPool<ChordSearch>::Loan search(searches);
  choose(chords, *search, sets, gains);
  known_.clear();
  for (const std::optional<Gain>& gain : gains)
    if (gain) known_.push_back(*gain);
  std::sort(known_.begin(), known_.end(), [](const Gain& a, const Gain& b) { return a.key < b.key; });
}

void ChordCollapse::keep_shortest(const Chords& chords, std::vector<ChordSet>& sets) {
  const auto length = [&](const ChordSet& set) {
    std::size_t faces = 0;
    for (const std::uint32_t chord : set.chords)
      if (chord != Chords::kNone) faces += chords[chord].faces;
    return faces;
  };
  std::stable_sort(sets.begin(), sets.end(),
                   [&](const ChordSet& a, const ChordSet& b) { return length(a) < length(b); });
  double left = options_.most_walked * static_cast<double>(faces_);
  const auto rest = std::find_if(sets.begin(), sets.end(), [&](const ChordSet& set) {
    left -= static_cast<double>(length(set));
    return left < 0;
  });
  report_.reject(ChordReject::kLong, static_cast<std::uint64_t>(sets.end() - rest));
  sets.erase(rest, sets.end());
}

std::optional<ChordCollapse::Gain> ChordCollapse::recall(std::uint64_t key) const {
  const auto found = std::lower_bound(known_.begin(), known_.end(), key,
                                      [](const Gain& gain, std::uint64_t k) { return gain.key < k; });
  if (found == known_.end() || found->key != key) return std::nullopt;
  return *found;
}

// Those that gain most for their faces first, as far as they share no vertex. What was known of a set may
// have changed by a collapse beside it: its proposal is looked at anew.
void ChordCollapse::choose(const Chords& chords, ChordSearch& search, const std::vector<ChordSet>& sets,
                           const std::vector<std::optional<Gain>>& gains) {
  proposals_.clear();
  keys_.clear();
  taken_.assign(mesh_.vertex_slots(), 0);
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < sets.size(); ++i)
    if (gains[i]) order.push_back(i);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return gains[a]->worth() > gains[b]->worth(); });
  double left = static_cast<double>(faces_);
  for (const std::uint32_t i : order) {
    const auto gone = static_cast<double>(gains[i]->faces);
    if (!is_free(chords, sets[i])) {
      report_.reject(ChordReject::kOverlap);
      continue;
    }
    if (left - gone < fewest_) {
      report_.reject(ChordReject::kFaceBand);
      continue;
    }
    ChordReject reason{};
    std::optional<ChordProposal> proposal = search.propose(sets[i], least_gain_, reason);
    if (!proposal) {
      report_.reject(reason);
      refused_.insert(gains[i]->key);
      continue;
    }
    if (!take(*proposal)) {
      report_.reject(ChordReject::kOverlap);
      continue;
    }
    left -= gone;
    ++report_.tried;
    proposals_.push_back(std::move(*proposal));
    keys_.push_back(gains[i]->key);
  }
}

// Before the faces beside a set are gathered: most are given up here.
bool ChordCollapse::is_free(const Chords& chords, const ChordSet& set) const {
  bool free = true;
  for (const std::uint32_t chord : set.chords) {
    if (chord == Chords::kNone || !free) continue;
    chords.for_each_face(chord, [&](SideId s) {
      for (int k = 0; k < 4; ++k) free = free && taken_[mesh_.corner(s.face(), k).value()] == 0;
    });
  }
  return free;
}

// False if a vertex of its faces is taken; else takes them all.
bool ChordCollapse::take(const ChordProposal& proposal) {
  const auto for_each_vertex = [&](const auto& visit) {
    for (const auto* faces : {&proposal.beside, &proposal.crossed})
      for (const FaceId f : *faces)
        for (int k = 0; k < mesh_.corner_count(f); ++k) visit(mesh_.corner(f, k).value());
  };
  bool free = true;
  for_each_vertex([&](std::uint32_t v) { free = free && taken_[v] == 0; });
  if (free) for_each_vertex([&](std::uint32_t v) { taken_[v] = 1; });
  return free;
}

void ChordCollapse::count(const ChordCommit& operation) {
  for (std::uint32_t i = 0; i < proposals_.size(); ++i) {
    const ChordProposal& proposal = proposals_[i];
    if (!operation.won(i)) {
      report_.reject(ChordReject::kQuality);
      refused_.insert(keys_[i]);
      continue;
    }
    ++report_.won;
    report_.faces += proposal.crossed.size();
    report_.gained += proposal.gain;
    faces_ -= proposal.crossed.size();
    for (std::size_t k = 0; k < proposal.beside.size(); ++k)
      charges_.set(proposal.beside[k], proposal.charges[k]);
  }
}

}  // namespace

ChordReport collapse_chords(Mesh& mesh, SectorCharges charges, const ChordOptions& options,
                            const Progress& progress) {
  return ChordCollapse(mesh, std::move(charges), options).run(progress);
}

}  // namespace quarry
