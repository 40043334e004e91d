// From triangles to quads: pairing by either measure, recutting, and merging with halving. In triangles a
// second.
#include <utility>

#include <benchmark/benchmark.h>

#include "bench/synthetic_network.hpp"
#include "bench/thread_counts.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/cluster/merge.hpp"
#include "kernels/cluster/pairing.hpp"
#include "kernels/cluster/rearrange.hpp"
#include "kernels/cluster/subdivide.hpp"

namespace quarry {
namespace {

constexpr std::uint32_t kLines = 1000;
constexpr double kSize = 2;

// Triangles of a network, cleaned, and which of them are paired; what consumes them makes them anew.
struct PairedNetwork {
  CleanedLines cleaned = bench::clean_network(kLines, kSize);
  Mesh triangles = bench::triangle_mesh(cleaned.lines, kSize);
  PairingReport report;
  Pairing pairing = pair_triangles(triangles, ConstraintTags::of(triangles), {}, report, {});
};

// Argument: threads.
void pair(benchmark::State& state, PairMeasure measure) {
  const CleanedLines cleaned = bench::clean_network(kLines, kSize);
  const Mesh mesh = bench::triangle_mesh(cleaned.lines, kSize);
  parallel::with_threads(static_cast<int>(state.range(0)), [&] {
    for (auto _ : state) {
      PairingReport report;
      benchmark::DoNotOptimize(
          pair_triangles(mesh, ConstraintTags::of(mesh), {.measure = measure}, report, {}));
    }
  });
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(mesh.count_alive_faces()));
}
BENCHMARK_CAPTURE(pair, by_quad_quality, PairMeasure::kQuadQuality)
    ->ArgsProduct({bench::thread_counts()})
    ->ArgNames({"threads"})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pair, by_longest_edge, PairMeasure::kLongestEdge)
    ->ArgsProduct({bench::thread_counts()})
    ->ArgNames({"threads"})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

// Argument: threads. The mixed mesh is made anew while the clock stands.
void recut(benchmark::State& state) {
  const PairedNetwork network;
  parallel::with_threads(static_cast<int>(state.range(0)), [&] {
    for (auto _ : state) {
      state.PauseTiming();
      Mesh mixed = merge_pairs(bench::triangle_mesh(network.cleaned.lines, kSize), network.pairing);
      state.ResumeTiming();
      benchmark::DoNotOptimize(rearrange(mixed, {}, {}));
    }
  });
  state.SetItemsProcessed(state.iterations() *
                          static_cast<std::int64_t>(network.triangles.count_alive_faces()));
}
BENCHMARK(recut)
    ->ArgsProduct({bench::thread_counts()})
    ->ArgNames({"threads"})
    ->Iterations(3)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

// Argument: threads. Both steps consume their mesh: it is made anew while the clock stands.
void merge_and_halve(benchmark::State& state) {
  const PairedNetwork network;
  parallel::with_threads(static_cast<int>(state.range(0)), [&] {
    for (auto _ : state) {
      state.PauseTiming();
      Mesh mesh = bench::triangle_mesh(network.cleaned.lines, kSize);
      state.ResumeTiming();
      SubdivideReport report;
      benchmark::DoNotOptimize(
          subdivide(merge_pairs(std::move(mesh), network.pairing), network.cleaned.lines, report, {}));
    }
  });
  state.SetItemsProcessed(state.iterations() *
                          static_cast<std::int64_t>(network.triangles.count_alive_faces()));
}
BENCHMARK(merge_and_halve)
    ->ArgsProduct({bench::thread_counts()})
    ->ArgNames({"threads"})
    ->Iterations(5)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace quarry
