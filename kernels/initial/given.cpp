#include "kernels/initial/given.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "engine/geometry/grid.hpp"
#include "engine/geometry/predicates.hpp"
#include "engine/geometry/segment.hpp"
#include "engine/mesh/build.hpp"
#include "engine/mesh/compact.hpp"
#include "engine/mesh/validate.hpp"

namespace quarry {
namespace {

[[noreturn]] void refuse(Vec2 place, const char* what) {
  throw Error(ErrorKind::kInput,
              fmt::format("the start mesh {} at {}", what, format_point(place.x, place.y)));
}

void check_flat(const Mesh& mesh) {
  if (mesh.planar()) return;
  double height = 0;
  bool first = true;
  for (const VertexId v : mesh.vertices()) {
    if (!mesh.alive(v)) continue;
    const double z = mesh.point3(v).z;
    if (first) height = z;
    first = false;
    if (z != height) refuse(mesh.point(v), "is not flat: its points must have one z; see the point");
  }
}

// 1 if all triangles turn left, -1 if all turn right.
int common_orientation(const Mesh& mesh) {
  int common = 0;
  for (const FaceId f : mesh.faces()) {
    if (!mesh.alive(f)) continue;
    const Vec2 a = mesh.point(mesh.corner(f, 0));
    if (mesh.corner_count(f) != 3) refuse(a, "must have triangles only; it has a quad");
    const double turn = orient2d(a, mesh.point(mesh.corner(f, 1)), mesh.point(mesh.corner(f, 2)));
    const int orientation = turn > 0 ? 1 : turn < 0 ? -1 : 0;
    if (orientation == 0) refuse(a, "has a triangle of no area");
    if (common == 0) common = orientation;
    if (orientation != common) refuse(a, "folds over: a triangle is turned the other way");
  }
  if (common == 0) throw Error(ErrorKind::kInput, "the start mesh has no triangle");
  return common;
}

Mesh copy_triangles(const Mesh& given, int orientation) {
  std::vector<FaceCorners> faces;
  faces.reserve(given.face_slots());
  for (const FaceId f : given.faces()) {
    if (!given.alive(f)) continue;
    faces.push_back({given.corner(f, 0), given.corner(f, 1), given.corner(f, 2), VertexId()});
    if (orientation < 0) std::swap(faces.back()[1], faces.back()[2]);
  }
  Mesh mesh = build_mesh(given.xs(), given.ys(), faces);
  compact(mesh, EntityOrder::kHilbert);
  return mesh;
}

void check_connected(const Mesh& mesh) {
  std::vector<bool> reached(mesh.face_slots(), false);
  std::vector<FaceId> todo{FaceId(0U)};
  reached[0] = true;
  while (!todo.empty()) {
    const FaceId f = todo.back();
    todo.pop_back();
    for (int k = 0; k < 3; ++k) {
      const SideId across = mesh.neighbour(SideId(f, k));
      if (!across.valid() || reached[across.face().value()]) continue;
      reached[across.face().value()] = true;
      todo.push_back(across.face());
    }
  }
  const auto missed = std::find(reached.begin(), reached.end(), false);
  if (missed == reached.end()) return;
  const FaceId apart(static_cast<std::size_t>(missed - reached.begin()));
  refuse(mesh.point(mesh.corner(apart, 0)), "lies in several parts: join them; one begins");
}

struct Rim {
  std::vector<SideId> sides;  // counter-clockwise
  std::vector<Segment> segments;
};

Rim find_rim(const Mesh& mesh) {
  std::size_t count = 0;
  SideId first;
  for (const FaceId f : mesh.faces()) {
    for (int k = 0; k < 3; ++k) {
      if (mesh.neighbour(SideId(f, k)).valid()) continue;
      if (!first.valid()) first = SideId(f, k);
      ++count;
    }
  }
  // The rim goes on along the side of the vertex, which is the most clockwise one, on the boundary.
  Rim rim;
  SideId s = first;
  do {
    rim.sides.push_back(s);
    rim.segments.push_back({mesh.point(mesh.origin(s)), mesh.point(mesh.target(s))});
    s = mesh.side_of(mesh.target(s));
  } while (s != first && rim.sides.size() <= count);
  if (rim.sides.size() != count)
    refuse(rim.segments.front().from, "has a hole: its rim is not one loop; it passes");
  return rim;
}

double mean_length(const std::vector<Segment>& segments) {
  double sum = 0;
  for (const Segment& segment : segments) sum += distance(segment.from, segment.to);
  return sum / static_cast<double>(segments.size());
}

Box2 box_of(Vec2 a, Vec2 b) {
  Box2 box;
  box.extend(a);
  box.extend(b);
  return box;
}

// Triangles of one orientation cover a place as often as their rim winds around it: where the rim is a simple
// loop, once, so that no two overlap.
void check_rim_is_simple(const Rim& rim) {
  const SegmentGrid grid(rim.segments, mean_length(rim.segments));
  std::vector<std::uint32_t> ids;
  const std::size_t count = rim.segments.size();
  for (std::size_t i = 0; i < count; ++i) {
    const auto [a, b] = rim.segments[i];
    grid.find(box_of(a, b), ids);
    for (const std::size_t j : ids) {
      if (j <= i) continue;
      const auto [c, d] = rim.segments[j];
      const bool neighbours = j == i + 1 || (i == 0 && j + 1 == count);
      const Meeting met = meeting(a, b, c, d);
      if (met != Meeting::kApart && !(neighbours && met == Meeting::kTouch))
        refuse(a, "overlaps or touches itself");
    }
  }
}

}  // namespace

Mesh adopt_start_mesh(const Mesh& given) {
  check_flat(given);
  Mesh mesh = copy_triangles(given, common_orientation(given));
  if (const std::string failure = validate(mesh, GeometryCheck::kPlanarCorners); !failure.empty())
    throw Error(ErrorKind::kInput, "the start mesh is not valid: " + failure);
  check_connected(mesh);
  check_rim_is_simple(find_rim(mesh));
  return mesh;
}

void require_lines_inside(const Mesh& mesh, const NodedLines& lines) {
  const Rim rim = find_rim(mesh);
  const SegmentGrid grid(rim.segments, mean_length(rim.segments));
  std::vector<std::uint32_t> ids;
  for (const Piece& piece : lines.pieces) {
    const Vec2 a = lines.nodes[piece.from];
    const Vec2 b = lines.nodes[piece.to];
    grid.find(box_of(a, b), ids);
    for (const std::uint32_t id : ids)
      if (meeting(a, b, rim.segments[id].from, rim.segments[id].to) != Meeting::kApart)
        refuse(a, "must reach beyond the lines and the outline on all sides; it ends near the piece");
  }
}

Mesh make_four_triangles(const Box2& box) {
  const Box2 grown = box.grown(0.1 * box.longer_side());
  const Vec2 center = grown.center();
  const VertexId a(0U), b(1U), c(2U), d(3U), m(4U);
  const std::vector<FaceCorners> faces{
      {a, b, m, VertexId()}, {b, c, m, VertexId()}, {c, d, m, VertexId()}, {d, a, m, VertexId()}};
  return build_mesh({grown.low.x, grown.high.x, grown.high.x, grown.low.x, center.x},
                    {grown.low.y, grown.low.y, grown.high.y, grown.high.y, center.y}, faces);
}

}  // namespace quarry
