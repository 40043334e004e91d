#include "kernels/crossfield/field_levels.hpp"

#include <algorithm>
#include <utility>

#include "engine/base/random.hpp"
#include "engine/parallel/parallel.hpp"
#include "engine/parallel/sort.hpp"
#include "kernels/smooth/tangent_frame.hpp"

namespace quarry {
namespace {

// Of the weight: less is left of a connection where the edges in it disagree.
constexpr double kLeastTurn = 0.1;

// Who is joined with whom: locally dominant rounds of a greedy matching; who finds nobody stays alone.
std::vector<std::uint32_t> partners_of(const FieldLevel& level) {
  std::vector<std::uint32_t> partner(level.size(), FieldLevel::kNone), best(level.size(), FieldLevel::kNone);
  std::vector<std::uint32_t> open =
      parallel::filter_indices(level.size(), [&](std::size_t i) { return level.given[i] == 0; });
  const auto key = [](std::uint32_t i, std::uint32_t j) {
    return mix64((std::uint64_t{std::min(i, j)} << 32) | std::max(i, j));
  };
  while (!open.empty()) {
    parallel::for_each(
        open.size(),
        [&](std::size_t k) {
          const std::uint32_t i = open[k];
          best[i] = FieldLevel::kNone;
          double score = 0;
          for (std::uint32_t e = level.first[i]; e < level.first[i + 1]; ++e) {
            const std::uint32_t j = level.other[e];
            if (level.given[j] != 0 || partner[j] != FieldLevel::kNone) continue;
            if (!(length(level.turn[e]) > kLeastTurn * level.weight[e])) continue;
            // Even masses, and normals that agree. Not by turns: they depend on the axes, if only by
            // rounding.
            const double mine = level.weight[e] * dot(level.normals[i], level.normals[j]) /
                                std::max(level.mass[i], level.mass[j]);
            if (!(mine > 0)) continue;
            if (best[i] != FieldLevel::kNone &&
                (mine < score || (mine == score && key(i, j) > key(i, best[i]))))
              continue;
            best[i] = j;
            score = mine;
          }
        },
        kFieldChunk);
    parallel::for_each(open.size(), [&](std::size_t k) {
      const std::uint32_t i = open[k];
      if (best[i] != FieldLevel::kNone && best[best[i]] == i) partner[i] = best[i];
    });
    const auto left = parallel::filter_indices(open.size(), [&](std::size_t k) {
      return partner[open[k]] == FieldLevel::kNone && best[open[k]] != FieldLevel::kNone;
    });
    std::vector<std::uint32_t> rest(left.size());
    parallel::for_each(rest.size(), [&](std::size_t k) { rest[k] = open[left[k]]; });
    open = std::move(rest);
  }
  return partner;
}

// The entries of the coarser rows: P^H A P, with the fields of the parents for unknowns.
void join_rows(const FieldLevel& fine, FieldLevel& coarse) {
  const std::size_t entries = fine.other.size();
  std::vector<std::uint32_t> row_of(entries);
  parallel::for_each(fine.size(), [&](std::size_t i) {
    for (std::uint32_t e = fine.first[i]; e < fine.first[i + 1]; ++e)
      row_of[e] = static_cast<std::uint32_t>(i);
  });
  auto order = parallel::filter_indices(
      entries, [&](std::size_t e) { return fine.parent[row_of[e]] != fine.parent[fine.other[e]]; });
  std::vector<std::uint64_t> keys(order.size());
  parallel::for_each(order.size(), [&](std::size_t k) {
    keys[k] = (std::uint64_t{fine.parent[row_of[order[k]]]} << 32) | fine.parent[fine.other[order[k]]];
  });
  parallel::stable_sort_by_key(keys, order);
  const auto starts =
      parallel::filter_indices(keys.size(), [&](std::size_t k) { return k == 0 || keys[k] != keys[k - 1]; });
  coarse.other.resize(starts.size());
  coarse.weight.resize(starts.size());
  coarse.turn.resize(starts.size());
  parallel::for_each(starts.size(), [&](std::size_t s) {
    const std::size_t end = s + 1 < starts.size() ? starts[s + 1] : keys.size();
    double weight = 0;
    Vec2 turn;
    for (std::size_t k = starts[s]; k < end; ++k) {
      const std::uint32_t e = order[k];
      weight += fine.weight[e];
      turn = turn + complex_product(conjugate(fine.from_parent[row_of[e]]),
                                    complex_product(fine.turn[e], fine.from_parent[fine.other[e]]));
    }
    coarse.other[s] = static_cast<std::uint32_t>(keys[starts[s]] & 0xffffffffU);
    coarse.weight[s] = weight;
    coarse.turn[s] = turn;
  });
  coarse.first.assign(coarse.size() + 1, 0);
  for (const std::uint32_t k : starts) ++coarse.first[(keys[k] >> 32) + 1];
  for (std::size_t i = 0; i < coarse.size(); ++i) coarse.first[i + 1] += coarse.first[i];
}

// Of two numbers by vertex of the finer level that which stands for both.
template <class Values>
auto mean(const FieldLevel& fine, std::uint32_t i, std::uint32_t j, const Values& values) {
  return (1 / (fine.mass[i] + fine.mass[j])) * (fine.mass[i] * values[i] + fine.mass[j] * values[j]);
}

void take_over(FieldLevel& fine, std::uint32_t i, FieldLevel& coarse, std::uint32_t k) {
  fine.parent[i] = k;
  coarse.points[k] = fine.points[i];
  coarse.normals[k] = fine.normals[i];
  coarse.axes[k] = fine.axes[i];
  coarse.mass[k] = fine.mass[i];
  coarse.diagonal[k] = fine.diagonal[i];
  coarse.given[k] = fine.given[i];
}

// The field of the first is their parent's; that of the second such that both agree.
void join_with(FieldLevel& fine, std::uint32_t i, std::uint32_t j, FieldLevel& coarse, std::uint32_t k) {
  std::uint32_t e = fine.first[i];
  while (fine.other[e] != j) ++e;
  const double size = length(fine.turn[e]);
  fine.parent[j] = k;
  fine.from_parent[j] = (1 / size) * conjugate(fine.turn[e]);
  coarse.points[k] = mean(fine, i, j, fine.points);
  coarse.normals[k] = unit_or(mean(fine, i, j, fine.normals), fine.normals[i]);
  const Vec3 n = coarse.normals[k];
  coarse.axes[k] = unit_or(fine.axes[i] - dot(fine.axes[i], n) * n, any_tangent(n));
  coarse.mass[k] = fine.mass[i] + fine.mass[j];
  coarse.diagonal[k] = fine.diagonal[i] + fine.diagonal[j] - 2 * size;
}

// Fills parent and from_parent of the finer level.
FieldLevel coarser_level(FieldLevel& fine) {
  const std::vector<std::uint32_t> partner = partners_of(fine);
  const auto leads = parallel::filter_indices(
      fine.size(), [&](std::size_t i) { return partner[i] == FieldLevel::kNone || partner[i] > i; });
  FieldLevel coarse;
  coarse.resize(leads.size());
  coarse.children.resize(leads.size());
  fine.parent.resize(fine.size());
  fine.from_parent.assign(fine.size(), Vec2{1, 0});
  parallel::for_each(leads.size(), [&](std::size_t n) {
    const auto k = static_cast<std::uint32_t>(n);
    const std::uint32_t i = leads[k];
    coarse.children[k] = {i, partner[i]};
    take_over(fine, i, coarse, k);
    if (partner[i] != FieldLevel::kNone) join_with(fine, i, partner[i], coarse, k);
  });
  join_rows(fine, coarse);
  find_classes(coarse);
  return coarse;
}

}  // namespace

std::vector<FieldLevel> field_levels(FieldLevel finest, std::size_t fewest) {
  std::vector<FieldLevel> levels;
  levels.push_back(std::move(finest));
  for (std::size_t before = levels.back().free_size(); before > fewest;) {
    FieldLevel next = coarser_level(levels.back());
    const std::size_t now = next.free_size();
    if (now == before) break;
    before = now;
    levels.push_back(std::move(next));
  }
  return levels;
}

}  // namespace quarry
