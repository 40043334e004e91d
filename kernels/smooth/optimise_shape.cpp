#include "kernels/smooth/optimise_shape.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/geometry/predicates.hpp"
#include "kernels/quality/element.hpp"
#include "kernels/quality/face.hpp"
#include "kernels/smooth/slide.hpp"

namespace quarry {
namespace {

// Where a corner has a smaller sine than this, or is turned over, eps is this share of the squared edges.
constexpr double kFlat = 0.1;
// The reach of one step, as a share of the edges at the vertex.
constexpr double kReach = 0.4;
constexpr int kAttempts = 3;

// The area of a quad, twice that of a triangle: what corners of both have in common.
double corner_area(const Mesh& mesh, FaceId f) {
  const double area = measure_face(mesh, f, [](auto... corners) { return signed_area(corners...); });
  return mesh.corner_count(f) == 4 ? area : 2 * area;
}

// The mean of a face and its neighbours, over and over: what is large among small ones stands back.
IdVector<FaceId, double> mean_areas(const Mesh& mesh) {
  constexpr int kRounds = 3;
  IdVector<FaceId, double> areas(mesh.face_slots(), 0.0);
  parallel::for_each(mesh.face_slots(), [&](std::size_t i) {
    if (mesh.alive(FaceId(i))) areas[FaceId(i)] = std::abs(corner_area(mesh, FaceId(i)));
  });
  for (int round = 0; round < kRounds; ++round) {
    const IdVector<FaceId, double> before = areas;
    parallel::for_each(mesh.face_slots(), [&](std::size_t i) {
      const FaceId f(i);
      if (!mesh.alive(f)) return;
      double sum = before[f];
      double count = 1;
      for (int k = 0; k < mesh.corner_count(f); ++k) {
        const SideId across = mesh.neighbour(SideId(f, k));
        if (!across.valid()) continue;
        sum += before[across.face()];
        count += 1;
      }
      areas[f] = sum / count;
    });
  }
  return areas;
}

struct Areas {
  double present = 0, wanted = 0;
};

// The squares of the wanted edges at the middles of the faces, scaled so that their sum is the present area.
IdVector<FaceId, double> areas_by_size(const Mesh& mesh, const SizeField& size) {
  IdVector<FaceId, double> areas(mesh.face_slots(), 0.0);
  const Areas sums = parallel::reduce_ordered(
      mesh.face_slots(), Areas(),
      [&](std::size_t begin, std::size_t end) {
        Areas part;
        for (std::size_t i = begin; i < end; ++i) {
          const FaceId f(i);
          if (!mesh.alive(f)) continue;
          const Vec2 middle = midpoint(mesh.point(mesh.corner(f, 0)), mesh.point(mesh.corner(f, 2)));
          const double edge = size.at(middle);
          areas[f] = edge * edge;
          part.present += corner_area(mesh, f);
          part.wanted += areas[f];
        }
        return part;
      },
      [](Areas a, Areas b) {
        return Areas{a.present + b.present, a.wanted + b.wanted};
      });
  const double factor = sums.present / sums.wanted;
  parallel::for_each(areas.size(), [&](std::size_t i) { areas[FaceId(i)] *= factor; });
  return areas;
}

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
  const IdVector<FaceId, double> areas =
      options.size != nullptr ? areas_by_size(mesh, *options.size) : mean_areas(mesh);
  VertexColouring colouring(mesh);
  const ShapeMover mover(Slide(mesh, ConstraintTags::of(mesh), lines), options, areas);
  return run_sweeps(mesh, colouring, mover, options.sweeps, progress);
}

}  // namespace quarry
