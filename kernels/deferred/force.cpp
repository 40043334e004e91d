#include "kernels/deferred/force.hpp"

#include <algorithm>
#include <vector>

#include "engine/geometry/predicates.hpp"
#include "kernels/deferred/insert_pieces.hpp"
#include "kernels/quality/element.hpp"

namespace quarry::deferred {
namespace {

// A side of a polygon that is no part of the segment: two corners and the old side on the polygon's side of it.
struct Rim {
  SideId old_side;
  SideId across;
  bool constrained = false;
  SideId now;  // the side that takes its place
};

// What a segment crosses: faces in order, and the corners of the two polygons beside it, each from the front to the
// vertex reached.
struct Crossing {
  std::vector<FaceId> faces;
  std::vector<VertexId> right, left;
  std::vector<Rim> right_rim, left_rim;  // rim i joins corners i and i + 1
  VertexId reached;
};

Crossing collect(const Mesh& mesh, const State& state, PieceId piece) {
  Crossing crossing;
  const VertexId front = state.front[piece];
  const VertexId end = state.vertex_of_node[state.lines.pieces[piece].to];
  const Vec2 p = mesh.point(front);
  const Vec2 q = mesh.point(end);
  const Exit exit = find_exit(mesh, state, piece);
  if (exit.kind != Exit::Kind::kEdge) return crossing;
  const auto rim = [&](SideId s) {
    return Rim{s, mesh.neighbour(s), state.tags.constrained(s), SideId()};
  };
  SideId crossed = exit.side;
  crossing.faces.push_back(crossed.face());
  crossing.right = {front, mesh.origin(crossed)};
  crossing.left = {front, mesh.target(crossed)};
  crossing.right_rim.push_back(rim(mesh.previous(crossed)));
  crossing.left_rim.push_back(rim(mesh.next(crossed)));
  for (;;) {
    const SideId t = mesh.neighbour(crossed);
    if (!t.valid() || state.tags.constrained(crossed)) return crossing;
    crossing.faces.push_back(t.face());
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

// Polygons of more corners than this are cut by the Delaunay rule, which costs less than the best triangulation.
constexpr std::size_t kMostForBest = 48;

// Triangulates one polygon: corners counter-clockwise, the base from the last to the first.
class PolygonCutter {
 public:
  PolygonCutter(MeshEditor& editor, const State& state, const std::vector<VertexId>& corners, std::vector<Rim*> rims,
                const std::vector<FaceId>& faces, std::size_t& next_face)
      : editor_(editor), state_(state), corners_(corners), rims_(std::move(rims)), faces_(faces), next_face_(next_face) {
    for (const VertexId v : corners_) points_.push_back(editor.point(v));
    if (corners_.size() <= kMostForBest) find_best();
  }

  // The side that runs along the base, from the last corner to the first.
  SideId cut() { return cut(0, corners_.size() - 1); }

 private:
  [[nodiscard]] double quality(std::size_t i, std::size_t k, std::size_t j) const {
    return orient2d(points_[i], points_[k], points_[j]) > 0 ? lo_measure(points_[i], points_[k], points_[j]) : -1;
  }

  // best_[i, j]: the best worst measure of a triangulation of corners i..j, by all choices of the apex over i-j.
  void find_best() {
    const std::size_t n = corners_.size();
    std::vector<double> best(n * n, 2.0);
    apex_.assign(n * n, 0);
    for (std::size_t span = 2; span < n; ++span) {
      for (std::size_t i = 0; i + span < n; ++i) {
        const std::size_t j = i + span;
        best[i * n + j] = -2;
        for (std::size_t k = i + 1; k < j; ++k) {
          const double worst = std::min({quality(i, k, j), best[i * n + k], best[k * n + j]});
          if (worst > best[i * n + j]) {
            best[i * n + j] = worst;
            apex_[i * n + j] = k;
          }
        }
      }
    }
  }

  [[nodiscard]] std::size_t apex(std::size_t i, std::size_t j) const {
    if (!apex_.empty()) return apex_[i * corners_.size() + j];
    std::size_t chosen = i;
    for (std::size_t k = i + 1; k < j; ++k) {
      if (!(orient2d(points_[i], points_[k], points_[j]) > 0)) continue;
      if (chosen == i || incircle(points_[i], points_[chosen], points_[j], points_[k]) > 0) chosen = k;
    }
    return chosen;
  }

  SideId cut(std::size_t i, std::size_t j) {
    if (j == i + 1) return SideId();
    const std::size_t k = apex(i, j);
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
  std::vector<Vec2> points_;
  std::vector<std::size_t> apex_;
};

// Joins the new sides on the rim to what lay across; where the region met itself along an edge, to each other.
void join_rims(MeshEditor& editor, const State& state, std::vector<Rim*>& rims) {
  for (const Rim* rim : rims) {
    const auto twin = std::find_if(rims.begin(), rims.end(), [&](const Rim* r) { return r->old_side == rim->across; });
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
    if (!editor.mesh().neighbour(rim->now).valid()) editor.set_side_of(editor.mesh().origin(rim->now), rim->now);
}

}  // namespace

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
  // Hull vertices keep their first side unless its edge is rebuilt; remember those that do not touch the region's rim.
  std::vector<std::pair<VertexId, SideId>> kept;
  for (const auto* chain : {&crossing.right, &crossing.left})
    for (const VertexId v : *chain)
      if (editor.mesh().on_boundary(v)) kept.emplace_back(v, editor.side_of(v));

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
  join_rims(editor, state, rims);
  for (const auto& [v, side] : kept)
    if (std::find(crossing.faces.begin(), crossing.faces.end(), side.face()) == crossing.faces.end())
      editor.set_side_of(v, side);
  mend_first_sides(editor, rims);
  return crossing.reached;
}

}  // namespace quarry::deferred
