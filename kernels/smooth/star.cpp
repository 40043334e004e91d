#include "kernels/smooth/star.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/geometry/predicates.hpp"

namespace quarry {
namespace {

// Sign and square of the sine between two edges of the given squared lengths.
double signed_square(double area, double lengths) {
  return lengths > 0 ? area * std::abs(area) / lengths : -1.0;
}

// 4 l_min / l_max, squared.
constexpr double kAspectGuard = 16.0;

}  // namespace

void Star::gather(const Mesh& mesh, VertexId v) {
  place_ = mesh.point(v);
  umbrella_ = {};
  shortest_squared_ = std::numeric_limits<double>::infinity();
  faces_.clear();
  corners_.clear();
  double joined = 0;
  const auto join = [&](Vec2 edge) {
    umbrella_ = umbrella_ + edge;
    joined += 1;
    shortest_squared_ = std::min(shortest_squared_, squared_length(edge));
  };
  const SideId first = mesh.side_of(v);
  for (SideId s = first; s.valid();) {
    Face face;
    const SideId forward = mesh.next(s);
    const SideId back = mesh.previous(s);
    const Vec2 next = mesh.point(mesh.origin(forward));
    const Vec2 previous = mesh.point(mesh.origin(back));
    face.quad = mesh.corner_count(s.face()) == 4;
    const Vec2 opposite = face.quad ? mesh.point(mesh.target(forward)) : previous;
    face.next = next - place_;
    face.previous = previous - place_;
    face.opposite = opposite - place_;
    const Vec2 a = opposite - next;
    const Vec2 b = previous - opposite;
    const double aa = squared_length(a);
    const double bb = squared_length(b);
    face.opposite_corner = face.quad ? signed_square(cross(a, b), aa * bb) : 1.0;
    face.shortest = face.quad ? std::min(aa, bb) : aa;
    face.longest = face.quad ? std::max(aa, bb) : aa;
    faces_.push_back(face);
    corners_.insert(corners_.end(), {next, opposite, previous});
    join(face.next);
    s = mesh.neighbour(back);
    if (!s.valid()) join(face.previous);
    if (s == first) break;
  }
  umbrella_ = (1.0 / joined) * umbrella_;
}

double Star::measure_quad(const Face& face, Vec2 offset) {
  const Vec2 out = face.next - offset;
  const Vec2 back = face.previous - offset;
  const double oo = squared_length(out);
  const double bb = squared_length(back);
  const Vec2 far_next = face.opposite - face.next;
  const Vec2 far_previous = face.previous - face.opposite;
  double worst = std::min(face.opposite_corner, signed_square(cross(out, back), oo * bb));
  worst = std::min(worst, signed_square(cross(out, far_next), oo * squared_length(far_next)));
  worst = std::min(worst, signed_square(cross(back, far_previous), bb * squared_length(far_previous)));
  const double shortest = std::min(face.shortest, std::min(oo, bb));
  const double longest = std::max(face.longest, std::max(oo, bb));
  // A small factor must not lift a negative value.
  return worst > 0 && kAspectGuard * shortest < longest ? worst * (kAspectGuard * shortest / longest) : worst;
}

double Star::measure_triangle(const Face& face, Vec2 offset) {
  const Vec2 out = face.next - offset;
  const Vec2 back = face.previous - offset;
  const double squares = face.shortest + squared_length(out) + squared_length(back);
  // 4 sqrt(3) A = 2 sqrt(3) times the cross product; its square is 12.
  const double area = cross(out, back);
  return squares > 0 ? 12 * area * std::abs(area) / (squares * squares) : -1.0;
}

double Star::worst(Vec2 offset, double floor) const {
  double worst = 1;
  for (const Face& face : faces_) {
    worst = std::min(worst, face.quad ? measure_quad(face, offset) : measure_triangle(face, offset));
    if (worst < floor) break;
  }
  return worst;
}

bool Star::valid_at(Vec2 p) const {
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    const Vec2 next = corners_[3 * i];
    const Vec2 opposite = corners_[3 * i + 1];
    const Vec2 previous = corners_[3 * i + 2];
    if (!(orient2d(previous, p, next) > 0)) return false;
    if (faces_[i].quad && !(orient2d(p, next, opposite) > 0 && orient2d(opposite, previous, p) > 0))
      return false;
  }
  return true;
}

}  // namespace quarry
