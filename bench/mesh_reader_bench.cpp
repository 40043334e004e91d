// Reading of surfaces of a million triangles: triangles a second, by format and threads, and by assimp where
// it is at hand. Files lie in the system's temporary folder and are read once before they are timed.
#include <benchmark/benchmark.h>

#include "bench/surface_files.hpp"
#include "bench/thread_counts.hpp"
#include "engine/parallel/parallel.hpp"
#include "io/mesh/mesh_format.hpp"
#ifdef QUARRY_ASSIMP
#include "bench/assimp_peer.hpp"
#endif

namespace quarry {
namespace {

const bench::SurfaceFiles& surface_files() {
  static const bench::SurfaceFiles files;
  return files;
}

// Times read(), which returns the number of faces.
template <class Read>
void time_reading(benchmark::State& state, Read&& read) {
  for (auto _ : state)
    if (read() != bench::SurfaceFiles::kTriangles) state.SkipWithError("triangles are missing");
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(bench::SurfaceFiles::kTriangles));
}

// Argument: threads.
void quarry_reads(benchmark::State& state, const char* name) {
  const std::string path = surface_files().path(name);
  parallel::with_threads(static_cast<int>(state.range(0)),
                         [&] { time_reading(state, [&] { return read_cells(path).faces.size(); }); });
}

#define QUARRY_READS(tag, file)               \
  BENCHMARK_CAPTURE(quarry_reads, tag, file)  \
      ->ArgsProduct({bench::thread_counts()}) \
      ->ArgNames({"threads"})                 \
      ->UseRealTime()                         \
      ->Unit(benchmark::kMillisecond)

QUARRY_READS(binary_ply, "binary.ply");
QUARRY_READS(text_ply, "text.ply");
QUARRY_READS(binary_stl, "binary.stl");
QUARRY_READS(text_stl, "text.stl");
QUARRY_READS(obj, "text.obj");
QUARRY_READS(off, "text.off");

#ifdef QUARRY_ASSIMP
void assimp_reads(benchmark::State& state, const char* name, bool weld) {
  const std::string path = surface_files().path(name);
  time_reading(state, [&] { return bench::read_with_assimp(path, weld); });
}

#define ASSIMP_READS(tag, file, weld) \
  BENCHMARK_CAPTURE(assimp_reads, tag, file, weld)->UseRealTime()->Unit(benchmark::kMillisecond)

ASSIMP_READS(binary_ply, "binary.ply", false);
ASSIMP_READS(text_ply, "text.ply", false);
ASSIMP_READS(binary_stl, "binary.stl", true);
ASSIMP_READS(binary_stl_not_welded, "binary.stl", false);
ASSIMP_READS(text_stl, "text.stl", true);
ASSIMP_READS(text_stl_not_welded, "text.stl", false);
ASSIMP_READS(obj, "text.obj", false);
ASSIMP_READS(off, "text.off", false);
#endif

}  // namespace
}  // namespace quarry
