// The pass: runs local operations in parallel with the same outcome on any number of threads (deterministic
// reservations: Blelloch, Fineman, Gibbons & Shun 2012). Each round takes a bounded window of the pending
// list:
//   1. propose and claim: each item reads the mesh, names its cavity and writes its rank into the claim
//   words;
//   2. decide: who holds every one of its claims has won; new ids come from a scan in list order;
//   3. apply: winners write, with no lock and no order among them.
// Losers return to the front of the list in order, follow-ups go to its end in list order.
//
// An operation is a class with
//
//   using Item, Plan          what is pending; what propose tells apply; both trivially copyable
//
//   bool propose(const Mesh&, Item, Cavity&, Plan&) const
//                             false: nothing to do, the item is dropped
//
//   void apply(MeshEditor&, Item, const Plan&, NewIds, FollowUps<Item>&) const
//
// propose must claim each vertex whose star it reads for a decision; apply touches claimed and new entities
// only. Items must name what survives: vertices and own numbers, not sides that another flip may turn.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "engine/base/progress.hpp"
#include "engine/mesh/mesh.hpp"
#include "engine/operation/cavity.hpp"
#include "engine/operation/claims.hpp"
#include "engine/operation/editor.hpp"
#include "engine/parallel/parallel.hpp"

namespace quarry {

// window and cutoff are constants of an operation and part of the output: never derive them from the machine.
struct PassOptions {
  std::size_t window = 16384;  // items a round: cavities and claims of a round should stay in cache
  // Only ranks under 2^32 / cutoff propose in a round; 1 for cheap, check-like operations.
  std::uint32_t cutoff = 4;
  // Faces beyond which the pass ends with Error(kBudget): no estimate foresees the refinement that hard input
  // asks for.
  std::size_t max_faces = std::numeric_limits<std::uint32_t>::max() / 4;
  // Items a chunk, which one thread takes at a time: 256 are about 50 microseconds of work for operations of
  // 20 to 500 ns; fewer for those that take long.
  std::size_t chunk = 256;
  bool reverse = false;  // apply winners last to first on one thread: a test that they are independent
};

struct PassReport {
  std::string name;
  std::uint64_t rounds = 0;
  std::uint64_t proposed = 0;  // calls of propose
  std::uint64_t live = 0;      // of them with something to do
  std::uint64_t won = 0;       // operations applied

  // Adds the counts of another pass of the same operation; the name stays.
  void add(const PassReport& other) {
    rounds += other.rounds;
    proposed += other.proposed;
    live += other.live;
    won += other.won;
  }
};

template <class Item>
using FollowUps = std::vector<Item>;

namespace detail {

// What one chunk of a round remembers between the phases.
template <class Operation>
struct PassChunk {
  struct Record {
    std::uint32_t position;  // in the window
    std::uint32_t claim_begin, claim_end;
    std::uint32_t new_vertices, new_faces;
    bool won;
    typename Operation::Plan plan;
  };
  std::vector<VertexId> claims;
  std::vector<Record> records;
  std::vector<typename Operation::Item> waiting;  // not called this round, or lost
  FollowUps<typename Operation::Item> follow_ups;
  std::uint32_t proposed = 0;
  std::uint32_t new_vertices = 0, new_faces = 0;  // of winners; then where this chunk's begin

  void clear() {
    claims.clear();
    records.clear();
    waiting.clear();
    follow_ups.clear();
    proposed = new_vertices = new_faces = 0;
  }
  [[nodiscard]] std::span<const VertexId> claims_of(const Record& record) const {
    return std::span(claims).subspan(record.claim_begin, record.claim_end - record.claim_begin);
  }
};

}  // namespace detail

template <class Operation>
class Pass {
 public:
  using Item = typename Operation::Item;

  Pass(Mesh& mesh, const Operation& operation, PassOptions options, Claims& claims)
      : mesh_(mesh), operation_(operation), options_(options), claims_(claims), cutoff_(options.cutoff) {}

  PassReport run(std::vector<Item> work, const Progress& progress) {
    pending_ = std::move(work);
    begin_ = 0;
    while (begin_ < pending_.size()) {
      progress.throw_if_cancelled();
      require_budget();
      run_round();
    }
    return report_;
  }

 private:
  using Chunk = detail::PassChunk<Operation>;

  void require_budget() const {
    if (mesh_.face_slots() <= options_.max_faces) return;
    throw Error(
        ErrorKind::kBudget,
        fmt::format("the mesh has grown to {} faces and the lines ask for more: raise --max-elements, or "
                    "take a larger --size, --snap or --min-edge",
                    mesh_.face_slots()));
  }

  void run_round() {
    window_ = std::min(options_.window, pending_.size() - begin_);
    // With few items left a cut-off would leave rounds empty.
    cutoff_ = window_ < 4 * options_.chunk ? 1 : options_.cutoff;
    round_ = static_cast<std::uint32_t>(report_.rounds++);
    claims_.begin_round(mesh_.vertex_slots());
    chunk_count_ = (window_ + options_.chunk - 1) / options_.chunk;
    if (chunks_.size() < chunk_count_) chunks_.resize(chunk_count_);
    parallel::for_each_chunk(window_, options_.chunk, [&](std::size_t begin, std::size_t end) {
      propose(chunks_[begin / options_.chunk], begin, end);
    });
    parallel::for_each(
        chunk_count_, [&](std::size_t i) { decide(chunks_[i]); }, 1);
    const NewIds first = reserve_ids();
    apply_all(first);
    collect();
  }

  void propose(Chunk& chunk, std::size_t begin, std::size_t end) {
    chunk.clear();
    for (std::size_t i = begin; i < end; ++i) {
      const auto position = static_cast<std::uint32_t>(i);
      const std::uint32_t rank = rank_of(position, round_);
      const Item item = pending_[begin_ + i];
      if (cutoff_ > 1 && rank > ~std::uint32_t{0} / cutoff_) {
        chunk.waiting.push_back(item);
        continue;
      }
      ++chunk.proposed;
      const auto claim_begin = static_cast<std::uint32_t>(chunk.claims.size());
      Cavity cavity(chunk.claims);
      typename Operation::Plan plan{};
      if (!operation_.propose(std::as_const(mesh_), item, cavity, plan)) {
        chunk.claims.resize(claim_begin);
        continue;
      }
      chunk.records.push_back({position, claim_begin, static_cast<std::uint32_t>(chunk.claims.size()),
                               cavity.new_vertices(), cavity.new_faces(), false, plan});
      claims_.claim(cavity.claims(), rank);
    }
  }

  void decide(Chunk& chunk) {
    // Losers go before those that were not called: they have waited for longer.
    std::vector<Item> returned;
    std::swap(returned, chunk.waiting);
    auto& lost = chunk.waiting;
    for (auto& record : chunk.records) {
      record.won = claims_.holds_all(chunk.claims_of(record), rank_of(record.position, round_));
      if (record.won) {
        chunk.new_vertices += record.new_vertices;
        chunk.new_faces += record.new_faces;
      } else {
        lost.push_back(pending_[begin_ + record.position]);
      }
    }
    lost.insert(lost.end(), returned.begin(), returned.end());
  }

  NewIds reserve_ids() {
    std::uint32_t vertices = 0;
    std::uint32_t faces = 0;
    for (std::size_t i = 0; i < chunk_count_; ++i) {
      vertices += std::exchange(chunks_[i].new_vertices, vertices);
      faces += std::exchange(chunks_[i].new_faces, faces);
    }
    return {mesh_.grow_vertices(vertices), mesh_.grow_faces(faces)};
  }

  void apply_all(NewIds first) {
    if (!options_.reverse) {
      parallel::for_each(
          chunk_count_, [&](std::size_t i) { apply(chunks_[i], first, false); }, 1);
      return;
    }
    for (std::size_t i = chunk_count_; i-- > 0;) apply(chunks_[i], first, true);
  }

  void apply(Chunk& chunk, NewIds first, bool reverse) {
    NewIds at{VertexId(first.vertex.value() + chunk.new_vertices),
              FaceId(first.face.value() + chunk.new_faces)};
    std::vector<std::pair<const typename Chunk::Record*, NewIds>> winners;
    for (const auto& record : chunk.records) {
      if (!record.won) continue;
      winners.emplace_back(&record, at);
      at = {VertexId(at.vertex.value() + record.new_vertices), FaceId(at.face.value() + record.new_faces)};
    }
    if (reverse) std::reverse(winners.begin(), winners.end());
    FollowUps<Item> follow_ups;
    for (const auto& [record, ids] : winners) {
      const NewIds end{VertexId(ids.vertex.value() + record->new_vertices),
                       FaceId(ids.face.value() + record->new_faces)};
      MeshEditor editor(mesh_, chunk.claims_of(*record), ids, end);
      follow_ups.clear();
      operation_.apply(editor, pending_[begin_ + record->position], record->plan, ids, follow_ups);
      chunk.follow_ups.insert(reverse ? chunk.follow_ups.begin() : chunk.follow_ups.end(), follow_ups.begin(),
                              follow_ups.end());
    }
  }

  // Puts what waits back in front of the rest of the list, follow-ups behind it.
  void collect() {
    std::size_t waiting = 0;
    for (std::size_t i = 0; i < chunk_count_; ++i) {
      const Chunk& chunk = chunks_[i];
      waiting += chunk.waiting.size();
      report_.proposed += chunk.proposed;
      report_.live += chunk.records.size();
      for (const auto& record : chunk.records) report_.won += record.won ? 1 : 0;
    }
    begin_ += window_ - waiting;
    std::size_t at = begin_;
    for (std::size_t i = 0; i < chunk_count_; ++i)
      for (const Item& item : chunks_[i].waiting) pending_[at++] = item;
    for (std::size_t i = 0; i < chunk_count_; ++i)
      pending_.insert(pending_.end(), chunks_[i].follow_ups.begin(), chunks_[i].follow_ups.end());
    // What is done leaves the list once it is most of it.
    if (begin_ > 65536 && begin_ > pending_.size() / 2) {
      pending_.erase(pending_.begin(), pending_.begin() + static_cast<std::ptrdiff_t>(begin_));
      begin_ = 0;
    }
  }

  Mesh& mesh_;
  const Operation& operation_;
  PassOptions options_;
  Claims& claims_;
  std::uint32_t cutoff_;
  std::uint32_t round_ = 0;
  std::size_t window_ = 0, chunk_count_ = 0, begin_ = 0;
  std::vector<Item> pending_;
  std::vector<Chunk> chunks_;
  PassReport report_;
};

// Runs operation on each item of work, and on what follows from it, until nothing is pending. claims: to be
// kept by who runs many short passes over a mesh, one after the other.
template <class Operation>
PassReport run_pass(Mesh& mesh, const Operation& operation, std::vector<typename Operation::Item> work,
                    PassOptions options, const Progress& progress, Claims& claims) {
  return Pass<Operation>(mesh, operation, options, claims).run(std::move(work), progress);
}

template <class Operation>
PassReport run_pass(Mesh& mesh, const Operation& operation, std::vector<typename Operation::Item> work,
                    PassOptions options, const Progress& progress) {
  Claims claims;
  return run_pass(mesh, operation, std::move(work), options, progress, claims);
}

}  // namespace quarry
