#include "kernels/cluster/subdivide.hpp"

#include <bit>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "engine/geometry/segment.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/cluster/centre.hpp"
#include "kernels/cluster/cut_quad.hpp"

namespace quarry {
namespace {

// Numbers of the fine mesh in closed form. Corner i of a coarse face is corner 0 of its quad i, whose sides
// are: the first half of side i, midpoint i to the centre, the centre to midpoint i-1, and the second half of
// side i-1.
class FineNumbers {
 public:
  explicit FineNumbers(const Mesh& mesh)
      : mesh_(mesh), quad_(mesh.face_slots()), midpoint_(mesh.face_slots()), centre_(mesh.face_slots()) {
    parallel::for_each(mesh.face_slots(), [&](std::size_t i) {
      const FaceId f(i);
      quad_[i] = mesh.alive(f) ? static_cast<std::uint32_t>(mesh.corner_count(f)) : 0;
      midpoint_[i] = mesh.alive(f) ? static_cast<std::uint32_t>(std::popcount(owned_sides(f))) : 0;
      centre_[i] = mesh.alive(f) ? 1 : 0;
    });
    quad_count_ = parallel::exclusive_scan(std::span(quad_));
    midpoint_count_ = parallel::exclusive_scan(std::span(midpoint_));
    centre_count_ = parallel::exclusive_scan(std::span(centre_));
  }

  [[nodiscard]] std::size_t quad_count() const { return quad_count_; }
  [[nodiscard]] std::size_t vertex_count() const {
    return mesh_.vertex_slots() + midpoint_count_ + centre_count_;
  }

  // An edge's midpoint is numbered by the smaller of its two sides.
  [[nodiscard]] bool owns(SideId s) const {
    const SideId across = mesh_.neighbour(s);
    return !across.valid() || s < across;
  }
  [[nodiscard]] VertexId midpoint(SideId s) const {
    const SideId owner = owns(s) ? s : mesh_.neighbour(s);
    const std::uint32_t before = owned_sides(owner.face()) & ((1U << owner.index()) - 1U);
    return VertexId(mesh_.vertex_slots() + midpoint_[owner.face().value()] +
                    static_cast<std::uint32_t>(std::popcount(before)));
  }
  [[nodiscard]] VertexId centre(FaceId f) const {
    return VertexId(mesh_.vertex_slots() + midpoint_count_ + centre_[f.value()]);
  }
  // The quad at the origin of a side.
  [[nodiscard]] FaceId quad(SideId s) const {
    return FaceId(quad_[s.face().value()] + static_cast<std::uint32_t>(s.index()));
  }
  [[nodiscard]] SideId first_half(SideId s) const { return {quad(s), 0}; }
  [[nodiscard]] SideId second_half(SideId s) const { return {quad(mesh_.next(s)), 3}; }

 private:
  [[nodiscard]] std::uint32_t owned_sides(FaceId f) const {
    std::uint32_t bits = 0;
    for (int k = 0; k < mesh_.corner_count(f); ++k)
      if (owns(SideId(f, k))) bits |= 1U << k;
    return bits;
  }

  const Mesh& mesh_;
  std::vector<std::uint32_t> quad_, midpoint_, centre_;  // first of each face
  std::size_t quad_count_ = 0, midpoint_count_ = 0, centre_count_ = 0;
};

class Subdivision {
 public:
  Subdivision(const Mesh& coarse, const NodedLines& lines)
      : coarse_(coarse),
        lines_(lines),
        finder_(lines),
        number_(coarse),
        old_tags_(ConstraintTags::of(coarse)),
        tags_(ConstraintTags::add_to(fine_)) {
    if (!coarse.planar()) fine_.make_spatial();
    fine_.grow_vertices(number_.vertex_count());
    fine_.grow_faces(number_.quad_count());
  }

  // Coarse faces that have no valid subdivision, ascending; empty if all went well.
  std::vector<std::uint32_t> run() {
    parallel::for_each(coarse_.vertex_slots(), [&](std::size_t i) { copy_vertex(VertexId(i)); });
    for_each_coarse_face([&](FaceId f) { place_midpoints(f); });
    std::vector<std::uint8_t> failed(coarse_.face_slots(), 0);
    for_each_coarse_face([&](FaceId f) {
      make_quads(f);
      failed[f.value()] = place_centre(f) ? 0 : 1;
    });
    return parallel::filter_indices(failed.size(), [&](std::size_t i) { return failed[i] != 0; });
  }

  Mesh take() { return std::move(fine_); }
  [[nodiscard]] std::size_t quad_count() const { return number_.quad_count(); }

 private:
  template <class Visit>
  void for_each_coarse_face(Visit&& visit) {
    parallel::for_each(coarse_.face_slots(), [&](std::size_t i) {
      if (coarse_.alive(FaceId(i))) visit(FaceId(i));
    });
  }

  void copy_vertex(VertexId v) {
    copy_point(coarse_, v, fine_, v);
    tags_.support[v] = old_tags_.support[v];
    if (coarse_.alive(v)) fine_.set_side_of(v, number_.first_half(coarse_.side_of(v)));
  }

  // The midpoints that this face owns: place, support, and a side on the most clockwise face.
  void place_midpoints(FaceId f) {
    for (int k = 0; k < coarse_.corner_count(f); ++k) {
      const SideId s(f, k);
      if (!number_.owns(s)) continue;
      const VertexId m = number_.midpoint(s);
      fine_.set_side_of(m, number_.second_half(s));
      if (!coarse_.planar()) {
        fine_.set_point3(m, 0.5 * (coarse_.point3(coarse_.origin(s)) + coarse_.point3(coarse_.target(s))));
        tags_.support[m] = support_in_space(s);
        continue;
      }
      const Vec2 a = coarse_.point(coarse_.origin(s));
      const Vec2 b = coarse_.point(coarse_.target(s));
      const Support support = midpoint_support(s);
      Vec2 place = midpoint(a, b);
      if (support.slides()) {
        const Piece& piece = lines_.pieces[support.piece()];
        place = closest_point(place, lines_.nodes[piece.from], lines_.nodes[piece.to]);
      }
      fine_.set_point(m, place);
      tags_.support[m] = support;
    }
  }

  [[nodiscard]] Support midpoint_support(SideId s) const {
    if (!old_tags_.constrained(s)) return coarse_.neighbour(s).valid() ? Support::free() : Support::fixed();
    const PieceId piece =
        finder_.under_edge(old_tags_.support[coarse_.origin(s)], old_tags_.support[coarse_.target(s)]);
    if (!piece.valid()) {
      const Vec2 a = coarse_.point(coarse_.origin(s));
      throw Error(ErrorKind::kBug,
                  fmt::format("the constrained edge at {} lies on no piece", format_point(a.x, a.y)));
    }
    return Support::on(piece);
  }

  // Which curve joins two nodes only the caller can tell: fixed.
  [[nodiscard]] Support support_in_space(SideId s) const {
    if (!old_tags_.constrained(s)) return coarse_.neighbour(s).valid() ? Support::free() : Support::fixed();
    for (const VertexId v : {coarse_.origin(s), coarse_.target(s)})
      if (old_tags_.support[v].slides()) return old_tags_.support[v];
    return Support::fixed();
  }

  void make_quads(FaceId f) {
    const VertexId c = number_.centre(f);
    fine_.set_side_of(c, SideId(number_.quad(SideId(f, 0)), 2));
    for (int k = 0; k < coarse_.corner_count(f); ++k) {
      const SideId s(f, k);
      const SideId before = coarse_.previous(s);
      const FaceId quad = number_.quad(s);
      fine_.set_corner({quad, 0}, coarse_.origin(s));
      fine_.set_corner({quad, 1}, number_.midpoint(s));
      fine_.set_corner({quad, 2}, c);
      fine_.set_corner({quad, 3}, number_.midpoint(before));
      const SideId across = coarse_.neighbour(s);
      const SideId across_before = coarse_.neighbour(before);
      fine_.set_neighbour({quad, 0}, across.valid() ? number_.second_half(across) : SideId());
      fine_.set_neighbour({quad, 1}, {number_.quad(coarse_.next(s)), 2});
      fine_.set_neighbour({quad, 2}, {number_.quad(before), 1});
      fine_.set_neighbour({quad, 3}, across_before.valid() ? number_.first_half(across_before) : SideId());
      tags_.set_constrained({quad, 0}, old_tags_.constrained(s));
      tags_.set_constrained({quad, 3}, old_tags_.constrained(before));
    }
  }

  bool place_centre(FaceId f) {
    if (!coarse_.planar()) {
      place_in_the_middle(f);
      return true;
    }
    CentreProblem problem;
    for (int k = 0; k < coarse_.corner_count(f); ++k) {
      problem.corners.push_back(coarse_.point(coarse_.corner(f, k)));
      problem.midpoints.push_back(fine_.point(number_.midpoint(SideId(f, k))));
    }
    const std::optional<Vec2> centre = best_centre(problem);
    if (centre) fine_.set_point(number_.centre(f), *centre);
    return centre.has_value();
  }

  void place_in_the_middle(FaceId f) {
    const int count = coarse_.corner_count(f);
    Vec3 sum;
    for (int k = 0; k < count; ++k) sum = sum + coarse_.point3(coarse_.corner(f, k));
    fine_.set_point3(number_.centre(f), (1.0 / count) * sum);
  }

  const Mesh& coarse_;
  const NodedLines& lines_;
  PieceFinder finder_;
  FineNumbers number_;
  ConstraintTags old_tags_;
  Mesh fine_;
  ConstraintTags tags_;
};

[[noreturn]] void throw_too_flat(const Mesh& mesh, FaceId f) {
  const Vec2 a = mesh.point(mesh.corner(f, 0));
  throw Error(
      ErrorKind::kGeometry,
      fmt::format("the triangle at {} is too flat to be cut into valid quads; clean the lines there with a "
                  "larger --snap or --min-edge, or mesh with a larger --size",
                  format_point(a.x, a.y)));
}

std::uint64_t count_triangles(const Mesh& mesh) {
  return parallel::reduce_ordered(
      mesh.face_slots(), std::uint64_t{0},
      [&](std::size_t begin, std::size_t end) {
        std::uint64_t sum = 0;
        for (std::size_t i = begin; i < end; ++i)
          sum += mesh.alive(FaceId(i)) && mesh.corner_count(FaceId(i)) == 3 ? 1 : 0;
        return sum;
      },
      [](std::uint64_t a, std::uint64_t b) { return a + b; });
}

}  // namespace

Mesh subdivide_in_space(Mesh&& coarse, SubdivideReport& report) {
  const Mesh input = std::move(coarse);
  const NodedLines none;
  Subdivision subdivision(input, none);
  static_cast<void>(subdivision.run());  // no face fails in space
  report.quads = subdivision.quad_count();
  report.from_triangles = count_triangles(input);
  return subdivision.take();
}

Mesh subdivide(Mesh&& input, const NodedLines& lines, SubdivideReport& report, const Progress& progress) {
  Mesh coarse = std::move(input);
  // A second attempt finds the failed quads cut into triangles, so that the third at the latest succeeds or
  // throws.
  for (;;) {
    progress.throw_if_cancelled();
    Subdivision subdivision(coarse, lines);
    const std::vector<std::uint32_t> failed = subdivision.run();
    if (failed.empty()) {
      report.quads = subdivision.quad_count();
      report.from_triangles = count_triangles(coarse);
      return subdivision.take();
    }
    for (const std::uint32_t i : failed) {
      const FaceId f(i);
      const QuadCut cut = coarse.corner_count(f) == 4 ? best_cut(coarse, f) : QuadCut();
      if (!cut.valid()) throw_too_flat(coarse, f);
      cut_quad(coarse, f, cut.from);
      ++report.undone_merges;
    }
  }
}

}  // namespace quarry
