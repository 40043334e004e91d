#include "kernels/matching/whole_outline.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "engine/geometry/predicates.hpp"
#include "engine/mesh/balance.hpp"
#include "kernels/quality/element.hpp"

namespace quarry {
namespace {

constexpr std::size_t kMostFaces = 24;  // around a removed vertex

// The faces around a boundary vertex, counter-clockwise, and the path of vertices around them.
struct HalfStar {
  std::array<FaceId, kMostFaces> faces;
  std::array<SideId, kMostFaces> across;  // of the sides along the path
  std::array<bool, kMostFaces> constrained;
  std::array<VertexId, kMostFaces + 1> path;
  std::size_t count = 0;
  bool base_constrained = false;

  bool gather(const Mesh& mesh, const ConstraintTags& tags, VertexId v) {
    const SideId first = mesh.side_of(v);
    base_constrained = tags.constrained(first);
    path[0] = mesh.target(first);
    bool fits = true;
    for_each_side_around(mesh, v, [&](SideId s) {
      fits = fits && count < kMostFaces && mesh.corner_count(s.face()) == 3;
      if (!fits) return;
      const SideId outer = mesh.next(s);
      faces[count] = s.face();
      across[count] = mesh.neighbour(outer);
      constrained[count] = tags.constrained(outer);
      path[++count] = mesh.target(outer);
    });
    return fits && count >= 2;
  }
};

using Triangle = std::array<std::uint8_t, 3>;  // positions in the path

// The triangles of the polygon of a path, by cutting off its best ear again and again.
class EarCutting {
 public:
  EarCutting(const Mesh& mesh, const HalfStar& star) : size_(star.count + 1) {
    for (std::size_t i = 0; i < size_; ++i) {
      points_[i] = mesh.point(star.path[i]);
      left_[i] = static_cast<std::uint8_t>(i);
    }
  }

  // False if there is no valid ear at some time.
  bool run() {
    while (size_ > 3) {
      std::size_t best = size_;
      double most = 0;
      for (std::size_t i = 0; i < size_; ++i) {
        const Triangle ear = ear_at(i);
        const double worth = lo_measure(points_[ear[0]], points_[ear[1]], points_[ear[2]]);
        if (worth > most && is_empty(ear)) {
          most = worth;
          best = i;
        }
      }
      if (best == size_) return false;
      triangles_[count_++] = ear_at(best);
      std::copy(left_.begin() + static_cast<std::ptrdiff_t>(best) + 1,
                left_.begin() + static_cast<std::ptrdiff_t>(size_),
                left_.begin() + static_cast<std::ptrdiff_t>(best));
      --size_;
    }
    const Triangle last{left_[0], left_[1], left_[2]};
    triangles_[count_++] = last;
    return turns_left(last);
  }
  [[nodiscard]] std::span<const Triangle> triangles() const { return std::span(triangles_).first(count_); }

 private:
  [[nodiscard]] Triangle ear_at(std::size_t i) const {
    return {left_[(i + size_ - 1) % size_], left_[i], left_[(i + 1) % size_]};
  }
  [[nodiscard]] bool turns_left(Triangle t) const {
    return orient2d(points_[t[0]], points_[t[1]], points_[t[2]]) > 0;
  }
  // True if the triangle turns left and no other vertex of what is left lies in it or on it.
  [[nodiscard]] bool is_empty(Triangle t) const {
    if (!turns_left(t)) return false;
    for (std::size_t i = 0; i < size_; ++i) {
      if (std::find(t.begin(), t.end(), left_[i]) != t.end()) continue;
      const Vec2 p = points_[left_[i]];
      bool outside = false;
      for (std::size_t k = 0; k < 3; ++k)
        outside = outside || orient2d(points_[t[k]], points_[t[(k + 1) % 3]], p) < 0;
      if (!outside) return false;
    }
    return true;
  }

  std::array<Vec2, kMostFaces + 1> points_;
  std::array<std::uint8_t, kMostFaces + 1> left_;
  std::size_t size_;
  std::array<Triangle, kMostFaces> triangles_;
  std::size_t count_ = 0;
};

class TakeOutOfOutline {
 public:
  using Item = VertexId;
  struct Plan {};

  TakeOutOfOutline(ConstraintTags tags, const NodedLines& lines) : tags_(tags), lines_(&lines) {}

  [[nodiscard]] bool concerns(const Mesh& mesh, VertexId v) const {
    if (!mesh.alive(v) || !mesh.on_boundary(v)) return false;
    const Support support = tags_.support[v];
    return support.slides() && lines_->pieces[support.piece()].kind == PieceKindOf::kOutline;
  }

  bool propose(const Mesh& mesh, VertexId v, Cavity& cavity, Plan& /*plan*/) const {
    HalfStar star;
    if (!concerns(mesh, v) || !star.gather(mesh, tags_, v)) return false;
    if (!EarCutting(mesh, star).run()) return false;
    cavity.claim(v);
    for (std::size_t i = 0; i <= star.count; ++i) cavity.claim(star.path[i]);
    return true;
  }

  void apply(MeshEditor& editor, VertexId v, const Plan& /*plan*/, NewIds /*ids*/,
             FollowUps<VertexId>& /*more*/) const {
    HalfStar star;
    (void)star.gather(editor.mesh(), tags_, v);
    EarCutting cutting(editor.mesh(), star);
    (void)cutting.run();
    std::array<bool, kMostFaces + 1> wants_side{};
    for (std::size_t i = 0; i <= star.count; ++i) {
      const FaceId named = editor.side_of(star.path[i]).face();
      wants_side[i] =
          std::find(star.faces.begin(), star.faces.begin() + static_cast<std::ptrdiff_t>(star.count),
                    named) != star.faces.begin() + static_cast<std::ptrdiff_t>(star.count);
    }
    const std::span<const Triangle> triangles = cutting.triangles();
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      const auto& [a, b, c] = triangles[i];
      editor.set_triangle(star.faces[i], star.path[a], star.path[b], star.path[c]);
    }
    editor.delete_face(star.faces[star.count - 1]);
    editor.delete_vertex(v);
    for (std::size_t i = 0; i < triangles.size(); ++i) join(editor, star, triangles, i);
    name_sides(editor, star, triangles, wants_side);
  }

 private:
  // Joins the sides of one new triangle: sides of the path to what lay across, the base to nothing, others to
  // each other.
  void join(MeshEditor& editor, const HalfStar& star, std::span<const Triangle> triangles,
            std::size_t at) const {
    std::uint8_t bits = 0;
    for (int k = 0; k < 3; ++k) {
      const SideId side(star.faces[at], k);
      const std::uint8_t from = triangles[at][static_cast<std::size_t>(k)];
      const std::uint8_t to = triangles[at][static_cast<std::size_t>((k + 1) % 3)];
      const bool base = from == star.count && to == 0;
      if (base || to == from + 1) {
        editor.join(side, base ? SideId() : star.across[from]);
        if (base ? star.base_constrained : star.constrained[from])
          bits = static_cast<std::uint8_t>(bits | (1U << k));
        continue;
      }
      for (std::size_t i = 0; i < triangles.size(); ++i)
        for (int l = 0; l < 3; ++l)
          if (triangles[i][static_cast<std::size_t>(l)] == to &&
              triangles[i][static_cast<std::size_t>((l + 1) % 3)] == from)
            editor.join(side, SideId(star.faces[i], l));
    }
    editor.set(tags_.sides, star.faces[at], bits);
  }

  // A boundary side where there is one, which then is the most clockwise.
  static void name_sides(MeshEditor& editor, const HalfStar& star, std::span<const Triangle> triangles,
                         const std::array<bool, kMostFaces + 1>& wants_side) {
    std::array<bool, kMostFaces + 1> named{};
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      for (int k = 0; k < 3; ++k) {
        const SideId side(star.faces[i], k);
        const std::uint8_t from = triangles[i][static_cast<std::size_t>(k)];
        if (!wants_side[from]) continue;
        if (named[from] && editor.mesh().neighbour(side).valid()) continue;
        editor.set_side_of(star.path[from], side);
        named[from] = true;
      }
    }
  }

  ConstraintTags tags_;
  const NodedLines* lines_;
};

}  // namespace

PassReport make_outline_whole(Mesh& mesh, const NodedLines& lines, const Progress& progress) {
  const BalanceGuard balance(mesh);
  const TakeOutOfOutline operation(ConstraintTags::of(mesh), lines);
  const auto found = parallel::filter_indices(
      mesh.vertex_slots(), [&](std::size_t i) { return operation.concerns(mesh, VertexId(i)); });
  std::vector<VertexId> work;
  work.reserve(found.size());
  for (const std::uint32_t i : found) work.emplace_back(i);
  PassReport report = run_pass(mesh, operation, std::move(work), PassOptions(), progress);
  report.name = "vertices taken out of the outline";
  balance.check("taking vertices out of the outline", mesh, GeometryCheck::kPlanarCorners);
  for (const VertexId v : mesh.vertices()) {
    if (!operation.concerns(mesh, v)) continue;
    const Vec2 p = mesh.point(v);
    throw Error(
        ErrorKind::kGeometry,
        fmt::format("the outline needs a vertex at {}, which it does not have: add one, or mesh without "
                    "--keep-boundary",
                    format_point(p.x, p.y)));
  }
  return report;
}

}  // namespace quarry
