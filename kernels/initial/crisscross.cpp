#include "kernels/initial/crisscross.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

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

}  // namespace

double count_crisscross_triangles(const Box2& box, const CrisscrossOptions& options) {
  const double width = std::max(1.0, box.width() / options.cell);
  const double height = std::max(1.0, box.height() / options.cell);
  return 2 * (width + 2) * (height + 2);
}

Mesh make_crisscross(const Box2& box, const CrisscrossOptions& options) {
  const Lattice lattice = make_lattice(box, options);
  const auto columns = static_cast<std::size_t>(lattice.x.count + 2);
  const auto rows = static_cast<std::size_t>(lattice.y.count + 2);
  const std::size_t stride = columns + 1;

  std::vector<double> x((columns + 1) * (rows + 1));
  std::vector<double> y(x.size());
  parallel::for_each(x.size(), [&](std::size_t v) {
    const Vec2 p =
        lattice.point(static_cast<std::int64_t>(v % stride) - 1, static_cast<std::int64_t>(v / stride) - 1);
    x[v] = p.x;
    y[v] = p.y;
  });

  std::vector<FaceCorners> faces(2 * columns * rows);
  parallel::for_each(columns * rows, [&](std::size_t cell) {
    const std::size_t i = cell % columns;
    const std::size_t j = cell / columns;
    const VertexId a(j * stride + i), b(j * stride + i + 1), c((j + 1) * stride + i + 1),
        d((j + 1) * stride + i);
    // The diagonal joins the vertices of even i + j: a and c, or b and d.
    if ((i + j) % 2 == 0) {
      faces[2 * cell] = {a, b, c, VertexId()};
      faces[2 * cell + 1] = {a, c, d, VertexId()};
    } else {
      faces[2 * cell] = {a, b, d, VertexId()};
      faces[2 * cell + 1] = {b, c, d, VertexId()};
    }
  });
  return build_mesh(std::move(x), std::move(y), faces);
}

}  // namespace quarry
