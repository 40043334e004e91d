// Insertion of cleaned lines into a crisscross mesh: the default beside the published procedure, in
// attractions a second. Making the start mesh is in the time; it is some per cent of it.
#include <benchmark/benchmark.h>

#include "bench/synthetic_network.hpp"
#include "bench/thread_counts.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/deferred/deferred.hpp"

namespace quarry {
namespace {

constexpr double kSize = 2;

DeferredOptions default_options(double spacing) {
  DeferredOptions options;
  options.spacing = spacing;
  return options;
}

// Arguments: lines, threads.
template <class Options>
void insert_network(benchmark::State& state, Options make_options) {
  const CleanedLines cleaned = bench::clean_network(static_cast<std::uint32_t>(state.range(0)), kSize);
  std::uint64_t attractions = 0;
  parallel::with_threads(static_cast<int>(state.range(1)), [&] {
    for (auto _ : state) {
      Mesh mesh = bench::start_mesh(cleaned.lines, kSize);
      DeferredReport report;
      benchmark::DoNotOptimize(insert_lines(mesh, cleaned.lines, make_options(2 * kSize), report, {}));
      attractions += report.attractions;
    }
  });
  state.SetItemsProcessed(static_cast<std::int64_t>(attractions));
}
BENCHMARK_CAPTURE(insert_network, default, default_options)
    ->ArgsProduct({{300, 3000}, bench::thread_counts()})
    ->ArgNames({"lines", "threads"})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(insert_network, paper, paper_options)
    ->ArgsProduct({{300}, bench::thread_counts()})
    ->ArgNames({"lines", "threads"})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace quarry
