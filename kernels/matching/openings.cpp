#include "kernels/matching/openings.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "engine/geometry/predicates.hpp"
#include "kernels/local/replace.hpp"
#include "kernels/quality/face.hpp"

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

class OpenStraightCorner {
 public:
  using Item = FaceId;
  struct Plan {
    FaceId beyond;
    Hexagon ring;
    Vec2 centre;
  };

  OpenStraightCorner(ConstraintTags tags, const OpeningOptions& options) : tags_(tags), options_(options) {}

  // The side at whose origin the face has the straightest corner, or none below the limit.
  [[nodiscard]] SideId straight_corner(const Mesh& mesh, FaceId f) const {
    SideId worst;
    double smallest = options_.smallest_sine;
    for (int k = 0; k < 4; ++k) {
      const SideId s(f, k);
      const Vec2 previous = mesh.point(mesh.origin(mesh.previous(s)));
      const Vec2 here = mesh.point(mesh.origin(s));
      const Vec2 next = mesh.point(mesh.target(s));
      if (dot(previous - here, next - here) >= 0) continue;
      if (const double sine = corner_scaled_jacobian(previous, here, next); sine < smallest) {
        smallest = sine;
        worst = s;
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
    editor.set_point(centre, plan.centre);
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
    const double before = std::min(scaled_jacobian(mesh, far.face()), scaled_jacobian(mesh, across.face()));
    const auto [centre, worst] = best_centre(mesh, ring);
    if (worst - before < options_.least_gain || worst - before <= most || !valid(mesh, ring, centre))
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

  static std::array<std::array<Vec2, 3>, 3> corners_of(const Mesh& mesh, const Hexagon& ring) {
    std::array<std::array<Vec2, 3>, 3> corners;
    for (std::size_t q = 0; q < 3; ++q)
      for (std::size_t i = 0; i < 3; ++i) corners[q][i] = mesh.point(ring[(2 * q + i) % 6]);
    return corners;
  }

  // A compass search for the place that makes the worst of the three quads best.
  static std::pair<Vec2, double> best_centre(const Mesh& mesh, const Hexagon& ring) {
    const auto corners = corners_of(mesh, ring);
    const auto worst_at = [&](Vec2 p) {
      double worst = 1;
      for (const auto& [a, b, c] : corners) worst = std::min(worst, scaled_jacobian(a, b, c, p));
      return worst;
    };
    Vec2 offset;
    double spread = 0;
    const Vec2 origin = corners[0][0];
    for (const auto& quad : corners)
      offset = offset + (1.0 / 6.0) * ((quad[0] - origin) + (quad[1] - origin));
    Vec2 best = origin + offset;
    for (const auto& quad : corners) spread = std::max(spread, distance(best, quad[0]));
    double most = worst_at(best);
    for (double step = 0.4 * spread; step > 0.01 * spread;) {
      bool found = false;
      for (const Vec2 way : {Vec2{1, 0}, Vec2{0, 1}, Vec2{-1, 0}, Vec2{0, -1}, Vec2{0.7, 0.7},
                             Vec2{-0.7, 0.7}, Vec2{-0.7, -0.7}, Vec2{0.7, -0.7}}) {
        const Vec2 tried = best + step * way;
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

  static bool valid(const Mesh& mesh, const Hexagon& ring, Vec2 p) {
    for (const auto& [a, b, c] : corners_of(mesh, ring))
      if (!(orient2d(p, a, b) > 0 && orient2d(a, b, c) > 0 && orient2d(b, c, p) > 0 && orient2d(c, p, a) > 0))
        return false;
    return true;
  }

  ConstraintTags tags_;
  OpeningOptions options_;
};

}  // namespace

PassReport open_straight_corners(Mesh& mesh, const OpeningOptions& options, const Progress& progress) {
  const OpenStraightCorner operation(ConstraintTags::of(mesh), options);
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

}  // namespace quarry
