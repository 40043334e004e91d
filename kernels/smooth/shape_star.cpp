#include "kernels/smooth/shape_star.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace quarry {
namespace {

// Triangles cost as much as the three corners of a quad that a move of the vertex changes would, if regular.
constexpr double kTriangleWeight = 3.0 / 3.46410161513775459;

// The cost of one corner is squares / d; both with their derivatives by the place of the vertex.
struct Corner {
  double squares;
  Vec2 squares_slope;
  double squares_curvature;  // in every direction
  double d;
  Vec2 d_slope;
};

// Calls visit(Corner) for each corner of the face that changes with the vertex.
template <class Visit>
inline void for_each_corner(const ShapeFace& face, Vec2 offset, const CornerStretch& stretch,
                            const Visit& visit) {
  const Vec2 out = face.next - offset;
  const Vec2 back = face.previous - offset;
  const double oo = squared_length(out);
  const double bb = squared_length(back);
  const double d = cross(out, back);
  const Vec2 d_slope{face.next.y - face.previous.y, face.previous.x - face.next.x};
  if (!face.quad) {
    visit(Corner{kTriangleWeight * (oo + bb + face.far_next_squared), -2 * kTriangleWeight * (out + back),
                 4 * kTriangleWeight, d, d_slope});
    return;
  }
  double r = stretch.here;
  double inverse = 1 / r;
  visit(Corner{inverse * oo + r * bb, -2 * (inverse * out + r * back), 2 * (inverse + r), d, d_slope});
  r = stretch.next;
  inverse = 1 / r;
  visit(Corner{inverse * oo + r * face.far_next_squared, (-2 * inverse) * out, 2 * inverse,
               cross(out, face.far_next), Vec2{-face.far_next.y, face.far_next.x}});
  r = stretch.previous;
  visit(Corner{r * bb + face.far_previous_squared / r, (-2 * r) * back, 2 * r, cross(back, face.far_previous),
               Vec2{-face.far_previous.y, face.far_previous.x}});
}

// chi with its derivatives divided by it.
struct Chi {
  double value, slope, curvature;
};

Chi regularised(double d, double eps) {
  const double root = std::sqrt(d * d + eps * eps);
  // Without cancellation on either side.
  const double value = d > 0 ? 0.5 * (d + root) : 0.5 * eps * eps / (root - d);
  return {value, 1 / root, 0.5 * eps * eps / (root * root * root * value)};
}

double regularised_value(double d, double eps) {
  const double root = std::sqrt(d * d + eps * eps);
  return d > 0 ? 0.5 * (d + root) : 0.5 * eps * eps / (root - d);
}

// squares / chi and its derivatives.
void add_cost(const Corner& c, const Chi& chi, double size, double area, Quadratic& sum) {
  const double inverse = 1 / chi.value;
  const double cost = (c.squares + size * area) * inverse;
  const double pull = size / area;
  const Vec2 slope = inverse * c.squares_slope;
  sum.value += cost + pull * c.d;
  sum.gradient = sum.gradient + slope - (cost * chi.slope - pull) * c.d_slope;
  const double square = cost * (2 * chi.slope * chi.slope - chi.curvature);
  const double mixed = -chi.slope;
  const double round = inverse * c.squares_curvature;
  sum.xx += round + c.d_slope.x * (2 * mixed * slope.x + square * c.d_slope.x);
  sum.yy += round + c.d_slope.y * (2 * mixed * slope.y + square * c.d_slope.y);
  sum.xy += mixed * (slope.x * c.d_slope.y + slope.y * c.d_slope.x) + square * c.d_slope.x * c.d_slope.y;
}

// Edges and corners of a face with the vertex somewhere; of the corners those that move with it.
struct FaceMeasures {
  double out, back, far_next, far_previous;  // squared lengths
  std::array<double, 3> d, lengths;          // at the vertex, at `next`, at `previous`: |e1|^2 |e2|^2

  FaceMeasures(const ShapeFace& face, Vec2 offset) {
    const Vec2 to_next = face.next - offset;
    const Vec2 to_previous = face.previous - offset;
    out = squared_length(to_next);
    back = squared_length(to_previous);
    far_next = face.far_next_squared;
    far_previous = face.far_previous_squared;
    d = {cross(to_next, to_previous), cross(to_next, face.far_next), cross(to_previous, face.far_previous)};
    lengths = {out * back, out * far_next, back * far_previous};
  }

  // Whether a corner has a sine below the one given (not negative).
  [[nodiscard]] bool below(double sine) const {
    bool result = false;
    for (std::size_t k = 0; k < 3; ++k) result |= d[k] * std::abs(d[k]) < sine * sine * lengths[k];
    return result;
  }
  // s |s| of the smallest sine s.
  [[nodiscard]] double smallest() const {
    double smallest = 1;
    for (std::size_t k = 0; k < 3; ++k)
      smallest = std::min(smallest, lengths[k] > 0 ? d[k] * std::abs(d[k]) / lengths[k] : -1.0);
    return smallest;
  }
  [[nodiscard]] double shortest() const {
    return std::min(std::min(out, back), std::min(far_next, far_previous));
  }
  [[nodiscard]] double longest() const {
    return std::max(std::max(out, back), std::max(far_next, far_previous));
  }
  // The arithmetic by the harmonic mean of the squared lengths, times 16. Unlike the extremes it tells that
  // one end of a thin face has become wider.
  [[nodiscard]] double spread() const {
    return (out + back + far_next + far_previous) * (1 / out + 1 / back + 1 / far_next + 1 / far_previous);
  }
};

}  // namespace

ShapeFace& ShapeStar::add() {
  if (count_ == faces_.size()) faces_.emplace_back();
  return faces_[count_++];
}

void ShapeStar::add_quad(Vec2 next, Vec2 opposite, Vec2 previous, double area) {
  ShapeFace& face = add();
  face.next = next;
  face.previous = previous;
  face.far_next = opposite - next;
  face.far_previous = previous - opposite;
  face.far_next_squared = squared_length(face.far_next);
  face.far_previous_squared = squared_length(face.far_previous);
  face.area = area;
  face.stretch = {};
  face.quad = true;
}

void ShapeStar::add_triangle(Vec2 next, Vec2 previous, double area) {
  ShapeFace& face = add();
  face.next = next;
  face.previous = previous;
  face.far_next = previous - next;
  face.far_previous = face.far_next;
  face.far_next_squared = squared_length(face.far_next);
  face.far_previous_squared = face.far_next_squared;
  face.area = area;
  face.stretch = {};
  face.quad = false;
}

void ShapeStar::follow_stretch() {
  following_ = true;
  for (ShapeFace& face : std::span(faces_).first(count_)) face.stretch = stretch_at(face, {});
}

CornerStretch ShapeStar::stretch_at(const ShapeFace& face, Vec2 offset) const {
  if (!face.quad) return {};
  // The square roots of ratios of squared lengths.
  const double limit = target_.largest_aspect * target_.largest_aspect;
  const auto aspect = [&](double along, double across) {
    return std::sqrt(std::clamp(along / across, 1 / limit, limit));
  };
  const Vec2 out = face.next - offset;
  const Vec2 back = face.previous - offset;
  if (target_.stretch == Stretch::kOfCorner) {
    const double oo = squared_length(out);
    const double bb = squared_length(back);
    return {aspect(oo, bb), aspect(oo, face.far_next_squared), aspect(face.far_previous_squared, bb)};
  }
  // The lines between the middles of opposite edges.
  const double one = aspect(squared_length(out - face.far_previous), squared_length(back + face.far_next));
  return {one, one, one};
}

bool ShapeStar::has_corner_below(double sine) const {
  return std::any_of(faces().begin(), faces().end(),
                     [&](const ShapeFace& face) { return FaceMeasures(face, {}).below(sine); });
}

double ShapeStar::mean_squared_edge() const {
  double sum = 0;
  for (const ShapeFace& face : faces()) sum += squared_length(face.next) + squared_length(face.previous);
  return sum / static_cast<double>(2 * count_);
}

double ShapeStar::value(Vec2 offset, double eps) const {
  double sum = 0;
  bool positive = true;
  for (const ShapeFace& face : faces()) {
    const double added = target_.size_weight * face.area;
    const double pull = target_.size_weight / face.area;
    const CornerStretch stretch = following_ ? stretch_at(face, offset) : face.stretch;
    for_each_corner(face, offset, stretch, [&](const Corner& c) {
      positive = positive && c.d > 0;
      sum += (c.squares + added) / (eps > 0 ? regularised_value(c.d, eps) : c.d) + pull * c.d;
    });
  }
  return eps > 0 || positive ? sum : std::numeric_limits<double>::infinity();
}

Quadratic ShapeStar::expand(double eps) const {
  Quadratic sum;
  bool positive = true;
  for (const ShapeFace& face : faces()) {
    for_each_corner(face, {}, face.stretch, [&](const Corner& c) {
      positive = positive && c.d > 0;
      const Chi chi = eps > 0 ? regularised(c.d, eps) : Chi{c.d, 1 / c.d, 0};
      add_cost(c, chi, target_.size_weight, face.area, sum);
    });
  }
  if (!positive && !(eps > 0)) sum.value = std::numeric_limits<double>::infinity();
  return sum;
}

bool ShapeStar::keeps(Vec2 offset, double floor, double largest_edge_ratio) const {
  const double ratio = largest_edge_ratio * largest_edge_ratio;
  for (const ShapeFace& face : faces()) {
    const FaceMeasures after(face, offset);
    const bool flat = after.below(floor);
    const bool long_drawn = after.longest() > ratio * after.shortest();
    if (!flat && !long_drawn) continue;
    const FaceMeasures before(face, {});
    if (flat && after.smallest() < before.smallest()) return false;
    if (long_drawn && after.spread() > before.spread()) return false;
  }
  return true;
}

}  // namespace quarry
