#include "kernels/crossfield/spacing_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "engine/parallel/parallel.hpp"
#include "kernels/crossfield/cross_field.hpp"

namespace quarry {
namespace {

// Half the cotangent of 60 degrees, what a triangle gives to the weight of each of its edges; and the third
// of the area of an equilateral triangle of edge 1.
const double kWeight = 0.5 / std::sqrt(3.0);
const double kArea = std::sqrt(3.0) / 12;

// The angle by which the crosses turn along each side of a triangle, less a third of what it makes around it.
std::array<double, 3> turns_of(const Mesh& mesh, const FieldLevel& level, std::span<const Vec3> directions,
                               FaceId f) {
  std::array<double, 3> turns{};
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    const std::size_t i = mesh.corner(f, k).value();
    const std::size_t j = mesh.corner(f, (k + 1) % 3).value();
    std::uint32_t e = level.first[i];
    while (level.other[e] != j) ++e;
    const Vec2 theirs = complex_product(level.turn[e], cross_number(level, j, directions[j]));
    const Vec2 turn = complex_product(conjugate(cross_number(level, i, directions[i])), theirs);
    turns[static_cast<std::size_t>(k)] = 0.25 * std::atan2(turn.y, turn.x);
    sum += turns[static_cast<std::size_t>(k)];
  }
  for (double& turn : turns) turn -= sum / 3;
  return turns;
}

constexpr int kMeanRounds = 3;

class ScreenedLaplacian {
 public:
  ScreenedLaplacian(const Mesh& mesh, double reach) : mesh_(mesh), screen_(1 / (reach * reach)) {}

  // The product with x at a vertex, and the entry of the diagonal there.
  [[nodiscard]] double product(std::span<const double> x, std::size_t i) const {
    const double here = x[i];
    double sum = 0;
    for_each_side_around(mesh_, VertexId(i), [&](SideId s) {
      const double a = x[mesh_.target(s).value()];
      const double b = x[mesh_.origin(mesh_.previous(s)).value()];
      sum += kWeight * (2 * here - a - b) + screen_ * kArea * here;
    });
    return sum;
  }

 private:
  const Mesh& mesh_;
  double screen_;
};

double dot_product(std::span<const double> a, std::span<const double> b) {
  return parallel::reduce_ordered(
      a.size(), 0.0,
      [&](std::size_t begin, std::size_t end) {
        double sum = 0;
        for (std::size_t i = begin; i < end; ++i) sum += a[i] * b[i];
        return sum;
      },
      [](double x, double y) { return x + y; });
}

// Shifts the logarithms such that as many squares have room as with none, and limits them. Triangles of one
// size are taken for granted: each vertex stands for as much area as another.
void limit_about_mean(const Mesh& mesh, double most, std::vector<double>& logarithms) {
  for (int round = 0; round < kMeanRounds; ++round) {
    double squares = 0;
    for (const VertexId v : mesh.vertices())
      if (mesh.alive(v)) squares += std::exp(-2 * logarithms[v.value()]);
    const double shift = 0.5 * std::log(squares / static_cast<double>(mesh.count_alive_vertices()));
    for (const VertexId v : mesh.vertices())
      if (mesh.alive(v)) logarithms[v.value()] = std::clamp(logarithms[v.value()] + shift, -most, most);
  }
}

}  // namespace

std::vector<double> spacing_sources(const Mesh& mesh, const FieldLevel& level,
                                    std::span<const Vec3> directions) {
  std::vector<std::array<double, 3>> turns(mesh.face_slots());
  parallel::for_each(turns.size(), [&](std::size_t f) {
    if (mesh.alive(FaceId(f))) turns[f] = turns_of(mesh, level, directions, FaceId(f));
  });
  std::vector<double> sources(mesh.vertex_slots());
  parallel::for_each(sources.size(), [&](std::size_t i) {
    if (!mesh.alive(VertexId(i))) return;
    for_each_side_around(mesh, VertexId(i), [&](SideId s) {
      const auto across = static_cast<std::size_t>((s.index() + 1) % 3);
      sources[i] -= 0.5 * turns[s.face().value()][across];
    });
  });
  return sources;
}

std::vector<double> spacing_field(const Mesh& mesh, std::span<const double> sources,
                                  const SpacingFieldOptions& options) {
  const std::size_t size = mesh.vertex_slots();
  const ScreenedLaplacian matrix(mesh, options.reach);
  std::vector<double> x(size), residual(size), step(size), image(size);
  parallel::for_each(size, [&](std::size_t i) {
    if (mesh.alive(VertexId(i))) residual[i] = step[i] = sources[i];
  });
  double now = dot_product(residual, residual);
  const double enough = options.accuracy * options.accuracy * now;
  for (int k = 0; k < options.steps && now > enough; ++k) {
    parallel::for_each(size, [&](std::size_t i) {
      if (mesh.alive(VertexId(i))) image[i] = matrix.product(step, i);
    });
    const double along = now / dot_product(step, image);
    parallel::for_each(size, [&](std::size_t i) {
      x[i] += along * step[i];
      residual[i] -= along * image[i];
    });
    const double next = dot_product(residual, residual);
    parallel::for_each(size, [&](std::size_t i) { step[i] = residual[i] + next / now * step[i]; });
    now = next;
  }
  limit_about_mean(mesh, options.most, x);
  return x;
}

}  // namespace quarry
