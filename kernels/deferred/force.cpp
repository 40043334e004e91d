#include "kernels/deferred/force.hpp"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "engine/geometry/predicates.hpp"
#include "kernels/deferred/insert_pieces.hpp"
#include "kernels/deferred/polygon_plan.hpp"
#include "kernels/local/split.hpp"

namespace quarry::deferred {
namespace {

// A side of a polygon that is no part of the segment: two corners and the old side on the polygon's side of
// it.
struct Rim {
  SideId old_side;
  SideId across;
  bool constrained = false;
  SideId now;  // the side that takes its place
};

// What a segment crosses: faces in order, and the corners of the two polygons beside it, each from the front
// to the vertex reached.
struct Crossing {
  std::vector<FaceId> faces;
  std::vector<VertexId> right, left;
  std::vector<Rim> right_rim, left_rim;  // rim i joins corners i and i + 1
  std::vector<Vec2> entries;             // where each face but the first is entered
  VertexId reached;
  Rim exit;         // of the last face, where the walk was stopped before it reached a vertex
  Vec2 exit_point;  // the crossing there
};

// No bridge is longer than this many faces.
constexpr std::size_t kLongestBridge = 8;

Vec2 crossing_of(const Mesh& mesh, SideId s, Vec2 p, Vec2 q) {
  const Vec2 a = mesh.point(mesh.origin(s));
  const Vec2 b = mesh.point(mesh.target(s));
  const double right = orient2d(p, q, a);
  return a + (right / (right - orient2d(p, q, b))) * (b - a);
}

// Walks along the rest of a piece, over at most most_faces faces.
Crossing collect(const Mesh& mesh, const State& state, PieceId piece,
                 std::size_t most_faces = std::numeric_limits<std::size_t>::max()) {
  Crossing crossing;
  const VertexId front = state.front[piece];
  const VertexId end = state.vertex_of_node[state.lines.pieces[piece].to];
  const Vec2 p = mesh.point(front);
  const Vec2 q = mesh.point(end);
  const Exit exit = find_exit(mesh, state, piece);
  if (exit.kind != Exit::Kind::kEdge) return crossing;
  const auto rim = [&](SideId s) { return Rim{s, mesh.neighbour(s), state.tags.constrained(s), SideId()}; };
  SideId crossed = exit.side;
  crossing.faces.push_back(crossed.face());
  crossing.right = {front, mesh.origin(crossed)};
  crossing.left = {front, mesh.target(crossed)};
  crossing.right_rim.push_back(rim(mesh.previous(crossed)));
  crossing.left_rim.push_back(rim(mesh.next(crossed)));
  for (;;) {
    const SideId t = mesh.neighbour(crossed);
    if (!t.valid() || state.tags.constrained(crossed)) return crossing;
    if (crossing.faces.size() == most_faces) {
      crossing.exit = rim(crossed);
      crossing.exit_point = crossing_of(mesh, crossed, p, q);
      return crossing;
    }
    crossing.faces.push_back(t.face());
    crossing.entries.push_back(crossing_of(mesh, crossed, p, q));
    const VertexId apex = mesh.origin(mesh.previous(t));
    // t runs from the left end of the crossed edge to its right end.
    const SideId right_side = mesh.next(t);
    const SideId left_side = mesh.previous(t);
    const double turn = apex == end ? 0 : orient2d(p, q, mesh.point(apex));
    if (turn <= 0) {
      crossing.right.push_back(apex);
      crossing.right_rim.push_back(rim(right_side));
    }
    if (turn >= 0) {
      crossing.left.push_back(apex);
      crossing.left_rim.push_back(rim(left_side));
    }
    if (turn == 0) {
      crossing.reached = apex;
      return crossing;
    }
    crossed = turn < 0 ? left_side : right_side;
  }
}

// Carries a plan out: makes the triangles in place of old faces.
class PolygonCutter {
 public:
  PolygonCutter(MeshEditor& editor, const State& state, const std::vector<VertexId>& corners,
                std::vector<Rim*> rims, const std::vector<FaceId>& faces, std::size_t& next_face)
      : editor_(editor),
        state_(state),
        corners_(corners),
        rims_(std::move(rims)),
        faces_(faces),
        next_face_(next_face),
        plan_(points_of(editor, corners)) {}

  // The side that runs along the base, from the last corner to the first.
  SideId cut() { return cut(0, corners_.size() - 1); }

 private:
  static std::vector<Vec2> points_of(const MeshEditor& editor, const std::vector<VertexId>& corners) {
    std::vector<Vec2> points;
    points.reserve(corners.size());
    for (const VertexId v : corners) points.push_back(editor.point(v));
    return points;
  }

  SideId cut(std::size_t i, std::size_t j) {
    if (j == i + 1) return SideId();
    const std::size_t k = plan_.apex(i, j);
    const FaceId f = faces_[next_face_++];
    editor_.set_triangle(f, corners_[i], corners_[k], corners_[j]);
    editor_.set(state_.tags.sides, f, std::uint8_t{0});
    attach(SideId(f, 0), i, k);
    attach(SideId(f, 1), k, j);
    for (int c = 0; c < 3; ++c) editor_.set_side_of(editor_.corner(f, c), SideId(f, c));
    return SideId(f, 2);
  }

  void attach(SideId side, std::size_t i, std::size_t j) {
    if (j == i + 1) {
      rims_[i]->now = side;
      return;
    }
    const SideId base = cut(i, j);
    editor_.join(side, base);
  }

  MeshEditor& editor_;
  const State& state_;
  std::vector<VertexId> corners_;
  std::vector<Rim*> rims_;
  const std::vector<FaceId>& faces_;
  std::size_t& next_face_;
  PolygonPlan plan_;
};

// Joins the new sides on the rim to what lay across; where the region met itself along an edge, to each
// other.
void join_rims(MeshEditor& editor, const State& state, std::vector<Rim*>& rims) {
  for (const Rim* rim : rims) {
    const auto twin =
        std::find_if(rims.begin(), rims.end(), [&](const Rim* r) { return r->old_side == rim->across; });
    editor.join(rim->now, twin == rims.end() ? rim->across : (*twin)->now);
    if (rim->constrained) {
      const FaceId f = rim->now.face();
      editor.set(state.tags.sides, f,
                 static_cast<std::uint8_t>(state.tags.sides[f] | (1U << rim->now.index())));
    }
  }
}

// On the hull the first side of a vertex must be the most clockwise one.
void mend_first_sides(MeshEditor& editor, const std::vector<Rim*>& rims) {
  for (const Rim* rim : rims)
    if (!editor.mesh().neighbour(rim->now).valid())
      editor.set_side_of(editor.mesh().origin(rim->now), rim->now);
}

// First sides of hull vertices on the rim of a region that is rebuilt: kept where they lie outside it.
class HullSides {
 public:
  HullSides(const MeshEditor& editor, const Crossing& crossing) : faces_(crossing.faces) {
    for (const auto* chain : {&crossing.right, &crossing.left})
      for (const VertexId v : *chain)
        if (editor.mesh().on_boundary(v)) kept_.emplace_back(v, editor.side_of(v));
  }
  void restore(MeshEditor& editor) const {
    for (const auto& [v, side] : kept_)
      if (std::find(faces_.begin(), faces_.end(), side.face()) == faces_.end()) editor.set_side_of(v, side);
  }

 private:
  const std::vector<FaceId>& faces_;
  std::vector<std::pair<VertexId, SideId>> kept_;
};

void finish(MeshEditor& editor, const State& state, std::vector<Rim*>& rims, const HullSides& hull) {
  join_rims(editor, state, rims);
  hull.restore(editor);
  mend_first_sides(editor, rims);
}

// The corners of a bridge's region, a polygon with a slit: the front, the right corners, the left ones, and
// the front again. The target goes before them.
std::vector<VertexId> around_slit(const Crossing& crossing) {
  std::vector<VertexId> corners = crossing.right;
  corners.insert(corners.end(), crossing.left.rbegin(), crossing.left.rend());
  return corners;
}

// True if the target lies strictly inside the last face, and the segment from the front to it leaves each
// corner on the side on which the piece leaves it.
bool can_reach(const Mesh& mesh, const Crossing& crossing, Vec2 target) {
  if (!can_split_face(mesh, crossing.faces.back(), target)) return false;
  const Vec2 p = mesh.point(crossing.right[0]);
  const auto turn = [&](VertexId v) { return orient2d(p, target, mesh.point(v)); };
  return std::all_of(crossing.right.begin() + 1, crossing.right.end(),
                     [&](VertexId v) { return turn(v) < 0; }) &&
         std::all_of(crossing.left.begin() + 1, crossing.left.end(), [&](VertexId v) { return turn(v) > 0; });
}

}  // namespace

Bridge best_bridge(const Mesh& mesh, const State& state, PieceId piece) {
  Bridge best;
  for (std::size_t faces = 2; faces <= kLongestBridge; ++faces) {
    const Crossing crossing = collect(mesh, state, piece, faces);
    if (!crossing.exit.old_side.valid()) break;
    const Vec2 target = midpoint(crossing.entries.back(), crossing.exit_point);
    if (!can_reach(mesh, crossing, target)) continue;
    std::vector<Vec2> points{target};
    for (const VertexId v : around_slit(crossing)) points.push_back(mesh.point(v));
    const double worst = PolygonPlan(std::move(points)).worst();
    if (worst > best.worst) best = {faces, target, worst};
  }
  return best;
}

void claim_bridge(const Mesh& mesh, const State& state, PieceId piece, const Bridge& bridge, Cavity& cavity) {
  for (const VertexId v : around_slit(collect(mesh, state, piece, bridge.faces))) cavity.claim(v);
  cavity.will_create(1, 2);
}

VertexId build_bridge(MeshEditor& editor, const State& state, PieceId piece, const Bridge& bridge,
                      NewIds ids) {
  Crossing crossing = collect(editor.mesh(), state, piece, bridge.faces);
  const HullSides hull(editor, crossing);
  const VertexId target = ids.take_vertex();
  editor.set_point(target, bridge.target);
  editor.set(state.tags.support, target, Support::on(piece));
  std::vector<VertexId> corners = around_slit(crossing);
  corners.insert(corners.begin(), target);
  std::vector<FaceId> faces = crossing.faces;
  faces.push_back(ids.take_face());
  faces.push_back(ids.take_face());

  Rim slit;
  std::vector<Rim*> rims;
  for (Rim& rim : crossing.right_rim) rims.push_back(&rim);
  rims.push_back(&crossing.exit);
  for (std::size_t i = crossing.left_rim.size(); i-- > 0;) rims.push_back(&crossing.left_rim[i]);
  std::vector<Rim*> with_slit = rims;
  with_slit.insert(with_slit.begin(), &slit);
  std::size_t next_face = 0;
  const SideId base = PolygonCutter(editor, state, corners, with_slit, faces, next_face).cut();
  editor.join(slit.now, base);
  finish(editor, state, rims, hull);
  return target;
}

void claim_crossed(const Mesh& mesh, const State& state, PieceId piece, Cavity& cavity) {
  cavity.claim(state.front[piece]);
  for (const FaceId f : collect(mesh, state, piece).faces)
    for (int k = 0; k < 3; ++k) cavity.claim(mesh.corner(f, k));
}

VertexId rebuild_crossed(MeshEditor& editor, const State& state, PieceId piece) {
  Crossing crossing = collect(editor.mesh(), state, piece);
  if (!crossing.reached.valid()) return {};
  std::vector<Rim*> right, left;
  for (Rim& rim : crossing.right_rim) right.push_back(&rim);
  for (Rim& rim : crossing.left_rim) left.push_back(&rim);
  const HullSides hull(editor, crossing);
  std::vector<VertexId> left_corners(crossing.left.rbegin(), crossing.left.rend());
  std::reverse(left.begin(), left.end());
  std::size_t next_face = 0;
  PolygonCutter right_cutter(editor, state, crossing.right, right, crossing.faces, next_face);
  PolygonCutter left_cutter(editor, state, left_corners, left, crossing.faces, next_face);
  const SideId right_base = right_cutter.cut();
  const SideId left_base = left_cutter.cut();
  editor.join(right_base, left_base);
  std::vector<Rim*> rims = right;
  rims.insert(rims.end(), left.begin(), left.end());
  finish(editor, state, rims, hull);
  return crossing.reached;
}

}  // namespace quarry::deferred
