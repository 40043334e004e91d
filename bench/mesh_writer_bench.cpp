// Writing of meshes of a quarter of a million quads: quads a second, by format and threads. Files go to the
// system's temporary folder.
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>
#include <unistd.h>

#include "bench/thread_counts.hpp"
#include "engine/mesh/build.hpp"
#include "engine/parallel/parallel.hpp"
#include "io/mesh/mesh_format.hpp"

namespace quarry {
namespace {

constexpr std::uint32_t kSide = 512;

Mesh waves() {
  std::vector<double> x, y, z;
  std::vector<FaceCorners> faces;
  for (std::uint32_t j = 0; j <= kSide; ++j)
    for (std::uint32_t i = 0; i <= kSide; ++i) {
      x.push_back(i + 0.3 * std::sin(j / 7.0));
      y.push_back(j + 0.3 * std::sin(i / 5.0));
      z.push_back(8 * std::sin(x.back() / 20) * std::cos(y.back() / 25));
    }
  for (std::uint32_t j = 0; j < kSide; ++j)
    for (std::uint32_t i = 0; i < kSide; ++i) {
      const VertexId a(j * (kSide + 1) + i), d(a.value() + kSide + 1);
      faces.push_back({a, VertexId(a.value() + 1), VertexId(d.value() + 1), d});
    }
  return build_mesh(std::move(x), std::move(y), std::move(z), faces);
}

// Argument: threads.
void quarry_writes(benchmark::State& state, const char* extension) {
  static const Mesh mesh = waves();
  const std::string path =
      (std::filesystem::temp_directory_path() / ("quarry_bench_" + std::to_string(::getpid()) + extension))
          .string();
  parallel::with_threads(static_cast<int>(state.range(0)), [&] {
    for (auto _ : state) write_mesh(path, mesh, {});
  });
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(mesh.face_slots()));
  std::filesystem::remove(path);
}

#define QUARRY_WRITES(tag)                        \
  BENCHMARK_CAPTURE(quarry_writes, tag, "." #tag) \
      ->ArgsProduct({bench::thread_counts()})     \
      ->ArgNames({"threads"})                     \
      ->UseRealTime()                             \
      ->Unit(benchmark::kMillisecond)

QUARRY_WRITES(vtu);
QUARRY_WRITES(msh);
QUARRY_WRITES(inp);
QUARRY_WRITES(obj);
QUARRY_WRITES(ply);
QUARRY_WRITES(stl);

}  // namespace
}  // namespace quarry
