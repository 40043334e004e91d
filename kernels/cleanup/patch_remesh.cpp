#include "kernels/cleanup/patch_remesh.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include "engine/base/log.hpp"
#include "engine/base/random.hpp"
#include "engine/base/stopwatch.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/cleanup/balance.hpp"
#include "kernels/cleanup/patch_commit.hpp"
#include "kernels/cleanup/patch_search.hpp"

namespace quarry {
namespace {

// Seeds a chunk: those of one learn from one another, and chunks are what runs in parallel.
constexpr std::size_t kSmallestChunk = 4, kLargestChunk = 64;
constexpr std::size_t kSearchChunks = 64;
// Commits a chunk: each smooths its patch.
constexpr std::size_t kCommitChunk = 2;
// Neighbours find patches that overlap, of which a wave commits one: each wave has every fourth seed, by lot,
// and those that are regular by then need no search.
constexpr std::uint32_t kLots = 4;
constexpr std::size_t kSmallestWave = 64;
// Seeds of a wave: what they find is held until it is committed, and is as large as the class allows.
constexpr std::size_t kLargestWave = std::size_t{1} << 15;
constexpr std::size_t kFacesHeld = std::size_t{1} << 24;

template <GeometryModel Model>
class PatchRemesher {
 public:
  PatchRemesher(Mesh& mesh, const Model& model, const PatchOptions& options, PatchMemory& memory)
      : mesh_(mesh),
        model_(model),
        options_(options),
        memory_(memory),
        stars_(mesh, options.price, options.over_lines),
        taken_(mesh.vertex_slots(), 0),
        faces_(mesh.count_alive_faces()),
        wanted_(static_cast<double>(options.wanted_faces > 0 ? options.wanted_faces : faces_)),
        searches_([this] { return std::make_unique<PatchSearch>(mesh_, stars_, memory_, options_); }) {
    report_.largest = options.largest;
    report_.over_lines = options.over_lines != nullptr;
#ifndef NDEBUG
    balance_ = balance_of(mesh, model);
#endif
  }

  PatchReport run(const Progress& progress) {
    std::vector<std::uint32_t> pending = parallel::filter_indices(
        mesh_.vertex_slots(), [&](std::size_t i) { return stars_.irregular(VertexId(i)); });
    report_.seeds = pending.size();
    if (static_cast<double>(pending.size()) * static_cast<double>(options_.largest) >
        options_.most_work * static_cast<double>(faces_))
      options_.directions = 0;
    std::stable_sort(pending.begin(), pending.end(),
                     [](std::uint32_t a, std::uint32_t b) { return mix32(a) % kLots < mix32(b) % kLots; });
    const std::size_t wave =
        std::min(std::clamp<std::size_t>(kFacesHeld / options_.largest, 16, kLargestWave),
                 std::max(kSmallestWave, pending.size() / kLots + 1));
    while (!pending.empty()) {
      progress.throw_if_cancelled();
      const std::size_t count = std::min(wave, pending.size());
      ++report_.waves;
      std::vector<std::uint32_t> again;
      search(std::span(pending).first(count), again);
      commit(progress, again);
      check();
      std::sort(again.begin(), again.end());
      again.erase(std::unique(again.begin(), again.end()), again.end());
      pending.erase(pending.begin(), pending.begin() + static_cast<std::ptrdiff_t>(count));
      pending.insert(pending.end(), again.begin(), again.end());
    }
    return report_;
  }

 private:
  void search(std::span<const std::uint32_t> seeds, std::vector<std::uint32_t>& again);
  void choose(std::vector<std::optional<PatchProposal>>& found, std::vector<std::uint32_t>& again);
  std::vector<std::uint32_t> by_worth(const std::vector<std::optional<PatchProposal>>& found);
  [[nodiscard]] bool is_free(const PatchProposal& proposal) const {
    const auto free = [&](VertexId v) { return taken_[v.value()] != report_.waves; };
    return std::all_of(proposal.rim.begin(), proposal.rim.end(), free) &&
           std::all_of(proposal.inner.begin(), proposal.inner.end(), free);
  }
  void take(const PatchProposal& proposal) {
    for (const VertexId v : proposal.rim) taken_[v.value()] = static_cast<std::uint32_t>(report_.waves);
    for (const VertexId v : proposal.inner) taken_[v.value()] = static_cast<std::uint32_t>(report_.waves);
  }
  // The irregular vertices of a patch are to be searched in the next waves.
  void queue(const PatchProposal& proposal, std::vector<std::uint32_t>& again) const {
    for (const auto* vertices : {&proposal.rim, &proposal.inner})
      for (const VertexId v : *vertices)
        if (stars_.irregular(v)) again.push_back(v.value());
  }
  void commit(const Progress& progress, std::vector<std::uint32_t>& again);
  void count_outcomes(const PatchCommit<Model>& operation);

  void check() const {
#ifndef NDEBUG
    const std::string broken = find_imbalance(mesh_, model_, balance_);
    if (!broken.empty()) log::warn("after patches of {} faces: {}", options_.largest, broken);
    assert(broken.empty());
#endif
  }

  Mesh& mesh_;
  const Model& model_;
  PatchOptions options_;
  PatchMemory& memory_;
  PatchStars stars_;
  std::vector<std::uint32_t> taken_;  // by vertex: the last wave in which a patch was chosen that has it
  std::size_t faces_;                 // alive
  double wanted_;                     // faces
  std::vector<PatchProposal> proposals_;
  Claims claims_;
  ScratchPool<PatchSearch> searches_;
  PatchReport report_;
#ifndef NDEBUG
  ModelBalance balance_;
#endif
};

template <GeometryModel Model>
void PatchRemesher<Model>::search(std::span<const std::uint32_t> seeds, std::vector<std::uint32_t>& again) {
  Stopwatch watch;
  struct Part {
    PatchReport counts;
    PatchFailures learned;
  };
  std::vector<std::optional<PatchProposal>> found(seeds.size());
  const Part all = parallel::reduce_ordered(
      seeds.size(), Part(),
      [&](std::size_t begin, std::size_t end) {
        Part part;
        const typename ScratchPool<PatchSearch>::Loan search(searches_);
        search->begin_chunk();
        for (std::size_t i = begin; i < end; ++i)
          if (stars_.irregular(VertexId(seeds[i]))) found[i] = search->find(VertexId(seeds[i]), part.counts);
        part.learned = search->learned();
        return part;
      },
      [](Part sum, const Part& part) {
        sum.counts.add(part.counts);
        const auto append = [](auto& keys, const auto& more) {
          keys.insert(keys.end(), more.begin(), more.end());
        };
        append(sum.learned.stages, part.learned.stages);
        append(sum.learned.courses, part.learned.courses);
        return sum;
      },
      std::clamp(seeds.size() / kSearchChunks, kSmallestChunk, kLargestChunk));
  memory_.learn(all.learned);
  report_.add(all.counts);
  choose(found, again);
  report_.search_seconds += watch.lap();
}

// Chooses patches that share no vertex, those that gain most for their faces first, as far as the mesh may
// still grow and shrink. What overlaps one of them is searched again, and what repeats one is dropped.
template <GeometryModel Model>
void PatchRemesher<Model>::choose(std::vector<std::optional<PatchProposal>>& found,
                                  std::vector<std::uint32_t>& again) {
  double most = static_cast<double>(faces_), fewest = most;
  proposals_.clear();
  for (const std::uint32_t i : by_worth(found)) {
    PatchProposal& proposal = *found[i];
    if (!is_free(proposal)) {
      queue(proposal, again);
      continue;
    }
    const double more =
        static_cast<double>(proposal.fresh_faces) - static_cast<double>(proposal.faces.size());
    if ((more > 0 && most + more > (1 + options_.most_growth) * wanted_) ||
        (more < 0 && fewest + more < (1 - options_.most_shrinkage) * wanted_)) {
      report_.reject(PatchReject::kFaceBand);
      continue;
    }
    (more > 0 ? most : fewest) += more;
    take(proposal);
    ++report_.proposed[static_cast<std::size_t>(proposal.fill.kind)];
    proposals_.push_back(std::move(proposal));
  }
  report_.proposals += proposals_.size();
  // Neighbours one after the other: numbers of vertices follow places, by and large.
  std::sort(proposals_.begin(), proposals_.end(),
            [](const PatchProposal& a, const PatchProposal& b) { return a.seed < b.seed; });
}

// One of each patch; the order is that of gain by faces, then of the seeds.
template <GeometryModel Model>
std::vector<std::uint32_t> PatchRemesher<Model>::by_worth(
    const std::vector<std::optional<PatchProposal>>& found) {
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < found.size(); ++i)
    if (found[i]) order.push_back(i);
  report_.found += order.size();
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return found[a]->key < found[b]->key; });
  const auto same = [&](std::uint32_t a, std::uint32_t b) { return found[a]->key == found[b]->key; };
  const std::size_t all = order.size();
  order.erase(std::unique(order.begin(), order.end(), same), order.end());
  report_.duplicates += all - order.size();
  const auto worth = [&](std::uint32_t i) {
    return found[i]->gain / static_cast<double>(found[i]->faces.size());
  };
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return worth(a) != worth(b) ? worth(a) > worth(b) : a < b;
  });
  return order;
}

template <GeometryModel Model>
void PatchRemesher<Model>::commit(const Progress& progress, std::vector<std::uint32_t>& again) {
  if (proposals_.empty()) return;
  Stopwatch watch;
  const std::size_t slots_before = mesh_.vertex_slots();
  std::size_t room = slots_before;
  for (const PatchProposal& proposal : proposals_)
    room += std::max<std::size_t>(proposal.fresh_faces, proposal.faces.size()) - proposal.faces.size();
  stars_.grow(room);
  taken_.resize(room, 0);
  const PatchCommit<Model> operation(mesh_, model_, options_, stars_, memory_, proposals_);
  std::vector<std::uint32_t> work(proposals_.size());
  std::iota(work.begin(), work.end(), 0U);
  PassOptions pass;
  pass.window = work.size();
  pass.cutoff = 1;
  pass.chunk = kCommitChunk;
  pass.reverse = options_.reverse;
  report_.commits.add(run_pass(mesh_, operation, std::move(work), pass, progress, claims_));
  count_outcomes(operation);
  for (std::uint32_t i = 0; i < proposals_.size(); ++i)
    if (operation.outcome(i) == PatchOutcome::kWon) queue(proposals_[i], again);
  for (std::size_t v = slots_before; v < mesh_.vertex_slots(); ++v)
    if (stars_.irregular(VertexId(v))) again.push_back(VertexId(v).value());
  report_.commit_seconds += watch.lap();
}

template <GeometryModel Model>
void PatchRemesher<Model>::count_outcomes(const PatchCommit<Model>& operation) {
  for (std::uint32_t i = 0; i < proposals_.size(); ++i) {
    const PatchProposal& proposal = proposals_[i];
    switch (operation.outcome(i)) {
      case PatchOutcome::kWon:
        ++report_.won[static_cast<std::size_t>(proposal.fill.kind)];
        faces_ += proposal.fresh_faces;
        faces_ -= proposal.faces.size();
        break;
      case PatchOutcome::kNoGain:
      case PatchOutcome::kQuality:
        report_.reject(operation.outcome(i) == PatchOutcome::kNoGain ? PatchReject::kNoGain
                                                                     : PatchReject::kQuality);
        memory_.refuse(proposal.key);
    }
  }
}

}  // namespace

template <GeometryModel Model>
PatchReport remesh_patches(Mesh& cut_open, const Model& model, const PatchOptions& options,
                           PatchMemory& memory, const Progress& progress) {
  assert(options.over_lines == nullptr || cut_open.planar());
  memory.begin_class(cut_open);
  return PatchRemesher<Model>(cut_open, model, options, memory).run(progress);
}

template PatchReport remesh_patches<PlaneModel>(Mesh&, const PlaneModel&, const PatchOptions&, PatchMemory&,
                                                const Progress&);
template PatchReport remesh_patches<SpaceModel>(Mesh&, const SpaceModel&, const PatchOptions&, PatchMemory&,
                                                const Progress&);

std::vector<std::size_t> patch_classes(std::size_t largest, bool fewest, std::size_t faces) {
  constexpr std::size_t kSmallestClass = 32;
  constexpr std::size_t kStep = 4;
  std::vector<std::size_t> classes;
  for (std::size_t size = kSmallestClass; size < largest; size *= kStep) classes.push_back(size);
  classes.push_back(largest);
  // Large patches bend many rows: no larger ones than it takes.
  if (fewest)
    for (std::size_t size = 2 * largest; size < 2 * faces; size *= 2) classes.push_back(size);
  return classes;
}

}  // namespace quarry
