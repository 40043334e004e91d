#include "kernels/matching/rings.hpp"

#include <array>
#include <cstddef>
#include <vector>

#include "engine/geometry/predicates.hpp"
#include "engine/geometry/segment.hpp"
#include "kernels/local/replace.hpp"
#include "kernels/matching/quad_shape.hpp"

namespace quarry {
namespace {

constexpr std::size_t kMostFaces = 12;  // around the ringed vertex
// Where the centre of a quad may lie on its diagonal from the ringed vertex: beyond the line through the two
// midpoints, which crosses the diagonal of a convex quad before its middle, and farther out the more reflex
// the corner at its end is.
constexpr std::array<double, 4> kCentreShares = {0.6, 0.75, 0.87, 0.95};

class RingAround {
 public:
  using Item = FaceId;
  struct Plan {
    SideId first;  // at the vertex that gets the ring
  };

  RingAround(ConstraintTags tags, const NodedLines& lines) : tags_(tags), lines_(&lines), finder_(lines) {}

  bool propose(const Mesh& mesh, FaceId f, Cavity& cavity, Plan& plan) const {
    if (!mesh.alive(f) || mesh.corner_count(f) != 4 || matching::is_convex(mesh, f)) return false;
    const VertexId v = mesh.origin(opposite_of_worst_corner(mesh, f));
    if (mesh.on_boundary(v)) return false;
    Star star;
    if (!star.gather(*this, mesh, v)) return false;
    if (!star.mends(f) || star.invalid_after() > star.invalid_before(mesh)) return false;
    plan.first = mesh.side_of(v);
    cavity.claim(v);
    for (std::size_t i = 0; i < star.count; ++i) {
      cavity.claim(mesh.target(star.spokes[i].side));
      cavity.claim(opposite(mesh, star.spokes[i].side));
    }
    const auto count = static_cast<std::uint32_t>(star.count);
    cavity.will_create(2 * count, 2 * count);
    return true;
  }

  void apply(MeshEditor& editor, FaceId /*f*/, const Plan& plan, NewIds ids,
             FollowUps<FaceId>& /*more*/) const {
    const Mesh& mesh = editor.mesh();
    const VertexId v = mesh.origin(plan.first);
    Star star;
    (void)star.gather(*this, mesh, v);
    std::array<VertexId, kMostFaces> middles, centres;
    for (std::size_t i = 0; i < star.count; ++i) {
      middles[i] = place(editor, ids, star.spokes[i].middle, star.spokes[i].support);
      centres[i] = place(editor, ids, star.spokes[i].centre, Support::free());
    }
    std::array<FaceId, kMostFaces> old;
    std::array<FaceCorners, 3 * kMostFaces> fresh;
    for (std::size_t i = 0; i < star.count; ++i) {
      const std::size_t next = (i + 1) % star.count;
      const SideId s = star.spokes[i].side;
      const VertexId far = opposite(mesh, s);
      old[i] = s.face();
      fresh[3 * i] = {v, middles[i], centres[i], middles[next]};
      fresh[3 * i + 1] = {middles[i], mesh.target(s), far, centres[i]};
      fresh[3 * i + 2] = {centres[i], far, mesh.target(star.spokes[next].side), middles[next]};
    }
    thread_local FaceReplacer replacer;
    const auto slots = replacer.replace(editor, tags_, std::span(old).first(star.count),
                                        std::span(fresh).first(3 * star.count), ids);
    constrain_halves(star, slots);
  }

 private:
  struct Spoke {
    SideId side;  // from the vertex outwards
    bool constrained;
    Support support;  // of its middle
    Vec2 middle;
    Vec2 centre{};  // of the quad to the left
  };

  // The quads around a vertex, counter-clockwise, and what a ring would make of them.
  struct Star {
    Vec2 here;
    std::array<Spoke, kMostFaces> spokes;
    std::array<Vec2, kMostFaces> ends, fars;
    std::size_t count = 0;

    // False if there are too many faces or one is no quad.
    bool gather(const RingAround& operation, const Mesh& mesh, VertexId v) {
      here = mesh.point(v);
      bool fits = true;
      for_each_side_around(mesh, v, [&](SideId s) {
        fits = fits && count < kMostFaces && mesh.corner_count(s.face()) == 4;
        if (!fits) return;
        ends[count] = mesh.point(mesh.target(s));
        fars[count] = mesh.point(opposite(mesh, s));
        spokes[count++] = operation.spoke_of(mesh, s);
      });
      for (std::size_t i = 0; fits && i < count; ++i) place_centre(i);
      return fits;
    }
    // The first place that makes all parts of the quad valid, or that with which the fewest are not.
    void place_centre(std::size_t i) {
      Vec2 best;
      int fewest = 4;
      for (const double share : kCentreShares) {
        spokes[i].centre = here + share * (fars[i] - here);
        const int invalid = invalid_parts(i);
        if (invalid >= fewest) continue;
        fewest = invalid;
        best = spokes[i].centre;
      }
      spokes[i].centre = best;
    }
    // Of the three parts of one quad.
    [[nodiscard]] int invalid_parts(std::size_t i) const {
      const std::size_t next = (i + 1) % count;
      const Vec2 middle = spokes[i].middle, centre = spokes[i].centre, other = spokes[next].middle;
      return (matching::is_convex({here, middle, centre, other}) ? 0 : 1) +
             (matching::is_convex({middle, ends[i], fars[i], centre}) ? 0 : 1) +
             (matching::is_convex({centre, fars[i], ends[next], other}) ? 0 : 1);
    }
    [[nodiscard]] int invalid_before(const Mesh& mesh) const {
      int sum = 0;
      for (std::size_t i = 0; i < count; ++i) sum += matching::is_convex(mesh, spokes[i].side.face()) ? 0 : 1;
      return sum;
    }
    // True if all parts of the face are valid.
    [[nodiscard]] bool mends(FaceId f) const {
      for (std::size_t i = 0; i < count; ++i)
        if (spokes[i].side.face() == f) return invalid_parts(i) == 0;
      return false;
    }
    [[nodiscard]] int invalid_after() const {
      int sum = 0;
      for (std::size_t i = 0; i < count; ++i) sum += invalid_parts(i);
      return sum;
    }
  };

  static VertexId opposite(const Mesh& mesh, SideId s) { return mesh.target(mesh.next(s)); }

  // The side that starts opposite the corner with the largest angle: where the quad is farthest from turning
  // left.
  static SideId opposite_of_worst_corner(const Mesh& mesh, FaceId f) {
    SideId worst;
    double least = 0;
    for (int k = 0; k < 4; ++k) {
      const SideId s(f, k);
      const double turn = orient2d(mesh.point(mesh.origin(mesh.previous(s))), mesh.point(mesh.origin(s)),
                                   mesh.point(mesh.target(s)));
      if (worst.valid() && turn >= least) continue;
      worst = s;
      least = turn;
    }
    return mesh.next(mesh.next(worst));
  }

  [[nodiscard]] Spoke spoke_of(const Mesh& mesh, SideId s) const {
    const Vec2 a = mesh.point(mesh.origin(s));
    const Vec2 b = mesh.point(mesh.target(s));
    Spoke spoke{s, tags_.constrained(s), Support::free(), midpoint(a, b)};
    if (!spoke.constrained) return spoke;
    const PieceId id = finder_.under_edge(tags_.support[mesh.origin(s)], tags_.support[mesh.target(s)]);
    const Piece& piece = lines_->pieces[id];
    spoke.support = Support::on(id);
    spoke.middle = closest_point(spoke.middle, lines_->nodes[piece.from], lines_->nodes[piece.to]);
    return spoke;
  }

  VertexId place(MeshEditor& editor, NewIds& ids, Vec2 p, Support support) const {
    const VertexId v = ids.take_vertex();
    editor.set_point(v, p);
    editor.set(tags_.support, v, support);
    return v;
  }

  // Both halves of a constrained spoke, seen from both sides: in the quads of its own face and of the one
  // before.
  void constrain_halves(const Star& star, std::span<const FaceId> slots) const {
    ConstraintTags tags = tags_;
    for (std::size_t i = 0; i < star.count; ++i) {
      if (!star.spokes[i].constrained) continue;
      const std::size_t before = (i + star.count - 1) % star.count;
      tags.set_constrained(SideId(slots[3 * i], 0), true);
      tags.set_constrained(SideId(slots[3 * before], 3), true);
      tags.set_constrained(SideId(slots[3 * i + 1], 0), true);
      tags.set_constrained(SideId(slots[3 * before + 2], 2), true);
    }
  }

  ConstraintTags tags_;
  const NodedLines* lines_;
  PieceFinder finder_;
};

}  // namespace

PassReport ring_straight_corners(Mesh& mesh, const NodedLines& lines, const Progress& progress) {
  const RingAround operation(ConstraintTags::of(mesh), lines);
  const auto invalid = parallel::filter_indices(mesh.face_slots(), [&](std::size_t i) {
    return mesh.alive(FaceId(i)) && !matching::is_convex(mesh, FaceId(i));
  });
  std::vector<FaceId> work;
  for (const std::uint32_t i : invalid) work.emplace_back(i);
  PassReport report = run_pass(mesh, operation, std::move(work), PassOptions(), progress);
  report.name = "rings at straight corners";
  return report;
}

}  // namespace quarry
