#include "kernels/matching/rings.hpp"

#include <algorithm>
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
// Where the edges at the ringed vertex are cut: nearer to it where the straight corner is reflex and comes
// close to it.
constexpr std::array<double, 4> kCuts = {0.5, 0.35, 0.25, 0.15};
// Where the centre of a quad may lie on its diagonal from the ringed vertex: beyond the line through the two
// cuts, which crosses the diagonal of a convex quad before its middle, and farther out the more reflex the
// corner at its end is.
constexpr std::array<double, 4> kCentreShares = {0.6, 0.75, 0.87, 0.95};

// What speaks against a quad: one that is inverted, or flat by its last bits, counts more than all parts of a
// star that are nearly straight at a corner.
constexpr int kInverted = 256;
constexpr double kNearlyStraight = 0.02;  // sine of a corner beyond 90 degrees
int badness(const std::array<Vec2, 4>& quad) {
  if (matching::is_convex(quad, kNearlyStraight)) return 0;
  return matching::is_convex(quad) ? 1 : kInverted;
}

class RingAround {
 public:
  using Item = FaceId;
  struct Plan {
    SideId first;  // at the vertex that gets the ring
    double cut;    // of kCuts
  };

  RingAround(ConstraintTags tags, const NodedLines& lines, const RingOptions& options)
      : tags_(tags), lines_(&lines), finder_(lines), options_(options) {}

  bool propose(const Mesh& mesh, FaceId f, Cavity& cavity, Plan& plan) const {
    if (!mesh.alive(f) || mesh.corner_count(f) != 4) return false;
    const int before = badness(matching::corners_of_quad(mesh, f));
    if (before == 0) return false;
    const VertexId v = mesh.origin(opposite_of_worst_corner(mesh, f));
    if (options_.keep_boundary && mesh.on_boundary(v)) return false;
    plan.first = mesh.side_of(v);
    Star star;
    const auto mends = [&](double cut) {
      plan.cut = cut;
      star = Star();
      if (!star.gather(*this, mesh, v, cut) || star.badness_of_parts_of(f) >= before) return false;
      // An inverted quad may become others elsewhere, which the next call may mend; one that is flat may not.
      const int change = star.badness_after() - star.badness_before(mesh);
      return before >= kInverted ? change <= 0 : change < 0;
    };
    if (std::none_of(kCuts.begin(), kCuts.end(), mends)) return false;
    cavity.claim(v);
    for (std::size_t i = 0; i < star.spoke_count; ++i) cavity.claim(star.spokes[i].end);
    for (std::size_t i = 0; i < star.count; ++i) cavity.claim(opposite(mesh, star.faces[i].side));
    const auto created = static_cast<std::uint32_t>(star.spoke_count + star.count);
    cavity.will_create(created, static_cast<std::uint32_t>(2 * star.count));
    return true;
  }

  void apply(MeshEditor& editor, FaceId /*f*/, const Plan& plan, NewIds ids,
             FollowUps<FaceId>& /*more*/) const {
    const Mesh& mesh = editor.mesh();
    const VertexId v = mesh.origin(plan.first);
    Star star;
    (void)star.gather(*this, mesh, v, plan.cut);
    std::array<VertexId, kMostFaces + 1> cuts;
    std::array<VertexId, kMostFaces> centres;
    for (std::size_t i = 0; i < star.spoke_count; ++i)
      cuts[i] = place(editor, ids, star.spokes[i].cut, star.spokes[i].support);
    for (std::size_t i = 0; i < star.count; ++i)
      centres[i] = place(editor, ids, star.faces[i].centre, Support::free());
    std::array<FaceId, kMostFaces> old;
    std::array<FaceCorners, 3 * kMostFaces> fresh;
    for (std::size_t i = 0; i < star.count; ++i) {
      const std::size_t next = star.after(i);
      const VertexId far = opposite(mesh, star.faces[i].side);
      old[i] = star.faces[i].side.face();
      fresh[3 * i] = {v, cuts[i], centres[i], cuts[next]};
      fresh[3 * i + 1] = {cuts[i], star.spokes[i].end, far, centres[i]};
      fresh[3 * i + 2] = {centres[i], far, star.spokes[next].end, cuts[next]};
    }
    thread_local FaceReplacer replacer;
    const auto slots = replacer.replace(editor, tags_, std::span(old).first(star.count),
                                        std::span(fresh).first(3 * star.count), ids);
    constrain_parts(star, slots);
  }

 private:
  // An edge at the vertex that gets the ring.
  struct Spoke {
    VertexId end;
    Vec2 end_place, cut;
    bool constrained;
    Support support;  // of the cut
  };
  // A quad at it; its first spoke has the same number.
  struct StarFace {
    SideId side;  // from the vertex outwards
    Vec2 far, centre;
  };

  // The quads around a vertex, counter-clockwise, and what a ring would make of them. On the boundary there
  // is a spoke more than faces.
  struct Star {
    Vec2 here;
    std::array<Spoke, kMostFaces + 1> spokes;
    std::array<StarFace, kMostFaces> faces;
    std::size_t count = 0, spoke_count = 0;

    // False if there are too many faces or one is no quad.
    bool gather(const RingAround& operation, const Mesh& mesh, VertexId v, double cut) {
      here = mesh.point(v);
      bool fits = true;
      for_each_side_around(mesh, v, [&](SideId s) {
        fits = fits && count < kMostFaces && mesh.corner_count(s.face()) == 4;
        if (!fits) return;
        spokes[count] = operation.spoke_of(mesh, s, v, cut);
        faces[count++] = {s, mesh.point(opposite(mesh, s)), {}};
      });
      if (!fits) return false;
      spoke_count = count;
      if (mesh.on_boundary(v))
        spokes[spoke_count++] = operation.spoke_of(mesh, mesh.previous(faces[count - 1].side), v, cut);
      for (std::size_t i = 0; i < count; ++i) place_centre(i);
      return true;
    }
    // The spoke after a face.
    [[nodiscard]] std::size_t after(std::size_t i) const { return i + 1 < spoke_count ? i + 1 : 0; }
    // The first place that makes all parts of the quad good, or that with which they are least bad.
    void place_centre(std::size_t i) {
      Vec2 best;
      int least = 3 * kInverted + 1;
      for (const double share : kCentreShares) {
        faces[i].centre = here + share * (faces[i].far - here);
        const int bad = badness_of_parts(i);
        if (bad >= least) continue;
        least = bad;
        best = faces[i].centre;
      }
      faces[i].centre = best;
    }
    // Of the three parts of one quad.
    [[nodiscard]] int badness_of_parts(std::size_t i) const {
      const auto& [side, far, centre] = faces[i];
      const Spoke& one = spokes[i];
      const Spoke& other = spokes[after(i)];
      return badness({here, one.cut, centre, other.cut}) + badness({one.cut, one.end_place, far, centre}) +
             badness({centre, far, other.end_place, other.cut});
    }
    [[nodiscard]] int badness_of_parts_of(FaceId f) const {
      std::size_t i = 0;
      while (faces[i].side.face() != f) ++i;
      return badness_of_parts(i);
    }
    [[nodiscard]] int badness_before(const Mesh& mesh) const {
      int sum = 0;
      for (std::size_t i = 0; i < count; ++i)
        sum += badness(matching::corners_of_quad(mesh, faces[i].side.face()));
      return sum;
    }
    [[nodiscard]] int badness_after() const {
      int sum = 0;
      for (std::size_t i = 0; i < count; ++i) sum += badness_of_parts(i);
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

  // Of the side that joins the vertex to another, seen from either face.
  [[nodiscard]] Spoke spoke_of(const Mesh& mesh, SideId s, VertexId v, double cut) const {
    const VertexId end = mesh.origin(s) == v ? mesh.target(s) : mesh.origin(s);
    const Vec2 here = mesh.point(v);
    const Vec2 there = mesh.point(end);
    Spoke spoke{end, there, here + cut * (there - here), tags_.constrained(s), Support::free()};
    if (!spoke.constrained) return spoke;
    const PieceId id = finder_.under_edge(tags_.support[v], tags_.support[end]);
    const Piece& piece = lines_->pieces[id];
    spoke.support = Support::on(id);
    spoke.cut = closest_point(spoke.cut, lines_->nodes[piece.from], lines_->nodes[piece.to]);
    return spoke;
  }

  VertexId place(MeshEditor& editor, NewIds& ids, Vec2 p, Support support) const {
    const VertexId v = ids.take_vertex();
    editor.set_point(v, p);
    editor.set(tags_.support, v, support);
    return v;
  }

  // Both parts of a constrained spoke, seen from both sides: in the quads of the face after it and of the one
  // before.
  void constrain_parts(const Star& star, std::span<const FaceId> slots) const {
    ConstraintTags tags = tags_;
    for (std::size_t i = 0; i < star.count; ++i) {
      if (star.spokes[i].constrained) {
        tags.set_constrained(SideId(slots[3 * i], 0), true);
        tags.set_constrained(SideId(slots[3 * i + 1], 0), true);
      }
      if (star.spokes[star.after(i)].constrained) {
        tags.set_constrained(SideId(slots[3 * i], 3), true);
        tags.set_constrained(SideId(slots[3 * i + 2], 2), true);
      }
    }
  }

  ConstraintTags tags_;
  const NodedLines* lines_;
  PieceFinder finder_;
  RingOptions options_;
};

}  // namespace

PassReport ring_straight_corners(Mesh& mesh, const NodedLines& lines, const RingOptions& options,
                                 const Progress& progress) {
  const RingAround operation(ConstraintTags::of(mesh), lines, options);
  const auto bad = parallel::filter_indices(mesh.face_slots(), [&](std::size_t i) {
    const FaceId f(i);
    return mesh.alive(f) && mesh.corner_count(f) == 4 && badness(matching::corners_of_quad(mesh, f)) > 0;
  });
  std::vector<FaceId> work;
  for (const std::uint32_t i : bad) work.emplace_back(i);
  PassReport report = run_pass(mesh, operation, std::move(work), PassOptions(), progress);
  report.name = "rings at straight corners";
  return report;
}

}  // namespace quarry
