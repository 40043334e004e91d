#include "kernels/initial/delaunay.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/random.hpp"
#include "engine/mesh/compact.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/initial/triangulation.hpp"

namespace quarry {
namespace {

// Rows of equilateral triangles are this share of their side apart.
constexpr double kRowHeight = 0.8660254037844386;
// Rows and columns beyond the box on each side.
constexpr std::int64_t kMargin = 2;

// Rows of points about a center, alternately shifted by half a column to either side.
struct HexagonalLattice {
  Vec2 center;
  double cosine = 1, sine = 0;
  double column_width = 1, row_height = 1;
  std::int64_t columns = 1, rows = 1;  // points a row, rows

  [[nodiscard]] Vec2 point(std::int64_t column, std::int64_t row, Vec2 shift) const {
    const double half_row = 0.5 * static_cast<double>(rows - 1);
    const double half_column = 0.5 * static_cast<double>(columns - 1);
    const double x =
        (static_cast<double>(column) - half_column + (row % 2 == 0 ? -0.25 : 0.25)) * column_width;
    const double y = (static_cast<double>(row) - half_row) * row_height;
    const Vec2 r = Vec2{x, y} + shift;
    return {center.x + (cosine * r.x - sine * r.y), center.y + (sine * r.x + cosine * r.y)};
  }
};

HexagonalLattice make_lattice(const Box2& box, const DelaunayOptions& options) {
  // The lattice turned by 60 degrees is the same lattice.
  const double angle = std::remainder(options.angle_degrees, 60.0) * std::numbers::pi / 180;
  HexagonalLattice lattice;
  lattice.center = box.center();
  lattice.cosine = std::cos(angle);
  lattice.sine = std::sin(angle);
  const double width = box.width() * lattice.cosine + box.height() * std::abs(lattice.sine);
  const double height = box.height() * lattice.cosine + box.width() * std::abs(lattice.sine);
  const std::int64_t row_steps =
      std::max<std::int64_t>(1, std::llround(height / (kRowHeight * options.spacing)));
  const std::int64_t column_steps = std::max<std::int64_t>(1, std::llround(width / options.spacing));
  lattice.row_height = height > 0 ? height / static_cast<double>(row_steps) : kRowHeight * options.spacing;
  lattice.column_width = width > 0 ? width / static_cast<double>(column_steps) : options.spacing;
  lattice.rows = row_steps + 1 + 2 * kMargin;
  lattice.columns = column_steps + 2 + 2 * kMargin;
  return lattice;
}

}  // namespace

std::vector<Vec2> make_spaced_points(const Box2& box, const DelaunayOptions& options) {
  const HexagonalLattice lattice = make_lattice(box, options);
  std::vector<Vec2> points(static_cast<std::size_t>(lattice.columns * lattice.rows));
  parallel::for_each(points.size(), [&](std::size_t i) {
    const std::int64_t column = static_cast<std::int64_t>(i) % lattice.columns;
    const std::int64_t row = static_cast<std::int64_t>(i) / lattice.columns;
    const bool outermost =
        column == 0 || column + 1 == lattice.columns || row == 0 || row + 1 == lattice.rows;
    // The area of a disc is filled evenly.
    const double radius =
        outermost ? 0 : options.jitter * options.spacing * std::sqrt(uniform01(options.seed, 2 * i));
    const double turn = 2 * std::numbers::pi * uniform01(options.seed, 2 * i + 1);
    points[i] = lattice.point(column, row, {radius * std::cos(turn), radius * std::sin(turn)});
  });
  return points;
}

Mesh make_delaunay(const Box2& box, const DelaunayOptions& options) {
  Mesh mesh = delaunay_triangulation(make_spaced_points(box, options));
  compact(mesh, EntityOrder::kHilbert);
  return mesh;
}

double count_delaunay_triangles(const Box2& box, const DelaunayOptions& options) {
  const HexagonalLattice lattice = make_lattice(box, options);
  return 2.0 * static_cast<double>(lattice.columns) * static_cast<double>(lattice.rows);
}

}  // namespace quarry
