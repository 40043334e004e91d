#include "kernels/matching/ears.hpp"

#include <algorithm>
#include <type_traits>

#include "engine/operation/editor.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/local/split.hpp"
#include "kernels/matching/quad_shape.hpp"

namespace quarry {
namespace {

// The only arc of a triangle, or none if it has another number of arcs.
SideId only_arc(const Mesh& mesh, ConstraintTags tags, FaceId f) {
  SideId only;
  for (int k = 0; k < 3; ++k) {
    const SideId s(f, k);
    if (!matching::joinable(mesh, tags, s)) continue;
    if (only.valid()) return {};
    only = s;
  }
  return only;
}

template <class Point>
struct Cut {
  SideId side;
  Point point;
};

template <class Point>
class EarOpener {
 public:
  EarOpener(const Mesh& mesh, ConstraintTags tags, const EarOptions& options)
      : mesh_(mesh), tags_(tags), options_(options) {}

  // s: the only arc of a triangle. The corner of the forced quad that is too straight: s or its neighbour, by
  // its origin; none if the quad is good enough.
  [[nodiscard]] SideId straight_corner(SideId s) const {
    for (const SideId at : {s, mesh_.neighbour(s)}) {
      const Point here = point(mesh_.origin(at));
      // Counter-clockwise around the origin: from the apex across the edge to the apex of the face of `at`.
      const Point next = point(matching::apex(mesh_, mesh_.neighbour(at)));
      const Point previous = point(matching::apex(mesh_, at));
      const matching::CornerSines<Point> sine(here, next, point(mesh_.target(at)), previous);
      if (dot(next - here, previous - here) < 0 && sine(previous, here, next) < options_.smallest_sine)
        return at;
    }
    return {};
  }

  // Where to split behind the neighbour across s so that the forced quad becomes best; no side if nothing is
  // valid.
  [[nodiscard]] Cut<Point> best_cut(SideId s, SideId corner) const {
    // In the neighbour (origin of t, target of t, apex): the edge that does not touch the straight corner.
    const SideId t = mesh_.neighbour(s);
    const SideId side = corner == t ? mesh_.next(t) : mesh_.previous(t);
    if (!matching::joinable(mesh_, tags_, side)) return {};
    const Point a = point(mesh_.origin(side));
    const Point b = point(mesh_.target(side));
    const Point p = point(mesh_.origin(s));
    const Point q = point(mesh_.target(s));
    const Point tip = point(matching::apex(mesh_, s));
    Cut<Point> best;
    double most = 0;
    for (const double share : {0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8}) {
      const Point x = a + share * (b - a);
      if (!can_split(side, x)) continue;
      const matching::CornerSines<Point> sine(tip, p, x, q);
      const double corners = std::min(sine(tip, p, x), sine(x, q, tip));
      const double worth = std::min(corners, worst_of_edge_split(mesh_, side, x));
      if (worth > most) {
        most = worth;
        best = {side, x};
      }
    }
    return best;
  }

 private:
  [[nodiscard]] Point point(VertexId v) const { return point_of<Point>(mesh_, v); }

  // In space a part is flat at most, which its measure tells.
  [[nodiscard]] bool can_split(SideId side, Point x) const {
    if constexpr (std::is_same_v<Point, Vec2>)
      return can_split_edge(mesh_, side, x);
    else
      return true;
  }

  const Mesh& mesh_;
  ConstraintTags tags_;
  EarOptions options_;
};

template <class Point>
void open_ears(Mesh& mesh, ConstraintTags tags, const EarOptions& options, EarReport& report) {
  const EarOpener<Point> opener(mesh, tags, options);
  const auto ears = parallel::filter_indices(mesh.face_slots(), [&](std::size_t i) {
    return mesh.alive(FaceId(i)) && only_arc(mesh, tags, FaceId(i)).valid();
  });
  report.forced += ears.size();
  // One after the other: they are few, and one may touch the neighbour of the next. A split renumbers only
  // faces beyond an arc, so that an ear keeps its number unless it was split itself.
  for (const std::uint32_t i : ears) {
    const SideId s = only_arc(mesh, tags, FaceId(i));
    if (!s.valid()) continue;
    const SideId corner = opener.straight_corner(s);
    if (!corner.valid()) continue;
    ++report.bad;
    const Cut<Point> cut = opener.best_cut(s, corner);
    if (!cut.side.valid()) continue;
    MeshEditor editor(mesh);
    (void)split_edge(editor, tags, cut.side, cut.point, Support::free(),
                     {mesh.grow_vertices(1), mesh.grow_faces(2)});
    ++report.opened;
  }
}

}  // namespace

void open_forced_ears(Mesh& mesh, ConstraintTags tags, const EarOptions& options, EarReport& report) {
  matching::with_points_of(mesh, [&]<class Point>(Point) { open_ears<Point>(mesh, tags, options, report); });
}

}  // namespace quarry
