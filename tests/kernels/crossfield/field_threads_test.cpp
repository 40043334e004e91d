#include <bit>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "engine/parallel/parallel.hpp"
#include "kernels/crossfield/position_field.hpp"
#include "tests/kernels/crossfield/field_meshes.hpp"

namespace quarry {
namespace {

TEST(FieldThreads, GiveTheSameBytesOnAnyNumber) {
  const Mesh mesh = test::sphere_mesh(5);
  std::vector<std::uint64_t> serial;
  for (const int threads : {1, 2, 4, 7}) {
    const parallel::ParticipationProbe probe;
    parallel::with_threads(threads, [&] {
      const auto levels =
          field_levels(finest_level(mesh, std::vector<std::uint8_t>(mesh.vertex_slots())), 16);
      const std::vector<Vec3> crosses = cross_field(levels, {}, {});
      const std::vector<Vec3> places =
          position_field(levels, crosses, std::vector<double>(mesh.vertex_slots(), 0.07),
                         std::vector<Vec3>(mesh.vertex_slots()), {});
      std::vector<std::uint64_t> bits;
      for (const auto* field : {&crosses, &places})
        for (const Vec3 p : *field)
          for (const double x : {p.x, p.y, p.z}) bits.push_back(std::bit_cast<std::uint64_t>(x));
      if (threads == 1) serial = bits;
      EXPECT_EQ(bits, serial) << threads;
    });
    if (threads > 1) {
      EXPECT_GT(probe.chunks_of_other_threads(), 0U);
    }
  }
}

}  // namespace
}  // namespace quarry
