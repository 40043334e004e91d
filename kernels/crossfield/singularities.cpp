#include "kernels/crossfield/singularities.hpp"

#include <cmath>
#include <numbers>

#include "engine/parallel/parallel.hpp"
#include "kernels/crossfield/cross_field.hpp"

namespace quarry {
namespace {

double argument(Vec2 z) { return std::atan2(z.y, z.x); }

// The number by which a cross at j is multiplied when it is carried to i.
Vec2 turn_between(const FieldLevel& level, std::size_t i, std::size_t j) {
  std::uint32_t e = level.first[i];
  while (level.other[e] != j) ++e;
  return level.turn[e];
}

// The sum of the angles from vertex to vertex is a whole number of turns, less what the surface turns a cross
// by that is carried around the triangle.
int quarter_turns(const Mesh& mesh, const FieldLevel& level, std::span<const Vec3> directions, FaceId f) {
  double sum = 0;
  Vec2 around{1, 0};
  for (int k = 0; k < 3; ++k) {
    const std::size_t i = mesh.corner(f, k).value();
    const std::size_t j = mesh.corner(f, (k + 1) % 3).value();
    const Vec2 turn = turn_between(level, i, j);
    const Vec2 theirs = complex_product(turn, cross_number(level, j, directions[j]));
    sum += argument(complex_product(conjugate(cross_number(level, i, directions[i])), theirs));
    around = complex_product(around, turn);
  }
  return static_cast<int>(std::lround((sum - argument(around)) / (2 * std::numbers::pi)));
}

}  // namespace

std::vector<Singularity> find_singularities(const Mesh& mesh, const FieldLevel& level,
                                            std::span<const Vec3> directions) {
  const auto turns = [&](std::size_t f) {
    return mesh.alive(FaceId(f)) ? quarter_turns(mesh, level, directions, FaceId(f)) : 0;
  };
  std::vector<Singularity> found;
  for (const std::uint32_t f :
       parallel::filter_indices(mesh.face_slots(), [&](std::size_t i) { return turns(i) != 0; }))
    found.push_back({FaceId(f), turns(f)});
  return found;
}

}  // namespace quarry
