// Writing of meshes of a quarter of a million quads: quads a second, by format and threads. Files go to the
// system's temporary folder.
#include <cstdint>
#include <filesystem>
#include <string>

#include <benchmark/benchmark.h>
#include <unistd.h>

#include "bench/thread_counts.hpp"
#include "bench/wavy_mesh.hpp"
#include "engine/parallel/parallel.hpp"
#include "io/mesh/mesh_format.hpp"

namespace quarry {
namespace {

constexpr std::uint32_t kSide = 512;

// Argument: threads.
void quarry_writes(benchmark::State& state, const char* extension) {
  static const Mesh mesh = bench::wavy_mesh(kSide, bench::WavyFaces::kQuads);
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
