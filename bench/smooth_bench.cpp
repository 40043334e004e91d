// Smoothing of a quad mesh that has just been made: each of the three kernels on its own. In quads a
// second.
#include <benchmark/benchmark.h>

#include "bench/synthetic_network.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/smooth/laplacian.hpp"
#include "kernels/smooth/optimise.hpp"
#include "kernels/smooth/square_corners.hpp"

namespace quarry {
namespace {

constexpr std::uint32_t kLines = 1000;
constexpr double kSize = 2;

// Argument: threads. The mesh is made anew while the clock stands.
template <class Smooth>
void smooth_quads(benchmark::State& state, Smooth smooth) {
  const CleanedLines cleaned = bench::clean_network(kLines, kSize);
  std::size_t quads = 0;
  parallel::with_threads(static_cast<int>(state.range(0)), [&] {
    for (auto _ : state) {
      state.PauseTiming();
      Mesh mesh = bench::raw_quad_mesh(cleaned.lines, kSize);
      state.ResumeTiming();
      smooth(mesh, cleaned.lines);
      quads += mesh.count_alive_faces();
    }
  });
  state.SetItemsProcessed(static_cast<std::int64_t>(quads));
}

void laplacian(Mesh& mesh, const NodedLines& lines) { smooth_laplacian(mesh, lines, {}, {}); }
void squaring(Mesh& mesh, const NodedLines& lines) { square_corners(mesh, lines, {}, {}); }
void optimiser(Mesh& mesh, const NodedLines& lines) { optimise_corners(mesh, lines, {}, {}); }

BENCHMARK_CAPTURE(smooth_quads, laplacian, laplacian)
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(smooth_quads, square_corners, squaring)
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(smooth_quads, optimiser, optimiser)
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace quarry
