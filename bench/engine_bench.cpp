// What everything else stands on: the radix sort beside the standard library's, and the exact predicates on
// points that the filter decides and on points that it cannot.
#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include <benchmark/benchmark.h>

#include "bench/thread_counts.hpp"
#include "engine/base/random.hpp"
#include "engine/geometry/predicates.hpp"
#include "engine/parallel/parallel.hpp"
#include "engine/parallel/sort.hpp"

namespace quarry {
namespace {

std::vector<std::uint64_t> random_keys(std::size_t size) {
  std::vector<std::uint64_t> keys(size);
  for (std::size_t i = 0; i < size; ++i) keys[i] = mix64(i);
  return keys;
}

void count_items(benchmark::State& state, std::size_t items_an_iteration) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(items_an_iteration));
}

// Arguments: keys, threads.
void sorted_order_by_radix(benchmark::State& state) {
  const auto keys = random_keys(static_cast<std::size_t>(state.range(0)));
  parallel::with_threads(static_cast<int>(state.range(1)), [&] {
    for (auto _ : state) benchmark::DoNotOptimize(parallel::sorted_order(keys));
  });
  count_items(state, keys.size());
}
BENCHMARK(sorted_order_by_radix)
    ->ArgsProduct({{1 << 10, 1 << 16, 1 << 20, 1 << 22}, bench::thread_counts()})
    ->ArgNames({"keys", "threads"})
    ->UseRealTime();

void sorted_order_by_stable_sort(benchmark::State& state) {
  const auto keys = random_keys(static_cast<std::size_t>(state.range(0)));
  std::vector<std::uint32_t> order(keys.size());
  for (auto _ : state) {
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return keys[a] < keys[b]; });
    benchmark::DoNotOptimize(order.data());
  }
  count_items(state, keys.size());
}
BENCHMARK(sorted_order_by_stable_sort)->RangeMultiplier(16)->Range(1 << 10, 1 << 22)->UseRealTime();

// Points of a map: eastings and northings of seven digits, detail of centimetres.
std::vector<Vec2> map_points(std::size_t size) {
  std::vector<Vec2> points(size);
  for (std::size_t i = 0; i < size; ++i)
    points[i] = {466000 + 200 * uniform01(1, i), 6691000 + 200 * uniform01(2, i)};
  return points;
}

// Any three that follow each other are collinear but for some units in the last place: the filter cannot
// decide.
std::vector<Vec2> nearly_collinear_points(std::size_t size) {
  std::vector<Vec2> points(size);
  for (std::size_t i = 0; i < size; ++i) {
    const double off = 0x1p-53;
    const Vec2 near_half{0.5 + 64 * off * uniform01(3, i), 0.5 + 64 * off * uniform01(4, i)};
    points[i] = i % 3 == 0 ? near_half : i % 3 == 1 ? Vec2{12, 12} : Vec2{24, 24};
  }
  return points;
}

template <class Points, class Predicate>
void run_predicate(benchmark::State& state, Points make_points, Predicate predicate) {
  constexpr std::size_t kPoints = 4096;
  const std::vector<Vec2> points = make_points(kPoints);
  for (auto _ : state) {
    double sum = 0;
    for (std::size_t i = 0; i + 3 < kPoints; ++i) sum += predicate(&points[i]);
    benchmark::DoNotOptimize(sum);
  }
  count_items(state, kPoints - 3);
}

double orient_first_three(const Vec2* p) { return orient2d(p[0], p[1], p[2]); }
double circle_of_first_three(const Vec2* p) { return incircle(p[0], p[1], p[2], p[3]); }

BENCHMARK_CAPTURE(run_predicate, orient2d_map, map_points, orient_first_three);
BENCHMARK_CAPTURE(run_predicate, orient2d_nearly_collinear, nearly_collinear_points, orient_first_three);
BENCHMARK_CAPTURE(run_predicate, incircle_map, map_points, circle_of_first_three);

}  // namespace
}  // namespace quarry
