// Fields on a wavy surface of triangles, each kernel on its own, in vertices a second.
#include <cstdint>
#include <vector>

#include <benchmark/benchmark.h>

#include "bench/thread_counts.hpp"
#include "bench/wavy_mesh.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/crossfield/cross_field.hpp"
#include "kernels/crossfield/field_levels.hpp"
#include "kernels/crossfield/position_field.hpp"
#include "kernels/crossfield/spacing_field.hpp"

namespace quarry {
namespace {

constexpr std::uint32_t kSide = 400;
constexpr std::size_t kFewestVertices = 16;

// Nothing is given: the first mode of the whole surface is looked for.
struct Fields {
  Mesh mesh = bench::wavy_mesh(kSide, bench::WavyFaces::kTriangles);
  FieldLevel finest = finest_level(mesh, std::vector<std::uint8_t>(mesh.vertex_slots(), 0), {});
  std::vector<FieldLevel> levels = field_levels(finest, kFewestVertices);
  std::vector<Vec3> none = std::vector<Vec3>(mesh.vertex_slots());
  std::vector<Vec3> crosses = cross_field(levels, none, {});
};

const Fields& fields() {
  static const Fields made;
  return made;
}

// Argument: threads. run() works on all vertices once.
template <class Run>
void time_field(benchmark::State& state, const Run& run) {
  const Fields& given = fields();
  parallel::with_threads(static_cast<int>(state.range(0)), [&] {
    for (auto _ : state) benchmark::DoNotOptimize(run(given));
  });
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(given.mesh.vertex_slots()));
}

void field_of_levels(benchmark::State& state) {
  time_field(state, [](const Fields& given) { return field_levels(given.finest, kFewestVertices); });
}
void field_of_crosses(benchmark::State& state) {
  time_field(state, [](const Fields& given) { return cross_field(given.levels, given.none, {}); });
}
void field_of_spacing(benchmark::State& state) {
  time_field(state, [](const Fields& given) {
    return spacing_field(given.mesh, spacing_sources(given.mesh, given.levels.front(), given.crosses), {});
  });
}
void field_of_positions(benchmark::State& state) {
  const std::vector<double> spacing(fields().mesh.vertex_slots(), 1.25);
  time_field(state, [&](const Fields& given) {
    return position_field(given.levels, given.crosses, spacing, given.none, {});
  });
}

#define FIELD(kernel)                         \
  BENCHMARK(kernel)                           \
      ->ArgsProduct({bench::thread_counts()}) \
      ->ArgNames({"threads"})                 \
      ->UseRealTime()                         \
      ->Unit(benchmark::kMillisecond)

FIELD(field_of_levels);
FIELD(field_of_crosses);
FIELD(field_of_spacing);
FIELD(field_of_positions);

}  // namespace
}  // namespace quarry
