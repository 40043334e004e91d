// Start meshes: the lattice in closed form beside the Delaunay triangulation of spaced points, in triangles a
// second.
#include <benchmark/benchmark.h>

#include "bench/thread_counts.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/initial/crisscross.hpp"
#include "kernels/initial/delaunay.hpp"

namespace quarry {
namespace {

constexpr Box2 kBox{{466000, 6691000}, {467000, 6692000}};

// Arguments: cells along a side, threads.
template <class Make>
void make_start(benchmark::State& state, Make make) {
  std::size_t faces = 0;
  parallel::with_threads(static_cast<int>(state.range(1)), [&] {
    for (auto _ : state) {
      const Mesh mesh = make(kBox.width() / static_cast<double>(state.range(0)));
      faces += mesh.count_alive_faces();
    }
  });
  state.SetItemsProcessed(static_cast<std::int64_t>(faces));
}

Mesh crisscross(double cell) { return make_crisscross(kBox, {.cell = cell}); }
Mesh delaunay(double spacing) { return make_delaunay(kBox, {.spacing = spacing}); }

BENCHMARK_CAPTURE(make_start, crisscross, crisscross)
    ->ArgsProduct({{100, 1000}, bench::thread_counts()})
    ->ArgNames({"cells", "threads"})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(make_start, delaunay, delaunay)
    ->ArgsProduct({{100, 400}, bench::thread_counts()})
    ->ArgNames({"cells", "threads"})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace quarry
