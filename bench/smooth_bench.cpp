// Smoothing of a quad mesh that has just been made: each kernel on its own, in quads a second; and
// the smoother of small regions, in vertices a second.
#include <vector>

#include <benchmark/benchmark.h>

#include "bench/synthetic_network.hpp"
#include "bench/thread_counts.hpp"
#include "engine/base/random.hpp"
#include "engine/mesh/build.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/field/size_field.hpp"
#include "kernels/smooth/laplacian.hpp"
#include "kernels/smooth/local_smoother.hpp"
#include "kernels/smooth/optimise.hpp"
#include "kernels/smooth/optimise_shape.hpp"
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
void shape(Mesh& mesh, const NodedLines& lines) {
  const UniformSize size(kSize);
  optimise_shape(mesh, lines, {.size = &size}, {});
}
void optimiser(Mesh& mesh, const NodedLines& lines) { optimise_corners(mesh, lines, {}, {}); }

BENCHMARK_CAPTURE(smooth_quads, laplacian, laplacian)
    ->ArgsProduct({bench::thread_counts()})
    ->ArgNames({"threads"})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(smooth_quads, square_corners, squaring)
    ->ArgsProduct({bench::thread_counts()})
    ->ArgNames({"threads"})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(smooth_quads, optimise_shape, shape)
    ->ArgsProduct({bench::thread_counts()})
    ->ArgNames({"threads"})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(smooth_quads, optimiser, optimiser)
    ->ArgsProduct({bench::thread_counts()})
    ->ArgNames({"threads"})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

// A square block of quads whose inner vertices are moved by up to `shake` of an edge along each axis.
Mesh shaken_block(std::uint32_t side, double shake) {
  std::vector<double> x, y;
  std::vector<FaceCorners> faces;
  const auto id = [&](std::uint32_t i, std::uint32_t j) { return VertexId(j * (side + 1) + i); };
  for (std::uint32_t j = 0; j <= side; ++j)
    for (std::uint32_t i = 0; i <= side; ++i) {
      const bool inner = i > 0 && j > 0 && i < side && j < side;
      const std::size_t number = x.size();
      x.push_back(i + (inner ? shake * (2 * uniform01(1, number) - 1) : 0));
      y.push_back(j + (inner ? shake * (2 * uniform01(2, number) - 1) : 0));
      if (i > 0 && j > 0) faces.push_back({id(i - 1, j - 1), id(i, j - 1), id(i, j), id(i - 1, j)});
    }
  return build_mesh(std::move(x), std::move(y), faces);
}

// Arguments: inner vertices along a side; tenths of an edge by which they are moved (3: valid, 10: tangled).
void smooth_region(benchmark::State& state) {
  const auto side = static_cast<std::uint32_t>(state.range(0)) + 1;
  Mesh mesh = shaken_block(side, 0.1 * static_cast<double>(state.range(1)));
  std::vector<VertexId> inner;
  std::vector<Vec2> places;
  for (const VertexId v : mesh.vertices())
    if (!mesh.on_boundary(v)) {
      inner.push_back(v);
      places.push_back(mesh.point(v));
    }
  const PlaneModel plane;
  LocalSmoother<PlaneModel> smoother(plane);
  MeshEditor editor(mesh);
  for (auto _ : state) {
    for (std::size_t i = 0; i < inner.size(); ++i) mesh.set_point(inner[i], places[i]);
    benchmark::DoNotOptimize(smoother.run(editor, inner, {}));
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) *
                          static_cast<std::int64_t>(inner.size()));
}

BENCHMARK(smooth_region)
    ->ArgsProduct({{3, 11, 39}, {3, 10}})
    ->ArgNames({"side", "shake"})
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace quarry
