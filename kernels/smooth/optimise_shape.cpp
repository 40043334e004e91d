#include "kernels/smooth/optimise_shape.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/geometry/predicates.hpp"
#include "kernels/quality/element.hpp"
#include "kernels/quality/face.hpp"
#include "kernels/smooth/slide.hpp"
#include "kernels/smooth/wanted_areas.hpp"

namespace quarry {
namespace {

// Where a corner has a smaller sine than this, or is turned over, eps is this share of the squared edges.
constexpr double kFlat = 0.1;
// The reach of one step, as a share of the edges at the vertex.
constexpr double kReach = 0.4;
constexpr int kAttempts = 3;

class ShapeMover {
 public:
  ShapeMover(const Slide& slide, const ShapeOptions& options, const IdVector<FaceId, double>& areas)
      : slide_(slide), options_(options), areas_(&areas), star_(options.target) {}

  [[nodiscard]] bool may_move(VertexId v) const { return slide_.movable(v); }

  void first_look(const Mesh& mesh, WakeList& list) const {
    wake_corners(mesh, list, [&](FaceId f) {
      const double area = corner_area(mesh, f);
      const double wanted = (*areas_)[f];
      const double most = options_.content_areas;
      return scaled_jacobian(mesh, f) < options_.content || area > most * wanted || most * area < wanted;
    });
  }

  bool move(Mesh& mesh, VertexId v) {
    gather(mesh, v);
    const double edge = star_.mean_squared_edge();
    const double eps = star_.has_corner_below(kFlat) ? kFlat * edge : 0;
    const Quadratic here = star_.expand(eps);
    const Vec2 along = slide_.direction(v);
    Vec2 step = options_.relaxation * (along == Vec2{} ? here.step() : here.step_along(along));
    const double squared = squared_length(step);
    if (squared > kReach * kReach * edge) step = (kReach * std::sqrt(edge / squared)) * step;
    for (int attempt = 0; attempt < kAttempts; ++attempt, step = 0.5 * step) {
      const Vec2 target = slide_.allowed(v, place_ + step);
      const Vec2 offset = target - place_;
      if (!(squared_length(offset) > options_.tolerance * options_.tolerance * edge)) return false;
      if (!(star_.value(offset, eps) < here.value)) continue;
      if (!star_.keeps(offset, options_.floor, options_.largest_edge_ratio) || !keeps_valid(target)) continue;
      mesh.set_point(v, target);
      return true;
    }
    return false;
  }

 private:
  struct Corners {
    Vec2 next, opposite, previous;
    bool quad;
  };

  void gather(const Mesh& mesh, VertexId v) {
    place_ = mesh.point(v);
    star_.clear();
    corners_.clear();
    for_each_side_around(mesh, v, [&](SideId s) {
      const SideId forward = mesh.next(s);
      const SideId onward = mesh.next(forward);
      Corners c{mesh.point(mesh.origin(forward)), mesh.point(mesh.origin(onward)), {}, false};
      c.quad = mesh.corner_count(s.face()) == 4;
      c.previous = c.quad ? mesh.point(mesh.target(onward)) : c.opposite;
      const double area = (*areas_)[s.face()];
      if (c.quad)
        star_.add_quad(c.next - place_, c.opposite - place_, c.previous - place_, area);
      else
        star_.add_triangle(c.next - place_, c.previous - place_, area);
      corners_.push_back(c);
    });
    star_.follow_stretch();
  }

  // True if no corner that turns left now is turned over with the vertex at the target (exact).
  [[nodiscard]] bool keeps_valid(Vec2 target) const {
    const auto keeps = [&](Vec2 before, Vec2 after) {
      return orient2d(before, target, after) > 0 || !(orient2d(before, place_, after) > 0);
    };
    return std::all_of(corners_.begin(), corners_.end(), [&](const Corners& c) {
      return keeps(c.previous, c.next) &&
             (!c.quad || (keeps(c.opposite, c.next) && keeps(c.previous, c.opposite)));
    });
  }

  Slide slide_;
  ShapeOptions options_;
  const IdVector<FaceId, double>* areas_;
  Vec2 place_;
  ShapeStar star_;
  std::vector<Corners> corners_;
};

}  // namespace

SweepReport optimise_shape(Mesh& mesh, const NodedLines& lines, const ShapeOptions& options,
                           const Progress& progress) {
  const IdVector<FaceId, double> areas = wanted_areas(mesh, options.size);
  VertexColouring colouring(mesh);
  const ShapeMover mover(Slide(mesh, ConstraintTags::of(mesh), lines), options, areas);
  return run_sweeps(mesh, colouring, mover, options.sweeps, progress);
}

}  // namespace quarry
