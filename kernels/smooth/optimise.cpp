#include "kernels/smooth/optimise.hpp"

#include <array>
#include <cmath>

#include "kernels/smooth/slide.hpp"
#include "kernels/smooth/star.hpp"

namespace quarry {
namespace {

// Compass search: tries steps along fixed directions, keeps the first that gains, halves the step when none
// does.
class CornerMover {
 public:
  CornerMover(const Slide& slide, const OptimiseOptions& options)
      : slide_(slide),
        floor_(options.target * options.target),
        largest_triangle_ratio_(options.largest_triangle_ratio),
        smallest_step_(options.smallest_step) {}

  [[nodiscard]] bool may_move(VertexId v) const { return slide_.movable(v); }

  void first_look(const Mesh& mesh, WakeList& list) const {
    wake_corners(mesh, list, [&](FaceId f) { return Star::measure_of(mesh, f) < floor_; });
  }

  bool move(Mesh& mesh, VertexId v) {
    star_.gather(mesh, v);
    star_.weigh();
    if (star_.worst() >= floor_) return false;
    best_ = star_.badness_at({});
    const double before = best_;
    best_place_ = star_.place();
    const double edge = std::sqrt(star_.mean_squared());
    try_place(v, star_.place() + star_.umbrella());
    for (double step = kFirstStep; step >= smallest_step_;) {
      if (!search(v, step * edge)) step *= 0.5;
    }
    // Smaller gains are not worth waking the neighbours.
    if (!(best_ < (1 - kSmallestGain) * before)) return false;
    mesh.set_point(v, best_place_);
    return true;
  }

 private:
  static constexpr double kFirstStep = 0.3;
  static constexpr double kSmallestGain = 1e-3;

  bool search(VertexId v, double step) {
    const Vec2 along = slide_.direction(v);
    if (along == Vec2{}) {
      constexpr double kHalf = 0.70710678118654752;
      constexpr std::array<Vec2, 8> kCompass = {Vec2{1, 0},           Vec2{0, 1},         Vec2{-1, 0},
                                                Vec2{0, -1},          Vec2{kHalf, kHalf}, Vec2{-kHalf, kHalf},
                                                Vec2{-kHalf, -kHalf}, Vec2{kHalf, -kHalf}};
      for (const Vec2 direction : kCompass)
        if (try_place(v, best_place_ + step * direction)) return true;
      return false;
    }
    return try_place(v, best_place_ + step * along) || try_place(v, best_place_ + (-step) * along);
  }

  bool try_place(VertexId v, Vec2 wanted) {
    const Vec2 p = slide_.allowed(v, wanted);
    const Vec2 offset = p - star_.place();
    const double badness = star_.badness_at(offset);
    if (!(badness < best_) || !star_.keeps_triangles(offset, largest_triangle_ratio_) || !star_.valid_at(p))
      return false;
    best_ = badness;
    best_place_ = p;
    return true;
  }

  Slide slide_;
  double floor_;
  double largest_triangle_ratio_;
  double smallest_step_;
  Star star_;
  double best_ = 0;
  Vec2 best_place_;
};

}  // namespace

SweepReport optimise_corners(Mesh& mesh, const NodedLines& lines, const OptimiseOptions& options,
                             const Progress& progress) {
  VertexColouring colouring(mesh);
  const CornerMover mover(Slide(mesh, ConstraintTags::of(mesh), lines), options);
  return run_sweeps(mesh, colouring, mover, options.sweeps, progress);
}

}  // namespace quarry
