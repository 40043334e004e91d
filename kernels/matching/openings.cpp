#include "kernels/matching/openings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

#include "engine/geometry/predicates.hpp"
#include "kernels/local/replace.hpp"
#include "kernels/matching/quad_shape.hpp"

namespace quarry {
namespace {

// Smaller gains end the search at one step: along a ridge they would go on for very long.
constexpr double kLeastStepGain = 1e-3;

// Counter-clockwise from the straight corner on.
using Hexagon = std::array<VertexId, 6>;

bool all_distinct(Hexagon ring) {
  std::sort(ring.begin(), ring.end());
  return std::adjacent_find(ring.begin(), ring.end()) == ring.end();
}

// How a hexagon and the quads in it are seen: in the plane as they are, in space along the normal of the
// whole.
template <class Point>
class HexagonView;

template <>
class HexagonView<Vec2> {
 public:
  explicit HexagonView(const std::array<Vec2, 6>& /*ring*/) {}
  [[nodiscard]] static Vec2 step(double x, double y) { return {x, y}; }
  [[nodiscard]] static double shape(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    return matching::quad_shape(a, b, c, d);
  }
};

template <>
class HexagonView<Vec3> {
 public:
  explicit HexagonView(const std::array<Vec3, 6>& ring) {
    for (std::size_t i = 1; i + 1 < ring.size(); ++i)
      normal_ = normal_ + cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
    const Vec3 along =
        cross(normal_, std::abs(normal_.x) < std::abs(normal_.y) ? Vec3{1, 0, 0} : Vec3{0, 1, 0});
    x_ = in_unit_length(along);
    y_ = in_unit_length(cross(normal_, along));
  }
  [[nodiscard]] Vec3 step(double x, double y) const { return x * x_ + y * y_; }
  // The shape alone would not tell a quad that is upside down.
  [[nodiscard]] double shape(Vec3 a, Vec3 b, Vec3 c, Vec3 d) const {
    return dot(cross(c - a, d - b), normal_) > 0 ? matching::quad_shape(a, b, c, d) : -1.0;
  }

 private:
  [[nodiscard]] static Vec3 in_unit_length(Vec3 v) {
    const double size = length(v);
    return size > 0 ? (1 / size) * v : Vec3();
  }

  Vec3 normal_, x_, y_;
};

template <class Point>
class OpenStraightCorner {
 public:
  using Item = FaceId;
  struct Plan {
    FaceId beyond;
    Hexagon ring;
    Point centre;
  };

  OpenStraightCorner(ConstraintTags tags, const OpeningOptions& options) : tags_(tags), options_(options) {}

  // The side at whose origin the face has the straightest corner, or none below the limit.
  [[nodiscard]] SideId straight_corner(const Mesh& mesh, FaceId f) const {
    SideId worst;
    double smallest = options_.smallest_sine;
    const auto corners = corners_of(mesh, f);
    const matching::CornerSines<Point> sine(corners[0], corners[1], corners[2], corners[3]);
    for (std::size_t k = 0; k < 4; ++k) {
      const Point previous = corners[(k + 3) % 4], here = corners[k], next = corners[(k + 1) % 4];
      if (dot(previous - here, next - here) >= 0) continue;
      if (const double found = sine(previous, here, next); found < smallest) {
        smallest = found;
        worst = SideId(f, static_cast<int>(k));
      }
    }
    return worst;
  }

  bool propose(const Mesh& mesh, FaceId f, Cavity& cavity, Plan& plan) const {
    if (!mesh.alive(f) || mesh.corner_count(f) != 4) return false;
    const SideId corner = straight_corner(mesh, f);
    if (!corner.valid()) return false;
    double most = 0;
    bool found = false;
    for (const SideId far : {mesh.next(corner), mesh.next(mesh.next(corner))})
      found = try_side(mesh, corner, far, plan, most) || found;
    if (!found) return false;
    for (const VertexId v : plan.ring) cavity.claim(v);
    cavity.will_create(1, 1);
    return true;
  }

  void apply(MeshEditor& editor, FaceId f, const Plan& plan, NewIds ids, FollowUps<FaceId>& /*more*/) const {
    const VertexId centre = ids.take_vertex();
    if constexpr (std::is_same_v<Point, Vec2>)
      editor.set_point(centre, plan.centre);
    else
      editor.set_point3(centre, plan.centre);
    editor.set(tags_.support, centre, Support::free());
    const std::array<FaceId, 2> old{f, plan.beyond};
    const auto& ring = plan.ring;
    const std::array<FaceCorners, 3> fresh{FaceCorners{ring[0], ring[1], ring[2], centre},
                                           FaceCorners{ring[2], ring[3], ring[4], centre},
                                           FaceCorners{ring[4], ring[5], ring[0], centre}};
    thread_local FaceReplacer replacer;
    replacer.replace(editor, tags_, old, fresh, ids);
  }

 private:
  // Keeps the plan across a far side if it is the best so far.
  bool try_side(const Mesh& mesh, SideId corner, SideId far, Plan& plan, double& most) const {
    const SideId across = mesh.neighbour(far);
    if (!across.valid() || tags_.constrained(far) || mesh.corner_count(across.face()) != 4) return false;
    const Hexagon ring = ring_of(mesh, corner, across);
    if (!all_distinct(ring)) return false;
    const double before = std::min(shape_of(mesh, far.face()), shape_of(mesh, across.face()));
    const std::array<Point, 6> points = points_of(mesh, ring);
    const auto [centre, worst] = best_centre(points);
    if (worst - before < options_.least_gain || worst - before <= most || !valid(points, centre, worst))
      return false;
    most = worst - before;
    plan = {across.face(), ring, centre};
    return true;
  }

  // Around the quad and the one beyond, from the straight corner on.
  static Hexagon ring_of(const Mesh& mesh, SideId corner, SideId across) {
    Hexagon ring;
    std::size_t count = 0;
    SideId s = corner;
    for (int k = 0; k < 4; ++k, s = mesh.next(s)) {
      ring[count++] = mesh.origin(s);
      if (mesh.neighbour(s) != across) continue;
      for (SideId t = mesh.next(mesh.next(across)); t != across; t = mesh.next(t))
        ring[count++] = mesh.origin(t);
    }
    return ring;
  }

  static std::array<Point, 4> corners_of(const Mesh& mesh, FaceId f) {
    std::array<Point, 4> corners;
    for (std::size_t k = 0; k < 4; ++k)
      corners[k] = point_of<Point>(mesh, mesh.corner(f, static_cast<int>(k)));
    return corners;
  }
  static double shape_of(const Mesh& mesh, FaceId f) {
    const auto corners = corners_of(mesh, f);
    return matching::quad_shape(corners[0], corners[1], corners[2], corners[3]);
  }
  static std::array<Point, 6> points_of(const Mesh& mesh, const Hexagon& ring) {
    std::array<Point, 6> points;
    for (std::size_t i = 0; i < 6; ++i) points[i] = point_of<Point>(mesh, ring[i]);
    return points;
  }

  // Of the three quads around a centre those that are not the centre.
  static std::array<std::array<Point, 3>, 3> corners_around(const std::array<Point, 6>& ring) {
    std::array<std::array<Point, 3>, 3> corners;
    for (std::size_t q = 0; q < 3; ++q)
      for (std::size_t i = 0; i < 3; ++i) corners[q][i] = ring[(2 * q + i) % 6];
    return corners;
  }

  // A compass search for the place that makes the worst of the three quads best.
  static std::pair<Point, double> best_centre(const std::array<Point, 6>& ring) {
    const auto corners = corners_around(ring);
    const HexagonView<Point> view(ring);
    const auto worst_at = [&](Point p) {
      double worst = 1;
      for (const auto& [a, b, c] : corners) worst = std::min(worst, view.shape(a, b, c, p));
      return worst;
    };
    Point offset;
    double spread = 0;
    const Point origin = corners[0][0];
    for (const auto& quad : corners)
      offset = offset + (1.0 / 6.0) * ((quad[0] - origin) + (quad[1] - origin));
    Point best = origin + offset;
    for (const auto& quad : corners) spread = std::max(spread, length(quad[0] - best));
    double most = worst_at(best);
    for (double step = 0.4 * spread; step > 0.01 * spread;) {
      bool found = false;
      for (const auto& [x, y] : kWays) {
        const Point tried = best + step * view.step(x, y);
        const double worst = worst_at(tried);
        if (!(worst > most + kLeastStepGain)) continue;
        most = worst;
        best = tried;
        found = true;
        break;
      }
      if (!found) step *= 0.5;
    }
    return {best, most};
  }

  static bool valid(const std::array<Point, 6>& ring, Point p, double worst) {
    if constexpr (std::is_same_v<Point, Vec2>) {
      for (const auto& [a, b, c] : corners_around(ring))
        if (!(orient2d(p, a, b) > 0 && orient2d(a, b, c) > 0 && orient2d(b, c, p) > 0 &&
              orient2d(c, p, a) > 0))
          return false;
      return true;
    } else {
      return worst > 0;
    }
  }

  static constexpr std::array<std::array<double, 2>, 8> kWays = {
      {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {0.7, 0.7}, {-0.7, 0.7}, {-0.7, -0.7}, {0.7, -0.7}}};

  ConstraintTags tags_;
  OpeningOptions options_;
};

template <class Point>
PassReport open_corners(Mesh& mesh, const OpeningOptions& options, const Progress& progress) {
  const OpenStraightCorner<Point> operation(ConstraintTags::of(mesh), options);
  const auto straight = parallel::filter_indices(mesh.face_slots(), [&](std::size_t i) {
    const FaceId f(i);
    return mesh.alive(f) && mesh.corner_count(f) == 4 && operation.straight_corner(mesh, f).valid();
  });
  std::vector<FaceId> work;
  work.reserve(straight.size());
  for (const std::uint32_t i : straight) work.emplace_back(i);
  PassReport report = run_pass(mesh, operation, std::move(work), PassOptions(), progress);
  report.name = "openings of straight corners";
  return report;
}

}  // namespace

PassReport open_straight_corners(Mesh& mesh, const OpeningOptions& options, const Progress& progress) {
  PassReport report;
  matching::with_points_of(
      mesh, [&]<class Point>(Point) { report = open_corners<Point>(mesh, options, progress); });
  return report;
}

}  // namespace quarry
