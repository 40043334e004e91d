#include "kernels/smooth/laplacian.hpp"

#include "kernels/smooth/slide.hpp"
#include "kernels/smooth/star.hpp"

namespace quarry {
namespace {

class LaplacianMover {
 public:
  LaplacianMover(const Slide& slide, double tolerance) : slide_(slide), tolerance_(tolerance) {}

  [[nodiscard]] bool may_move(VertexId v) const { return slide_.movable(v); }

  void first_look(const Mesh& mesh, WakeList& list) const {
    parallel::for_each(mesh.vertex_slots(), [&](std::size_t i) {
      const VertexId v(i);
      if (!list.frozen(v) && is_off_target(mesh, v)) list.wake(v);
    });
  }

  bool move(Mesh& mesh, VertexId v) {
    star_.gather(mesh, v);
    Vec2 target = slide_.allowed(v, star_.place() + star_.umbrella());
    if (!far_enough(target - star_.place(), star_.shortest_squared())) return false;
    star_.weigh();
    // Where the worst face cannot be helped, as in an acute wedge between lines, it must not licence others
    // to sink.
    const double bar = std::max(star_.worst(), kFloor);
    for (const double step : {1.0, 0.5, 0.25}) {
      if (step < 1) target = slide_.allowed(v, star_.place() + step * star_.umbrella());
      const Vec2 offset = target - star_.place();
      if (!far_enough(offset, star_.shortest_squared())) return false;
      if (!star_.keeps_faces(offset, bar) || !star_.valid_at(target)) continue;
      mesh.set_point(v, target);
      return true;
    }
    return false;
  }

 private:
  [[nodiscard]] bool is_off_target(const Mesh& mesh, VertexId v) const {
    Vec2 sum;
    double count = 0;
    double shortest = std::numeric_limits<double>::infinity();
    const Vec2 here = mesh.point(v);
    const auto join = [&](VertexId other) {
      const Vec2 edge = mesh.point(other) - here;
      sum = sum + edge;
      count += 1;
      shortest = std::min(shortest, squared_length(edge));
    };
    const SideId first = mesh.side_of(v);
    for (SideId s = first; s.valid();) {
      join(mesh.target(s));
      const SideId back = mesh.previous(s);
      s = mesh.neighbour(back);
      if (!s.valid()) join(mesh.origin(back));
      if (s == first) break;
    }
    return far_enough(slide_.allowed(v, here + (1.0 / count) * sum) - here, shortest);
  }

  static constexpr double kFloor = 0.25;

  [[nodiscard]] bool far_enough(Vec2 offset, double shortest_squared) const {
    return squared_length(offset) > tolerance_ * tolerance_ * shortest_squared;
  }

  Slide slide_;
  double tolerance_;
  Star star_;
};

}  // namespace

SweepReport smooth_laplacian(Mesh& mesh, const NodedLines& lines, const LaplacianOptions& options,
                             const Progress& progress) {
  VertexColouring colouring(mesh);
  const LaplacianMover mover(Slide(mesh, ConstraintTags::of(mesh), lines), options.tolerance);
  return run_sweeps(mesh, colouring, mover, options.sweeps, progress);
}

}  // namespace quarry
