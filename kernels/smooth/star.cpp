#include "kernels/smooth/star.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/geometry/predicates.hpp"

namespace quarry {
namespace {

// sin |sin| of a corner from the cross product of its edges and the product of their squared lengths.
double signed_square(double area, double lengths) {
  return lengths > 0 ? area * std::abs(area) / lengths : -1.0;
}

// Four edges s, s, 4.9s, 4.9s have r = 1 / 144.6, see Star; no four edges within that ratio have less.
constexpr double kFree = 1 / 145.0;
constexpr double kFreeRatio = 4.9;

// The shortest and the longest edge of a face, squared.
struct SquaredEdges {
  double shortest, longest;
  [[nodiscard]] bool within(double ratio) const { return ratio * ratio * shortest >= longest; }
};
SquaredEdges squared_edges(const StarFace& face, double oo, double bb) {
  return {std::min(std::min(face.far_next_squared, face.far_previous_squared), std::min(oo, bb)),
          std::max(std::max(face.far_next_squared, face.far_previous_squared), std::max(oo, bb))};
}

bool has_free_aspect(const StarFace& face, double oo, double bb) {
  return squared_edges(face, oo, bb).within(kFreeRatio);
}

// What the aspect of a quad adds to 1 / sine^2.
double aspect_cost(const StarFace& face, double oo, double bb) {
  if (has_free_aspect(face, oo, bb)) return 0.0;
  const double out = oo * oo;  // fourth powers
  const double back = bb * bb;
  const double far_next = face.far_next_squared * face.far_next_squared;
  const double far_previous = face.far_previous_squared * face.far_previous_squared;
  const double far_sum = far_next + far_previous;
  const double inverses = (out + back) / (out * back) + far_sum / (far_next * far_previous);
  const double ratio = kFree * inverses * (out + back + far_sum) / 16.0;
  return std::max(0.0, ratio * ratio - 1);
}

double measure_quad(const StarFace& face, Vec2 out, Vec2 back) {
  const double oo = squared_length(out);
  const double bb = squared_length(back);
  double worst = std::min(face.far_corner, signed_square(cross(out, back), oo * bb));
  worst = std::min(worst, signed_square(cross(out, face.far_next), oo * face.far_next_squared));
  worst =
      std::min(worst, signed_square(cross(face.far_previous, -1.0 * back), bb * face.far_previous_squared));
  return worst > 0 ? worst / (1 + worst * aspect_cost(face, oo, bb)) : worst;
}

// 4 sqrt(3) A = 2 sqrt(3) times the cross product; its square is 12 times.
double measure_triangle(const StarFace& face, Vec2 out, Vec2 back) {
  const double squares = face.far_next_squared + squared_length(out) + squared_length(back);
  const double area = cross(out, back);
  return squares > 0 ? 12 * area * std::abs(area) / (squares * squares) : -1.0;
}

// True only if the measure is above the bar (positive), by more than rounding: without the divisions of
// measuring, which few faces need.
bool is_clearly_above(const StarFace& face, Vec2 offset, double bar) {
  constexpr double kRounding = 1e-12;
  const Vec2 out = face.next - offset;
  const Vec2 back = face.previous - offset;
  const double oo = squared_length(out);
  const double bb = squared_length(back);
  const double least = (1 + kRounding) * bar;
  const auto above = [least](double area, double lengths) {
    return area > 0 && area * area >= least * lengths;
  };
  if (!face.quad) {
    const double squares = face.far_next_squared + oo + bb;
    return above(cross(out, back), squares * squares / 12);
  }
  return above(cross(out, back), oo * bb) && above(cross(out, face.far_next), oo * face.far_next_squared) &&
         above(cross(back, face.far_previous), bb * face.far_previous_squared) &&
         above(cross(face.far_next, face.far_previous), face.far_next_squared * face.far_previous_squared) &&
         has_free_aspect(face, oo, bb);
}

double measure(const StarFace& face, Vec2 offset) {
  const Vec2 out = face.next - offset;
  const Vec2 back = face.previous - offset;
  return face.quad ? measure_quad(face, out, back) : measure_triangle(face, out, back);
}

// Fills in what is made from the places of the corners.
void complete(Vec2 place, StarFace& face) {
  face.next = face.at_next - place;
  face.previous = face.at_previous - place;
  face.far_next = face.at_opposite - face.at_next;
  face.far_previous = face.quad ? face.at_previous - face.at_opposite : face.far_next;
  face.far_next_squared = squared_length(face.far_next);
  face.far_previous_squared = squared_length(face.far_previous);
}

// Fills in what a face looks like from a corner; s starts there.
void look(const Mesh& mesh, SideId s, Vec2 place, StarFace& face) {
  const SideId forward = mesh.next(s);
  face.id = s.face();
  face.quad = mesh.corner_count(face.id) == 4;
  face.at_next = mesh.point(mesh.origin(forward));
  face.at_previous = mesh.point(mesh.origin(mesh.previous(s)));
  face.at_opposite = face.quad ? mesh.point(mesh.target(forward)) : face.at_previous;
  complete(place, face);
}

// Of a face by its corners, as seen from the first.
StarFace look(std::span<const Vec2> corners) {
  StarFace face;
  face.quad = corners.size() == 4;
  face.at_next = corners[1];
  face.at_previous = corners.back();
  face.at_opposite = face.quad ? corners[2] : face.at_previous;
  complete(corners[0], face);
  return face;
}

double far_corner(const StarFace& face) {
  return face.quad ? signed_square(cross(face.far_next, face.far_previous),
                                   face.far_next_squared * face.far_previous_squared)
                   : 1.0;
}

// True if a face is above the bar afterwards, or no worse than before. The faces need not be weighed.
bool keeps_measure(const StarFace& before, const StarFace& after, Vec2 offset, double bar) {
  if (is_clearly_above(after, offset, bar)) return true;
  StarFace old = before;
  StarFace changed = after;
  old.far_corner = far_corner(old);
  changed.far_corner = far_corner(changed);
  return measure(changed, offset) >= std::min(measure(old, {}), bar);
}

// The ratio of the longest edge to the shortest.
bool keeps_ratio_of_any(const StarFace& before, const StarFace& after, Vec2 offset, double limit) {
  const auto edges = [](const StarFace& face, Vec2 by) {
    return squared_edges(face, squared_length(face.next - by), squared_length(face.previous - by));
  };
  const SquaredEdges now = edges(after, offset);
  if (now.within(limit)) return true;
  const SquaredEdges old = edges(before, {});
  return now.longest * old.shortest <= old.longest * now.shortest;
}

bool keeps_edge_ratio(const StarFace& before, const StarFace& after, Vec2 offset, double limit) {
  return !after.quad || keeps_ratio_of_any(before, after, offset, limit);
}

}  // namespace

double Star::measure_of(const Mesh& mesh, FaceId f) {
  StarFace face;
  look(mesh, SideId(f, 0), mesh.point(mesh.corner(f, 0)), face);
  face.far_corner = far_corner(face);
  return measure(face, {});
}

void Star::gather(const Mesh& mesh, VertexId v) {
  place_ = mesh.point(v);
  umbrella_ = {};
  shortest_squared_ = std::numeric_limits<double>::infinity();
  mean_squared_ = 0;
  count_ = 0;
  double joined = 0;
  const auto join = [&](Vec2 edge) {
    const double squared = squared_length(edge);
    umbrella_ = umbrella_ + edge;
    joined += 1;
    mean_squared_ += squared;
    shortest_squared_ = std::min(shortest_squared_, squared);
  };
  const SideId first = mesh.side_of(v);
  for (SideId s = first; s.valid();) {
    if (count_ == faces_.size()) faces_.emplace_back();
    StarFace& face = faces_[count_++];
    look(mesh, s, place_, face);
    join(face.next);
    s = mesh.turn_left(s);
    if (!s.valid()) join(face.previous);
    if (s == first) break;
  }
  umbrella_ = (1.0 / joined) * umbrella_;
  mean_squared_ /= joined;
}

void Star::weigh() {
  worst_ = 1;
  for (StarFace& face : std::span(faces_).first(count_)) {
    face.far_corner = far_corner(face);
    face.measure = measure(face, {});
    worst_ = std::min(worst_, face.measure);
  }
}

double Star::badness_at(Vec2 offset) const {
  double sum = 0;
  for (const StarFace& face : faces()) {
    const double value = measure(face, offset);
    if (value < worst_ || !(value > 0)) return std::numeric_limits<double>::infinity();
    sum += 1.0 / value;
  }
  return sum;
}

bool Star::keeps_faces(Vec2 offset, double bar) const {
  const auto faces = this->faces();
  return std::all_of(faces.begin(), faces.end(),
                     [&](const StarFace& face) { return keeps_measure(face, face, offset, bar); });
}

bool Star::keeps_edge_ratios(Vec2 offset, double limit) const {
  const auto faces = this->faces();
  return std::all_of(faces.begin(), faces.end(),
                     [&](const StarFace& face) { return keeps_edge_ratio(face, face, offset, limit); });
}

bool Star::keeps_triangles(Vec2 offset, double limit) const {
  const auto faces = this->faces();
  return std::all_of(faces.begin(), faces.end(), [&](const StarFace& face) {
    return face.quad || keeps_ratio_of_any(face, face, offset, limit);
  });
}

bool Star::valid_at(Vec2 p) const {
  for (const StarFace& face : faces()) {
    if (!(orient2d(face.at_previous, p, face.at_next) > 0)) return false;
    if (face.quad && !(orient2d(p, face.at_next, face.at_opposite) > 0 &&
                       orient2d(face.at_opposite, face.at_previous, p) > 0))
      return false;
  }
  return true;
}

bool keeps_face(std::span<const Vec2> before, std::span<const Vec2> after, double bar, double edge_ratio) {
  if (std::equal(before.begin(), before.end(), after.begin())) return true;
  const StarFace old = look(before);
  const StarFace now = look(after);
  const std::size_t count = after.size();
  for (std::size_t k = 0; k < count; ++k)
    if (!(orient2d(after[(k + count - 1) % count], after[k], after[(k + 1) % count]) > 0)) return false;
  return keeps_measure(old, now, {}, bar) && keeps_edge_ratio(old, now, {}, edge_ratio);
}

}  // namespace quarry
