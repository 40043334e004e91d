#include "bench/point_sets.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include "bench/domains.hpp"
#include "engine/base/progress.hpp"
#include "engine/base/random.hpp"
#include "engine/mesh/compact.hpp"
#include "engine/mesh/constraint.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/initial/triangulation.hpp"
#include "kernels/matching/matching.hpp"

namespace quarry::bench {
namespace {

// One point in each cell of a grid. Those on the rim stay on the grid, so that the square is covered.
std::vector<Vec2> draw_in_cells(double triangles) {
  const auto side = static_cast<std::uint64_t>(std::sqrt(0.5 * triangles));
  std::vector<Vec2> points(side * side);
  for (std::uint64_t i = 0; i < points.size(); ++i) {
    const std::uint64_t row = i / side, column = i % side;
    const bool rim = row == 0 || column == 0 || row + 1 == side || column + 1 == side;
    const double reach = rim ? 0 : 0.95;
    points[i] = {static_cast<double>(column) + reach * (uniform01(1, 2 * i) - 0.5),
                 static_cast<double>(row) + reach * (uniform01(1, 2 * i + 1) - 0.5)};
  }
  return points;
}

// Gives the irregular valences that meshers give.
void relax(std::vector<Vec2>& points) {
  const Mesh mesh = delaunay_triangulation(points);
  const std::vector<Vec2> before = points;
  parallel::for_each(points.size(), [&](std::size_t i) {
    if (mesh.on_boundary(VertexId(i))) return;
    Vec2 sum;
    int count = 0;
    for_each_side_around(mesh, VertexId(i), [&](SideId s) {
      sum = sum + (before[mesh.target(s).value()] - before[i]);
      ++count;
    });
    points[i] = before[i] + (1.0 / count) * sum;
  });
}

Mesh triangles_of_cells(double triangles, int relaxations) {
  std::vector<Vec2> points = draw_in_cells(triangles);
  for (int round = 0; round < relaxations; ++round) relax(points);
  Mesh mesh = delaunay_triangulation(points);
  compact(mesh, EntityOrder::kHilbert);
  return mesh;
}

Mesh triangles_of_rows(double triangles, double jitter) {
  Mesh mesh = triangulate(Domain::kSquare, triangles, {.jitter = jitter});
  compact(mesh, EntityOrder::kHilbert);
  return mesh;
}

Mesh make_triangles(double triangles, PointSet points) {
  switch (points) {
    case PointSet::kRelaxed:
      return triangles_of_cells(triangles, 3);
    case PointSet::kJittered:
      return triangles_of_cells(triangles, 0);
    case PointSet::kShakenRows:
      return triangles_of_rows(triangles, 0.25);
    case PointSet::kRows:
      break;
  }
  return triangles_of_rows(triangles, 0.01);
}

}  // namespace

const char* name_of(PointSet points) {
  switch (points) {
    case PointSet::kRelaxed:
      return "random, relaxed";
    case PointSet::kJittered:
      return "random, one a cell";
    case PointSet::kShakenRows:
      return "hexagonal rows, shaken by 0.25";
    case PointSet::kRows:
      break;
  }
  return "hexagonal rows, shaken by 0.01";
}

Mesh even_triangles(double triangles, PointSet points) {
  Mesh mesh = make_triangles(triangles, points);
  auto tags = ConstraintTags::add_to(mesh);
  MatchingReport report;
  NodedLines lines;
  lines.line_begin.push_back(0);
  prepare_for_join(mesh, tags, lines, MatchingOptions(), report, Progress());
  return mesh;
}

}  // namespace quarry::bench
