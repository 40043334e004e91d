#include "kernels/smooth/square_corners.hpp"

#include <algorithm>
#include <cmath>

#include "kernels/smooth/corner_residual.hpp"
#include "kernels/smooth/slide.hpp"
#include "kernels/smooth/square_together.hpp"
#include "kernels/smooth/star.hpp"
#include "kernels/smooth/wanted_areas.hpp"

namespace quarry {
namespace {

Vec2 turned_left(Vec2 a) { return {-a.y, a.x}; }

// The residuals of the three corners of a face that a move of the vertex changes.
struct FaceResiduals {
  Residual here, next, previous;

  FaceResiduals(const StarFace& face, Vec2 out, Vec2 back) {
    const auto wanted = wanted_angle<double>(face.quad);
    const double oo = squared_length(out);
    const double bb = squared_length(back);
    const auto residual = [&](Vec2 first, Vec2 second, double squares) {
      return angle_residual(dot(first, second), cross(first, second), std::sqrt(squares), wanted);
    };
    here = residual(out, back, oo * bb);
    next = residual(face.far_next, -1.0 * out, oo * face.far_next_squared);
    previous = residual(-1.0 * back, -1.0 * face.far_previous, bb * face.far_previous_squared);
  }
  [[nodiscard]] double sum_of_squares() const {
    return here.value * here.value + next.value * next.value + previous.value * previous.value;
  }
};

// The sum of squares with its gradient and the Gauss-Newton approximation of its second derivatives.
struct Quadratic {
  double value = 0;
  Vec2 gradient;
  double xx = 0, xy = 0, yy = 0;

  // The gradient of the angle or the area by the place of the vertex.
  void add(Residual r, Vec2 gradient_of_argument) {
    const Vec2 g = r.slope * gradient_of_argument;
    value += r.value * r.value;
    gradient = gradient + r.value * g;
    xx += g.x * g.x;
    xy += g.x * g.y;
    yy += g.y * g.y;
  }
};

class SquaringMover {
 public:
  SquaringMover(const Slide& slide, const SquareCornersOptions& options,
                const IdVector<FaceId, AreaDemand>& areas)
      : slide_(slide),
        options_(options),
        areas_(&areas),
        content_(options.content * options.content),
        floor_(options.floor * options.floor) {}

  [[nodiscard]] bool may_move(VertexId v) const { return slide_.movable(v); }

  void first_look(const Mesh& mesh, WakeList& list) const {
    wake_corners(mesh, list, [&](FaceId f) { return Star::measure_of(mesh, f) < content_; });
  }

  bool move(Mesh& mesh, VertexId v) {
    star_.gather(mesh, v);
    const Quadratic here = sum_at({});
    Vec2 step = options_.relaxation * minimiser(here, slide_.direction(v));
    // The quadratic is no good guide beyond the nearest neighbour.
    const double reach = 0.25 * star_.shortest_squared();
    const double squared = squared_length(step);
    if (squared > reach) step = std::sqrt(reach / squared) * step;
    for (int attempt = 0; attempt < 3; ++attempt, step = 0.5 * step) {
      const Vec2 target = slide_.allowed(v, star_.place() + step);
      const Vec2 offset = target - star_.place();
      if (!(squared_length(offset) > options_.tolerance * options_.tolerance * star_.shortest_squared()))
        return false;
      if (!star_.keeps_faces(offset, floor_) ||
          !star_.keeps_edge_ratios(offset, options_.largest_edge_ratio) || !(value_at(offset) < here.value) ||
          !star_.valid_at(target))
        continue;
      mesh.set_point(v, target);
      return true;
    }
    return false;
  }

 private:
  [[nodiscard]] double spring_weight() const {
    return options_.spring * options_.spring / star_.shortest_squared();
  }

  [[nodiscard]] Quadratic sum_at(Vec2 offset) const {
    Quadratic sum;
    for (const StarFace& face : star_.faces()) {
      const Vec2 out = face.next - offset;
      const Vec2 back = face.previous - offset;
      const FaceResiduals residuals(face, out, back);
      // The gradients of the angles to the two joined corners.
      const Vec2 out_turn = (1.0 / squared_length(out)) * turned_left(out);
      const Vec2 back_turn = (1.0 / squared_length(back)) * turned_left(back);
      sum.add(residuals.here, out_turn - back_turn);
      sum.add(residuals.next, -1.0 * out_turn);
      sum.add(residuals.previous, back_turn);
      if (options_.evenness > 0) {
        const Residual area = area_residual_at(face, offset);
        sum.add(area, area_gradient(face));
      }
    }
    const double w = spring_weight();
    const Vec2 stretch = offset - star_.umbrella();
    sum.value += w * squared_length(stretch);
    sum.gradient = sum.gradient + w * stretch;
    sum.xx += w;
    sum.yy += w;
    return sum;
  }

  [[nodiscard]] double value_at(Vec2 offset) const {
    double sum = spring_weight() * squared_length(offset - star_.umbrella());
    for (const StarFace& face : star_.faces()) {
      sum += FaceResiduals(face, face.next - offset, face.previous - offset).sum_of_squares();
      if (options_.evenness > 0) {
        const double r = area_residual_at(face, offset).value;
        sum += r * r;
      }
    }
    return sum;
  }

  [[nodiscard]] Residual area_residual_at(const StarFace& face, Vec2 offset) const {
    const double area = face.quad ? 0.5 * cross(face.next + face.far_next - offset, face.previous - face.next)
                                  : cross(face.next - offset, face.previous - offset);
    return area_residual(area, (*areas_)[face.id]);
  }
  // By the place of the vertex.
  [[nodiscard]] static Vec2 area_gradient(const StarFace& face) {
    return (face.quad ? 0.5 : 1.0) * turned_left(face.previous - face.next);
  }

  // Along a direction (of length 1), or anywhere if it is zero.
  static Vec2 minimiser(const Quadratic& q, Vec2 along) {
    if (!(along == Vec2{})) {
      const double curvature =
          q.xx * along.x * along.x + 2 * q.xy * along.x * along.y + q.yy * along.y * along.y;
      return (-dot(q.gradient, along) / curvature) * along;
    }
    const double determinant = q.xx * q.yy - q.xy * q.xy;
    return {-(q.yy * q.gradient.x - q.xy * q.gradient.y) / determinant,
            -(q.xx * q.gradient.y - q.xy * q.gradient.x) / determinant};
  }

  Slide slide_;
  SquareCornersOptions options_;
  const IdVector<FaceId, AreaDemand>* areas_;
  double content_;
  double floor_;
  Star star_;
};

}  // namespace

SweepReport square_corners(Mesh& mesh, const NodedLines& lines, const SquareCornersOptions& options,
                           const Progress& progress) {
  const IdVector<FaceId, AreaDemand> areas = area_demands(mesh, options.evenness, options.size);
  const Slide slide(mesh, ConstraintTags::of(mesh), lines);
  VertexColouring colouring(mesh);
  SweepReport report;
  const auto sweep = [&](const SquareCornersOptions& by, int sweeps) {
    add(report, run_sweeps(mesh, colouring, SquaringMover(slide, by, areas), sweeps, progress));
  };
  SquareTogether together(mesh, slide, areas, options);
  SquareCornersOptions between = options;
  between.relaxation = 1.3;
  for (int round = 0; round < options.rounds_together; ++round) {
    progress.throw_if_cancelled();
    report.moved += together.run();
    sweep(between, 1);
  }
  sweep(options, options.sweeps);
  return report;
}

}  // namespace quarry
