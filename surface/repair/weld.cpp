#include "surface/repair/weld.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>

#include "engine/base/random.hpp"
#include "engine/parallel/parallel.hpp"
#include "engine/parallel/sort.hpp"
#include "kernels/local/stamped_map.hpp"

namespace quarry {
namespace {

// Equal for -0 and 0.
std::uint64_t hash_of(Vec3 p) {
  const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value + 0.0); };
  return mix64(bits(p.x) ^ mix64(bits(p.y) ^ mix64(bits(p.z))));
}

std::vector<std::uint32_t> weld_equal(std::span<const Vec3> points) {
  std::vector<std::uint64_t> keys(points.size());
  parallel::for_each(points.size(), [&](std::size_t i) { keys[i] = hash_of(points[i]); });
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  parallel::stable_sort_by_key(keys, order);
  std::vector<std::uint32_t> first(points.size());
  std::iota(first.begin(), first.end(), 0U);
  for (std::size_t i = 1; i < order.size(); ++i) {
    // Within a run of one key: the first of equal coordinates. Runs of more than one place are chance.
    for (std::size_t j = i; j > 0 && keys[j - 1] == keys[i]; --j) {
      if (!(points[order[j - 1]] == points[order[i]])) continue;
      first[order[i]] = first[order[j - 1]];
      break;
    }
  }
  return first;
}

// A grid whose cells are as wide as the distance: who is near lies in one of 27 cells.
class NearPoints {
 public:
  NearPoints(std::span<const Vec3> points, double distance) : points_(points), distance_(distance) {
    heads_.clear(points.size());
    next_.assign(points.size(), kNone);
  }

  // The nearest point added so far within the distance, of equals the first; kNone if there is none.
  [[nodiscard]] std::uint32_t nearest(Vec3 p) {
    std::uint32_t best = kNone;
    double least = distance_ * distance_;
    const Cell home = cell_of(p);
    for (int i = 0; i < 27; ++i) {
      const std::uint32_t* head =
          heads_.find(key_of({home[0] + i % 3 - 1, home[1] + i / 3 % 3 - 1, home[2] + i / 9 - 1}));
      for (std::uint32_t at = head != nullptr ? *head : kNone; at != kNone; at = next_[at]) {
        const Vec3 d = points_[at] - p;
        const double squared = dot(d, d);
        if (squared > least || (squared == least && best < at)) continue;
        least = squared;
        best = at;
      }
    }
    return best;
  }

  void add(std::uint32_t number) {
    auto [head, fresh] = heads_.insert(key_of(cell_of(points_[number])));
    next_[number] = fresh ? kNone : head;
    head = number;
  }

  static constexpr std::uint32_t kNone = 0xffffffffU;

 private:
  using Cell = std::array<std::int64_t, 3>;

  [[nodiscard]] Cell cell_of(Vec3 p) const {
    const auto index = [&](double value) { return static_cast<std::int64_t>(std::floor(value / distance_)); };
    return {index(p.x), index(p.y), index(p.z)};
  }
  // Cells of one key only cost time: distances are looked at in any case.
  static std::uint64_t key_of(Cell cell) {
    const auto word = [](std::int64_t value) { return static_cast<std::uint64_t>(value); };
    return mix64(word(cell[0]) ^ mix64(word(cell[1]) ^ mix64(word(cell[2]))));
  }

  std::span<const Vec3> points_;
  double distance_;
  StampedMap<std::uint32_t> heads_;
  std::vector<std::uint32_t> next_;
};

}  // namespace

std::vector<std::uint32_t> weld_points(std::span<const Vec3> points, double distance) {
  if (!(distance > 0)) return weld_equal(points);
  NearPoints near(points, distance);
  std::vector<std::uint32_t> first(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const std::uint32_t other = near.nearest(points[i]);
    first[i] = other == NearPoints::kNone ? i : other;
    if (first[i] == i) near.add(i);
  }
  return first;
}

}  // namespace quarry
