#include "kernels/cleanup/chord_collapse.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <optional>

#include "engine/base/stopwatch.hpp"
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
  ChordCollapse(Mesh& mesh, const ChordOptions& options, const std::function<SectorCharges()>& find_charges)
      : mesh_(mesh),
        options_(options),
        find_charges_(find_charges),
        faces_(mesh.count_alive_faces()),
        balance_(mesh) {}

  ChordReport run(const Progress& progress) {
    const Stopwatch watch;
    const std::size_t wanted = options_.wanted_faces > 0 ? options_.wanted_faces : faces_;
    fewest_ = (1 - options_.most_shrinkage) * static_cast<double>(wanted);
    for (int round = 0; round < options_.most_rounds; ++round) {
      progress.throw_if_cancelled();
      if (!run_round(progress)) break;
    }
    report_.seconds = watch.seconds();
    return report_;
  }

 private:
  // False if no chord went.
  bool run_round(const Progress& progress);
  void search(const Chords& chords, const SectorCharges& charges);
  void choose(std::vector<std::optional<ChordProposal>>& found);

  Mesh& mesh_;
  const ChordOptions& options_;
  const std::function<SectorCharges()>& find_charges_;
  std::size_t faces_;
  double fewest_ = 0;
  std::vector<ChordProposal> proposals_;
  KeySet refused_;  // sets that cannot collapse, gain nothing or were judged not good enough
  ChordReport report_;
  BalanceGuard balance_;
};

bool ChordCollapse::run_round(const Progress& progress) {
  const SectorCharges charges = find_charges_();
  const Chords chords(mesh_, ConstraintTags::of(mesh_));
  if (report_.rounds++ == 0) {
    report_.chords = chords.count();
    for (std::uint32_t i = 0; i < chords.count(); ++i) report_.collapsible += chords[i].collapsible ? 1 : 0;
  }
  search(chords, charges);
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
  for (std::uint32_t i = 0; i < proposals_.size(); ++i) {
    if (!operation.won(i)) {
      report_.reject(ChordReject::kQuality);
      refused_.insert(proposals_[i].key);
      continue;
    }
    ++report_.won;
    report_.faces += proposals_[i].crossed.size();
    report_.gained += proposals_[i].gain;
    faces_ -= proposals_[i].crossed.size();
  }
  return report_.won > won_before;
}

void ChordCollapse::search(const Chords& chords, const SectorCharges& charges) {
  const ConstraintTags tags = ConstraintTags::of(mesh_);
  std::vector<ChordSet> sets = find_chord_sets(mesh_, tags, chords, charges);
  std::erase_if(sets, [&](const ChordSet& set) { return refused_.contains(key_of(set, chords)); });
  report_.sets += sets.size();
  ScratchPool<ChordSearch> searches(
      [&] { return std::make_unique<ChordSearch>(mesh_, tags, chords, charges, options_.price); });
  const double least_gain = options_.least_gain / std::sqrt(static_cast<double>(faces_));
  std::vector<std::optional<ChordProposal>> found(sets.size());
  std::vector<ChordReject> reasons(sets.size());
  parallel::for_each_chunk(sets.size(), kSearchChunk, [&](std::size_t begin, std::size_t end) {
    const ScratchPool<ChordSearch>::Loan search(searches);
    for (std::size_t i = begin; i < end; ++i) found[i] = search->find(sets[i], least_gain, reasons[i]);
  });
  for (std::size_t i = 0; i < sets.size(); ++i) {
    if (found[i]) continue;
    report_.reject(reasons[i]);
    refused_.insert(key_of(sets[i], chords));
  }
  choose(found);
}

// Those that gain most for their faces first, as far as they share no vertex.
void ChordCollapse::choose(std::vector<std::optional<ChordProposal>>& found) {
  proposals_.clear();
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < found.size(); ++i)
    if (found[i]) order.push_back(i);
  const auto worth = [&](std::uint32_t i) {
    return found[i]->gain / static_cast<double>(found[i]->crossed.size());
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return worth(a) > worth(b); });
  std::vector<std::uint8_t> taken(mesh_.vertex_slots(), 0);
  double left = static_cast<double>(faces_);
  for (const std::uint32_t i : order) {
    ChordProposal& proposal = *found[i];
    const auto for_each_vertex = [&](const auto& visit) {
      for (const auto* faces : {&proposal.beside, &proposal.crossed})
        for (const FaceId f : *faces)
          for (int k = 0; k < mesh_.corner_count(f); ++k) visit(mesh_.corner(f, k));
    };
    bool free = true;
    for_each_vertex([&](VertexId v) { free = free && taken[v.value()] == 0; });
    if (!free) {
      report_.reject(ChordReject::kOverlap);
      continue;
    }
    if (left - static_cast<double>(proposal.crossed.size()) < fewest_) {
      report_.reject(ChordReject::kFaceBand);
      continue;
    }
    left -= static_cast<double>(proposal.crossed.size());
    for_each_vertex([&](VertexId v) { taken[v.value()] = 1; });
    ++report_.tried;
    proposals_.push_back(std::move(proposal));
  }
}

}  // namespace

ChordReport collapse_chords(Mesh& mesh, const ChordOptions& options,
                            const std::function<SectorCharges()>& find_charges, const Progress& progress) {
  return ChordCollapse(mesh, options, find_charges).run(progress);
}

}  // namespace quarry
