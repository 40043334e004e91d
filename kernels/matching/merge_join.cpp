#include "kernels/matching/merge_join.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <span>
#include <utility>
#include <vector>

#include "engine/mesh/build.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/matching/quad_shape.hpp"

namespace quarry {
namespace {

using matching::contains;
using matching::is_split;

// Numbers of the quad mesh in closed form. The quad of an arc with smaller side s = a -> b has the corners a,
// the apex on the right, b, the apex on the left; an apex is the third vertex of a triangle or its Steiner
// point. Sides 2 and 3 lie in the face of s, sides 0 and 1 in the face across.
class QuadNumbers {
 public:
  QuadNumbers(const Mesh& mesh, const DualArcs& join)
      : mesh_(mesh), join_(join), quad_(mesh.face_slots()), steiner_(mesh.face_slots()) {
    parallel::for_each(mesh.face_slots(), [&](std::size_t i) {
      const FaceId f(i);
      quad_[i] = 0;
      for (int k = 0; k < 3; ++k) quad_[i] += owns(SideId(f, k)) ? 1 : 0;
      steiner_[i] = is_split(join[f]) ? 1 : 0;
    });
    quad_count_ = parallel::exclusive_scan(std::span(quad_));
    steiner_count_ = parallel::exclusive_scan(std::span(steiner_));
  }

  [[nodiscard]] std::size_t quad_count() const { return quad_count_; }
  [[nodiscard]] std::size_t vertex_count() const { return mesh_.vertex_slots() + steiner_count_; }

  // True if s is the smaller side of an arc of the join.
  [[nodiscard]] bool owns(SideId s) const { return contains(join_, s) && s < mesh_.neighbour(s); }
  [[nodiscard]] VertexId steiner(FaceId f) const {
    return VertexId(mesh_.vertex_slots() + steiner_[f.value()]);
  }
  // The third corner of the half of a quad that lies in the face of s.
  [[nodiscard]] VertexId far_corner(SideId s) const {
    return is_split(join_[s.face()]) ? steiner(s.face()) : matching::apex(mesh_, s);
  }
  // The quad of an arc's owner.
  [[nodiscard]] FaceId quad(SideId owner) const {
    std::uint32_t before = 0;
    for (int k = 0; k < owner.index(); ++k) before += owns(SideId(owner.face(), k)) ? 1 : 0;
    return FaceId(quad_[owner.face().value()] + before);
  }
  // Of the arc across s, in the join: the quad's side from the target of s to the far corner, and the one
  // from there to the origin of s.
  [[nodiscard]] SideId to_far_corner(SideId s) const { return half(s, 0); }
  [[nodiscard]] SideId from_far_corner(SideId s) const { return half(s, 1); }
  // What a side that is in no arc becomes: its face has one arc.
  [[nodiscard]] SideId outer(SideId s) const {
    const SideId arc(s.face(), std::countr_zero(static_cast<unsigned>(join_[s.face()])));
    return half(arc, mesh_.next(arc) == s ? 0 : 1);
  }

 private:
  [[nodiscard]] SideId half(SideId s, int which) const {
    return owns(s) ? SideId(quad(s), 2 + which) : SideId(quad(mesh_.neighbour(s)), which);
  }

  const Mesh& mesh_;
  const DualArcs& join_;
  std::vector<std::uint32_t> quad_, steiner_;  // first of each face
  std::uint32_t quad_count_ = 0, steiner_count_ = 0;
};

// The place in a triangle where the smallest corner of its three quads is largest.
template <class Point>
class SteinerPlace {
 public:
  // beyond[k]: the far corner of the quad across the side from corner k.
  SteinerPlace(const std::array<Point, 3>& corners, const std::array<Point, 3>& beyond)
      : corners_(corners), beyond_(beyond) {}

  // A compass search from the centroid in barycentric coordinates: the point stays in the triangle.
  [[nodiscard]] Point find() const {
    constexpr double kThird = 1.0 / 3.0;
    constexpr double kSmallestStep = 0.004;
    std::array<double, 3> best{kThird, kThird, kThird};
    double most = worst_at(best);
    for (double step = 0.15; step > kSmallestStep;) {
      bool found = false;
      for (std::size_t k = 0; k < 6 && !found; ++k) {
        // Towards a corner, or away from it.
        std::array<double, 3> tried = best;
        const double share = k < 3 ? step : -step;
        for (std::size_t i = 0; i < 3; ++i) tried[i] += i == k % 3 ? share : -0.5 * share;
        if (std::min({tried[0], tried[1], tried[2]}) < kLeastShare) continue;
        const double worst = worst_at(tried);
        if (!(worst > most + kLeastGain)) continue;
        most = worst;
        best = tried;
        found = true;
      }
      if (!found) step *= 0.5;
    }
    return at(best);
  }

 private:
  static constexpr double kLeastShare = 0.05;
  // Along a ridge smaller gains would go on for very long.
  static constexpr double kLeastGain = 1e-3;

  [[nodiscard]] Point at(const std::array<double, 3>& share) const {
    return corners_[0] + (share[1] * (corners_[1] - corners_[0]) + share[2] * (corners_[2] - corners_[0]));
  }
  [[nodiscard]] double worst_at(const std::array<double, 3>& share) const {
    const Point p = at(share);
    double worst = 1;
    for (std::size_t k = 0; k < 3; ++k)
      worst = std::min(worst, matching::quad_shape(corners_[k], beyond_[k], corners_[(k + 1) % 3], p));
    return worst;
  }

  std::array<Point, 3> corners_, beyond_;
};

template <class Point>
class JoinMerge {
 public:
  JoinMerge(const Mesh& from, const DualArcs& join)
      : from_(from), join_(join), number_(from, join), from_tags_(ConstraintTags::of(from)) {}

  Mesh run() {
    to_ = with_points();
    to_tags_ = ConstraintTags::add_to(to_);
    to_.grow_faces(number_.quad_count());
    copy_vertices();
    parallel::for_each(from_.face_slots(), [&](std::size_t i) {
      const FaceId f(i);
      if (!from_.alive(f)) return;
      for (int k = 0; k < 3; ++k)
        if (number_.owns(SideId(f, k))) make_quad(SideId(f, k));
      if (is_split(join_[f])) to_.set_side_of(number_.steiner(f), number_.from_far_corner(SideId(f, 0)));
    });
    return std::move(to_);
  }

 private:
  // A mesh of no faces with the old points and the Steiner points.
  [[nodiscard]] Mesh with_points() const {
    std::vector<double> x = from_.xs(), y = from_.ys(), z = from_.zs();
    x.resize(number_.vertex_count());
    y.resize(number_.vertex_count());
    if (!z.empty()) z.resize(number_.vertex_count());
    parallel::for_each(from_.face_slots(), [&](std::size_t i) {
      if (!is_split(join_[FaceId(i)])) return;
      const Point p = steiner_place(FaceId(i));
      const std::size_t v = number_.steiner(FaceId(i)).value();
      x[v] = p.x;
      y[v] = p.y;
      if constexpr (std::is_same_v<Point, Vec3>) z[v] = p.z;
    });
    return build_mesh(std::move(x), std::move(y), std::move(z), {});
  }

  [[nodiscard]] Point steiner_place(FaceId f) const {
    std::array<Point, 3> corners, beyond;
    for (int k = 0; k < 3; ++k) {
      const auto at = static_cast<std::size_t>(k);
      corners[at] = point_of<Point>(from_, from_.corner(f, k));
      const SideId across = from_.neighbour(SideId(f, k));
      beyond[at] = is_split(join_[across.face()]) ? centroid_of(across.face())
                                                  : point_of<Point>(from_, matching::apex(from_, across));
    }
    return SteinerPlace<Point>(corners, beyond).find();
  }

  [[nodiscard]] Point centroid_of(FaceId f) const {
    return matching::centroid(point_of<Point>(from_, from_.corner(f, 0)),
                              point_of<Point>(from_, from_.corner(f, 1)),
                              point_of<Point>(from_, from_.corner(f, 2)));
  }

  void copy_vertices() {
    parallel::for_each(from_.vertex_slots(), [&](std::size_t i) {
      const VertexId v(i);
      to_tags_.support[v] = from_tags_.support[v];
      if (!from_.alive(v)) return;
      // An arc is inside, so that a boundary vertex keeps its most clockwise side.
      const SideId s = from_.side_of(v);
      to_.set_side_of(v, contains(join_, s) ? number_.to_far_corner(from_.neighbour(s)) : number_.outer(s));
    });
  }

  void make_quad(SideId s) {
    const SideId t = from_.neighbour(s);
    const FaceId quad = number_.quad(s);
    to_.set_corner({quad, 0}, from_.origin(s));
    to_.set_corner({quad, 1}, number_.far_corner(t));
    to_.set_corner({quad, 2}, from_.target(s));
    to_.set_corner({quad, 3}, number_.far_corner(s));
    for (const SideId half : {s, t}) {
      join_half(number_.to_far_corner(half), from_.next(half), true);
      join_half(number_.from_far_corner(half), from_.previous(half), false);
    }
  }

  // One outer side of a quad, and the side of the triangle that it was or that lies beyond the Steiner edge.
  void join_half(SideId side, SideId was, bool towards) {
    if (is_split(join_[was.face()])) {
      to_.set_neighbour(side, towards ? number_.from_far_corner(was) : number_.to_far_corner(was));
      return;
    }
    const SideId across = from_.neighbour(was);
    to_.set_neighbour(side, across.valid() ? number_.outer(across) : SideId());
    if (from_tags_.constrained(was)) to_tags_.set_constrained(side, true);
  }

  const Mesh& from_;
  const DualArcs& join_;
  QuadNumbers number_;
  ConstraintTags from_tags_;
  Mesh to_;
  ConstraintTags to_tags_;
};

}  // namespace

Mesh merge_join(Mesh&& triangles, const DualArcs& join) {
  const Mesh from = std::move(triangles);
  Mesh quads;
  matching::with_points_of(from, [&]<class Point>(Point) { quads = JoinMerge<Point>(from, join).run(); });
  return quads;
}

std::uint64_t count_steiner_points(const DualArcs& join) {
  return parallel::reduce_ordered(
      join.size(), std::uint64_t{0},
      [&](std::size_t begin, std::size_t end) {
        std::uint64_t sum = 0;
        for (std::size_t i = begin; i < end; ++i) sum += is_split(join[FaceId(i)]) ? 1 : 0;
        return sum;
      },
      [](std::uint64_t a, std::uint64_t b) { return a + b; });
}

}  // namespace quarry
