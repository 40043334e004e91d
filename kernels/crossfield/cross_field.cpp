#include "kernels/crossfield/cross_field.hpp"

#include <cmath>
#include <cstdint>

#include "engine/parallel/parallel.hpp"
#include "kernels/crossfield/direct_field.hpp"

namespace quarry {
namespace {

using Crosses = std::vector<Vec2>;

Vec2 unit_or(Vec2 z, Vec2 otherwise) {
  const double size = length(z);
  return size > 0 ? (1 / size) * z : otherwise;
}

// One of Gauss-Seidel, class by class, with crosses of length 1: as they fade towards singularities in the
// linear problem, they turn more beside them than they have to.
void sweep(const FieldLevel& level, Crosses& z) {
  for (const auto& members : level.classes)
    parallel::for_each(
        members.size(),
        [&](std::size_t k) {
          const std::uint32_t i = members[k];
          Vec2 sum;
          for (std::uint32_t e = level.first[i]; e < level.first[i + 1]; ++e)
            sum = sum + complex_product(level.turn[e], z[level.other[e]]);
          z[i] = unit_or(sum, z[i]);
        },
        kFieldChunk);
}

// What is given, from the finest level to the coarser ones: such vertices have themselves alone as a child.
std::vector<Crosses> given_crosses(std::span<const FieldLevel> levels, std::span<const Vec3> directions) {
  std::vector<Crosses> crosses(levels.size());
  for (std::size_t l = 0; l < levels.size(); ++l) {
    const FieldLevel& level = levels[l];
    crosses[l].resize(level.size());
    parallel::for_each(level.size(), [&](std::size_t i) {
      if (level.given[i] == 0) return;
      crosses[l][i] = l == 0 ? cross_number(level, i, directions[i]) : crosses[l - 1][level.children[i][0]];
    });
  }
  return crosses;
}

}  // namespace

Vec2 cross_number(const FieldLevel& level, std::size_t i, Vec3 direction) {
  const Vec3 e = level.axes[i];
  const Vec2 once{dot(direction, e), dot(direction, cross(level.normals[i], e))};
  const Vec2 twice = complex_product(once, once);
  const Vec2 four = complex_product(twice, twice);
  const double size = length(four);
  return size > 0 ? (1 / size) * four : Vec2{1, 0};
}

Vec3 cross_direction(const FieldLevel& level, std::size_t i, Vec2 number) {
  const double angle = 0.25 * std::atan2(number.y, number.x);
  const Vec3 e = level.axes[i];
  return std::cos(angle) * e + std::sin(angle) * cross(level.normals[i], e);
}

std::vector<Vec3> cross_field(std::span<const FieldLevel> levels, std::span<const Vec3> directions,
                              const CrossFieldOptions& options) {
  std::vector<Crosses> crosses = given_crosses(levels, directions);
  std::size_t top = 0;
  while (top + 1 < levels.size() && levels[top].free_size() > options.coarsest) ++top;
  solve_directly(levels[top], options.inverse_iterations, crosses[top]);
  for (std::size_t l = top; l-- > 0;) {
    const FieldLevel& level = levels[l];
    parallel::for_each(level.size(), [&](std::size_t i) {
      if (level.given[i] == 0)
        crosses[l][i] =
            unit_or(complex_product(level.from_parent[i], crosses[l + 1][level.parent[i]]), {1, 0});
    });
    for (int s = 0; s < options.sweeps; ++s) sweep(level, crosses[l]);
  }
  std::vector<Vec3> result(levels[0].size());
  parallel::for_each(result.size(),
                     [&](std::size_t i) { result[i] = cross_direction(levels[0], i, crosses[0][i]); });
  return result;
}

}  // namespace quarry
