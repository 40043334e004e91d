#include "kernels/initial/crisscross.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/mesh/build.hpp"
#include "engine/parallel/parallel.hpp"

namespace quarry {
namespace {

// Lattice lines i = -1 .. count + 1 of one axis; line 0 and line `count` run along the box.
struct Axis {
  double low, high;
  std::int64_t count;

  [[nodiscard]] double at(std::int64_t i) const {
    if (i == count) return high;
    return low + (high - low) * (static_cast<double>(i) / static_cast<double>(count));
  }
};

struct Lattice {
  Axis x, y;
  double cosine = 1, sine = 0;
  Vec2 center;

  [[nodiscard]] Vec2 point(std::int64_t i, std::int64_t j) const {
    const Vec2 p{x.at(i), y.at(j)};
    if (sine == 0) return p;
    const Vec2 r = p - center;
    return {center.x + cosine * r.x - sine * r.y, center.y + sine * r.x + cosine * r.y};
  }
};

Axis make_axis(double low, double high, double cell) {
  return {low, high, std::max<std::int64_t>(1, std::llround((high - low) / cell))};
}

Lattice make_lattice(const Box2& box, const CrisscrossOptions& options) {
  // A lattice turned by a quarter is the same lattice.
  const double angle = std::remainder(options.angle_degrees, 90.0) * std::numbers::pi / 180;
  if (angle == 0)
    return {make_axis(box.low.x, box.high.x, options.cell),
            make_axis(box.low.y, box.high.y, options.cell),
            1,
            0,
            {}};
  const double cosine = std::cos(angle);
  const double sine = std::sin(angle);
  const Vec2 center = box.center();
  const double half_width = 0.5 * (box.width() * cosine + box.height() * std::abs(sine));
  const double half_height = 0.5 * (box.height() * cosine + box.width() * std::abs(sine));
  return {make_axis(center.x - half_width, center.x + half_width, options.cell),
          make_axis(center.y - half_height, center.y + half_height, options.cell), cosine, sine, center};
}

// The cells of a lattice, in rows. Cell c has the faces 2c, which has the bottom side, and 2c + 1, which has
// the top.
struct Cells {
  std::uint32_t columns, rows;

  // The diagonal joins the lower left and the upper right corner; else the other two.
  [[nodiscard]] static bool rising(std::uint32_t i, std::uint32_t j) { return (i + j) % 2 == 0; }
  [[nodiscard]] FaceId lower(std::uint32_t i, std::uint32_t j) const { return FaceId(2 * (j * columns + i)); }
  [[nodiscard]] FaceId upper(std::uint32_t i, std::uint32_t j) const {
    return FaceId(2 * (j * columns + i) + 1);
  }

  [[nodiscard]] SideId bottom(std::uint32_t i, std::uint32_t j) const { return {lower(i, j), 0}; }
  [[nodiscard]] SideId top(std::uint32_t i, std::uint32_t j) const { return {upper(i, j), 1}; }
  [[nodiscard]] SideId right(std::uint32_t i, std::uint32_t j) const {
    return rising(i, j) ? SideId(lower(i, j), 1) : SideId(upper(i, j), 0);
  }
  [[nodiscard]] SideId left(std::uint32_t i, std::uint32_t j) const {
    return rising(i, j) ? SideId(upper(i, j), 2) : SideId(lower(i, j), 2);
  }
};

// Corners counter-clockwise: rising cells (a, b, c) and (a, c, d), falling cells (a, b, d) and (b, c, d),
// with a the lower left corner, b the lower right, c the upper right, d the upper left.
void fill_cell(Mesh& mesh, const Cells& cells, std::uint32_t i, std::uint32_t j) {
  const std::uint32_t stride = cells.columns + 1;
  const VertexId a(j * stride + i), b(a.value() + 1), d(a.value() + stride), c(d.value() + 1);
  const FaceId lower = cells.lower(i, j);
  const FaceId upper = cells.upper(i, j);
  const bool rising = Cells::rising(i, j);
  const std::array<VertexId, 3> lower_corners = {a, b, rising ? c : d};
  const std::array<VertexId, 3> upper_corners = {rising ? a : b, c, d};
  for (int k = 0; k < 3; ++k) {
    mesh.set_corner(SideId(lower, k), lower_corners[static_cast<std::size_t>(k)]);
    mesh.set_corner(SideId(upper, k), upper_corners[static_cast<std::size_t>(k)]);
  }
  const SideId below(lower, rising ? 2 : 1);
  const SideId above(upper, rising ? 0 : 2);
  mesh.set_neighbour(below, above);
  mesh.set_neighbour(above, below);
  if (j > 0) mesh.set_neighbour(cells.bottom(i, j), cells.top(i, j - 1));
  if (j + 1 < cells.rows) mesh.set_neighbour(cells.top(i, j), cells.bottom(i, j + 1));
  if (i > 0) mesh.set_neighbour(cells.left(i, j), cells.right(i - 1, j));
  if (i + 1 < cells.columns) mesh.set_neighbour(cells.right(i, j), cells.left(i + 1, j));
}

}  // namespace

Mesh make_crisscross(const Box2& box, const CrisscrossOptions& options) {
  const Lattice lattice = make_lattice(box, options);
  const Cells cells{static_cast<std::uint32_t>(lattice.x.count + 2),
                    static_cast<std::uint32_t>(lattice.y.count + 2)};
  const std::size_t stride = std::size_t{cells.columns} + 1;
  Mesh mesh;
  mesh.grow_vertices(stride * (std::size_t{cells.rows} + 1));
  mesh.grow_faces(2 * std::size_t{cells.columns} * cells.rows);
  parallel::for_each(mesh.vertex_slots(), [&](std::size_t v) {
    mesh.set_point(VertexId(v), lattice.point(static_cast<std::int64_t>(v % stride) - 1,
                                              static_cast<std::int64_t>(v / stride) - 1));
  });
  parallel::for_each(std::size_t{cells.columns} * cells.rows, [&](std::size_t cell) {
    fill_cell(mesh, cells, static_cast<std::uint32_t>(cell % cells.columns),
              static_cast<std::uint32_t>(cell / cells.columns));
  });
  rebuild_sides_of_vertices(mesh);
  return mesh;
}

}  // namespace quarry
