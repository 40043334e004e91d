// Cleaning of raw line work: lines a second, by number of lines and threads.
#include <benchmark/benchmark.h>

#include "bench/synthetic_network.hpp"
#include "engine/parallel/parallel.hpp"

namespace quarry {
namespace {

// Arguments: lines, threads.
void clean_raw_lines(benchmark::State& state) {
  const LineSet lines = bench::draw_network(static_cast<std::uint32_t>(state.range(0)));
  const CleanOptions options{.snap = 0.1, .min_edge = 0.2, .tolerance = 0.1};
  const Outline outline = box_outline(lines, options.snap);
  parallel::with_threads(static_cast<int>(state.range(1)), [&] {
    for (auto _ : state) benchmark::DoNotOptimize(clean_lines(lines, outline, options));
  });
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(clean_raw_lines)
    ->ArgsProduct({{1000, 10000}, {1, 2}})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace quarry
