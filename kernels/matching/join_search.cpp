#include "kernels/matching/join_search.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <limits>
#include <utility>
#include <vector>

#include "engine/base/random.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/matching/star_toggle.hpp"

namespace quarry {
namespace {

using matching::SearchState;
using matching::Star;
using matching::StarToggle;

constexpr std::size_t kStarChunk = 512;
// The cost of a quad that pairs of stars are tried for.
constexpr double kBadCost = 0.6;
constexpr std::uint64_t kUnclaimed = ~std::uint64_t{0};

struct Candidate {
  Star star;
  int change;
  std::uint32_t code;  // names the move: no two of a descent share it
};

// A set of vertices that many threads may add to.
class VertexFlags {
 public:
  explicit VertexFlags(std::size_t size) : flags_(size, 0) {}
  void set(VertexId v) { std::atomic_ref(flags_[v.value()]).store(1, std::memory_order_relaxed); }
  [[nodiscard]] bool has(VertexId v) const { return flags_[v.value()] != 0; }
  [[nodiscard]] std::vector<std::uint32_t> list() const {
    return parallel::filter_indices(flags_.size(), [&](std::size_t i) { return flags_[i] != 0; });
  }
  void clear(const std::vector<std::uint32_t>& members) {
    parallel::for_each(members.size(), [&](std::size_t i) { flags_[members[i]] = 0; });
  }

 private:
  std::vector<std::uint8_t> flags_;
};

// Minus the binary logarithm of a number drawn from (0, 1), within 0.09 and in whole arithmetic, so that no
// library function decides what annealing accepts.
double exponential(std::uint64_t random) {
  const int zeros = std::min(std::countl_zero(random), 40);
  const auto fraction = static_cast<double>((random << (zeros + 1)) >> 40) * 0x1.0p-24;
  return zeros + 1 - fraction;
}

class JoinSearch {
 public:
  JoinSearch(SearchState& state, const JoinSearchOptions& options, JoinSearchReport& report)
      : state_(state),
        options_(options),
        report_(report),
        words_(state.mesh.vertex_slots(), kUnclaimed),
        touched_(state.mesh.vertex_slots()) {}

  void anneal(const Progress& progress) {
    for (int sweep = 0; sweep < options_.annealing_sweeps; ++sweep) {
      progress.throw_if_cancelled();
      const double left = 1 - static_cast<double>(sweep) / options_.annealing_sweeps;
      const double temperature = options_.coldest + (options_.hottest - options_.coldest) * left * left;
      const auto round = static_cast<std::uint32_t>(sweep);
      const std::vector<Candidate> accepted =
          draw(near_steiner_points(), round, temperature * state_.costs.steiner());
      // Both ends of an edge may have drawn the same move: the keys differ, so that it is made once.
      report_.annealing_moves += commit_independent(accepted, [&](const Candidate& c) {
        const std::uint32_t drawer = c.star.first.value();
        return (std::uint64_t{mix32(drawer ^ mix32(round))} << 32) | drawer;
      });
    }
    touched_.clear(touched_.list());
  }

  void descend(bool pairs, const Progress& progress) {
    std::vector<Candidate> waiting;
    if (pairs)
      touch_bad_faces();
    else
      touch_all();
    for (int round = 0; round < options_.rounds; ++round) {
      progress.throw_if_cancelled();
      const std::vector<std::uint32_t> active = touched_.list();
      std::vector<Candidate> candidates = improving_moves(active, pairs);
      keep_untouched(waiting, candidates);
      touched_.clear(active);
      if (candidates.empty()) break;
      ++report_.rounds;
      const std::uint64_t won = commit_independent(candidates, [](const Candidate& c) {
        const auto biased = static_cast<std::uint32_t>(c.change + std::numeric_limits<int>::max());
        return (std::uint64_t{biased} << 32) | mix32(c.code);
      });
      (pairs ? report_.pairs : report_.stars) += won;
      waiting = std::move(candidates);
    }
    touched_.clear(touched_.list());
  }

 private:
  static std::uint32_t code_of_star(VertexId v) { return v.value() | 0x80000000U; }

  // Calls visit(Star, code) for the moves at v: the star alone, and the pairs with those neighbours that do
  // not call this themselves.
  template <class Visit>
  void for_each_move(VertexId v, bool pairs, const Visit& visit) const {
    visit(Star{v, VertexId()}, code_of_star(v));
    if (!pairs) return;
    for_each_side_around(state_.mesh, v, [&](SideId s) {
      const VertexId w = state_.mesh.target(s);
      if (state_.free[w] == 0 || (touched_.has(w) && w < v)) return;
      visit(Star{v, w}, matching::canonical(state_.mesh, s).value());
    });
  }

  void touch_all() {
    parallel::for_each(state_.mesh.vertex_slots(), [&](std::size_t i) {
      if (state_.free[VertexId(i)] != 0) touched_.set(VertexId(i));
    });
  }

  // Pairs are six times as many as stars and seldom win but where a Steiner point or a bad quad is to be got
  // rid of: only the corners of such triangles are looked at first.
  void touch_bad_faces() {
    parallel::for_each(state_.mesh.face_slots(), [&](std::size_t i) {
      const FaceId f(i);
      if (!is_bad(f)) return;
      for (int k = 0; k < 3; ++k) touched_.set(state_.mesh.corner(f, k));
    });
  }

  [[nodiscard]] bool is_bad(FaceId f) const {
    const std::uint8_t bits = state_.join[f];
    if (matching::is_split(bits)) return true;
    if (bits == 0) return false;
    const SideId s(f, std::countr_zero(static_cast<unsigned>(bits)));
    return state_.costs(s, false, matching::is_split(state_.join[state_.mesh.neighbour(s).face()])) >
           kBadCost * kCostUnit;
  }

  // What one chunk finds.
  struct Found {
    std::vector<Candidate> candidates;
    std::uint64_t evaluated = 0;
  };

  // Runs look(position, toggle, found) for all positions and joins what the chunks find.
  template <class Look>
  std::vector<Candidate> gather(std::size_t size, const Look& look) {
    std::vector<Found> parts((size + kStarChunk - 1) / kStarChunk);
    parallel::for_each_chunk(size, kStarChunk, [&](std::size_t begin, std::size_t end) {
      StarToggle toggle(state_);
      for (std::size_t i = begin; i < end; ++i) look(i, toggle, parts[begin / kStarChunk]);
    });
    std::vector<std::size_t> at(parts.size() + 1, 0);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      at[i + 1] = at[i] + parts[i].candidates.size();
      report_.evaluated += parts[i].evaluated;
    }
    std::vector<Candidate> all(at.back());
    parallel::for_each(
        parts.size(),
        [&](std::size_t i) {
          std::copy(parts[i].candidates.begin(), parts[i].candidates.end(),
                    all.begin() + static_cast<std::ptrdiff_t>(at[i]));
        },
        16);
    return all;
  }

  // The moves at these vertices that lower the cost.
  std::vector<Candidate> improving_moves(const std::vector<std::uint32_t>& active, bool pairs) {
    return gather(active.size(), [&](std::size_t i, StarToggle& toggle, Found& found) {
      if (state_.free[VertexId(active[i])] == 0) return;
      for_each_move(VertexId(active[i]), pairs, [&](Star star, std::uint32_t code) {
        ++found.evaluated;
        toggle.gather(star);
        if (const int change = toggle.gain_in_cost(); change < 0)
          found.candidates.push_back({star, change, code});
      });
    });
  }

  // Moves that lost a round and whose surroundings are as they were still wait, with the change that they
  // had.
  void keep_untouched(const std::vector<Candidate>& waiting, std::vector<Candidate>& candidates) const {
    for (const Candidate& c : waiting) {
      if (touched_.has(c.star.first) || (c.star.second.valid() && touched_.has(c.star.second))) continue;
      candidates.push_back(c);
    }
  }

  // Vertices up to one edge away from triangles that need a Steiner point. Elsewhere annealing would only
  // undo what the descent has done.
  std::vector<std::uint32_t> near_steiner_points() {
    const auto split = parallel::filter_indices(
        state_.join.size(), [&](std::size_t i) { return matching::is_split(state_.join[FaceId(i)]); });
    const auto touch_around = [&](VertexId v) {
      for_each_side_around(state_.mesh, v, [&](SideId s) {
        touched_.set(state_.mesh.target(s));
        touched_.set(matching::apex(state_.mesh, s));
      });
    };
    parallel::for_each(
        split.size(),
        [&](std::size_t i) {
          for (int k = 0; k < 3; ++k) touch_around(state_.mesh.corner(FaceId(split[i]), k));
        },
        kStarChunk);
    std::vector<std::uint32_t> near = touched_.list();
    touched_.clear(near);
    return near;
  }

  // One move for each of the free vertices, alone or with a neighbour, where the draw accepts its cost.
  std::vector<Candidate> draw(const std::vector<std::uint32_t>& vertices, std::uint32_t sweep,
                              double temperature) {
    const std::uint64_t base = mix64(mix64(options_.seed) ^ sweep);
    return gather(vertices.size(), [&](std::size_t i, StarToggle& toggle, Found& found) {
      const VertexId v(vertices[i]);
      if (state_.free[v] == 0) return;
      const std::uint64_t random = mix64(base ^ mix64(v.value()));
      const Star star = pick(v, random);
      ++found.evaluated;
      toggle.gather(star);
      const int change = toggle.gain_in_cost();
      if (change <= temperature * exponential(mix64(random))) found.candidates.push_back({star, change, 0});
    });
  }

  [[nodiscard]] Star pick(VertexId v, std::uint64_t random) const {
    if (!options_.pairs || (random & 1U) == 0) return {v, VertexId()};
    SideId s = state_.mesh.side_of(v);
    for (std::uint64_t turns = (random >> 8) % StarToggle::kMostFaces; turns > 0; --turns)
      s = state_.mesh.turn_left(s);
    const VertexId w = state_.mesh.target(s);
    return {v, state_.free[w] != 0 ? w : VertexId()};
  }

  // Makes those moves of which no vertex is wanted by a move with a smaller key, and marks what they touch.
  // Returns their number.
  template <class Key>
  std::uint64_t commit_independent(const std::vector<Candidate>& candidates, const Key& key) {
    const auto for_each_vertex = [&](std::size_t i, const auto& visit) {
      StarToggle toggle(state_);
      toggle.gather(candidates[i].star);
      for (const VertexId v : toggle.vertices()) visit(v);
    };
    parallel::for_each(
        candidates.size(),
        [&](std::size_t i) {
          const std::uint64_t mine = key(candidates[i]);
          for_each_vertex(i, [&](VertexId v) { claim(v, mine); });
        },
        kStarChunk);
    std::vector<std::uint8_t> won(candidates.size());
    parallel::for_each(
        candidates.size(),
        [&](std::size_t i) {
          const std::uint64_t mine = key(candidates[i]);
          bool all = true;
          for_each_vertex(i, [&](VertexId v) { all = all && words_[v.value()] == mine; });
          won[i] = all ? 1 : 0;
        },
        kStarChunk);
    parallel::for_each(
        candidates.size(),
        [&](std::size_t i) {
          for_each_vertex(i, [&](VertexId v) {
            std::atomic_ref(words_[v.value()]).store(kUnclaimed, std::memory_order_relaxed);
          });
        },
        kStarChunk);
    const auto winners = parallel::filter_indices(won.size(), [&](std::size_t i) { return won[i] != 0; });
    return parallel::reduce_ordered(
        winners.size(), std::uint64_t{0},
        [&](std::size_t begin, std::size_t end) {
          std::uint64_t made = 0;
          for (std::size_t i = begin; i < end; ++i) made += make_move(candidates[winners[i]]) ? 1 : 0;
          return made;
        },
        [](std::uint64_t a, std::uint64_t b) { return a + b; }, kStarChunk);
  }

  void claim(VertexId v, std::uint64_t mine) {
    std::atomic_ref word(words_[v.value()]);
    std::uint64_t seen = word.load(std::memory_order_relaxed);
    while (mine < seen && !word.compare_exchange_weak(seen, mine, std::memory_order_relaxed)) {
    }
  }

  // Makes a move that has won, unless it has become worse since it was looked at; it is looked at again then.
  // Moves at the vertices whose faces changed are looked at next. Those one edge farther depend on the change
  // too, by a valence or by the quads across their rim, but so little that it is not worth four times as many
  // looks.
  bool make_move(const Candidate& candidate) {
    StarToggle toggle(state_);
    toggle.gather(candidate.star);
    if (toggle.gain_in_cost() > candidate.change) {
      touched_.set(candidate.star.first);
      return false;
    }
    toggle.commit();
    for (const VertexId v : toggle.vertices()) touched_.set(v);
    return true;
  }

  SearchState& state_;
  const JoinSearchOptions& options_;
  JoinSearchReport& report_;
  std::vector<std::uint64_t> words_;  // of each vertex: the smallest key that wants it
  VertexFlags touched_;
};

}  // namespace

void improve_join(const Mesh& mesh, ConstraintTags tags, const MergeCosts& costs,
                  const JoinSearchOptions& options, DualArcs& join, JoinSearchReport& report,
                  const Progress& progress) {
  SearchState state(mesh, tags, costs, join);
  JoinSearch search(state, options, report);
  search.descend(false, progress);
  if (options.annealing_sweeps > 0) search.anneal(progress);
  if (options.pairs) search.descend(true, progress);
}

}  // namespace quarry
