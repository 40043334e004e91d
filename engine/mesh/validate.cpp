#include "engine/mesh/validate.hpp"

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "engine/geometry/predicates.hpp"
#include "engine/parallel/parallel.hpp"

namespace quarry {
namespace {

std::string at(const Mesh& mesh, VertexId v) {
  const Vec2 p = mesh.point(v);
  return fmt::format("vertex {} {}", v.value(), format_point(p.x, p.y));
}

std::string check_corners(const Mesh& mesh, FaceId f) {
  const int count = mesh.corner_count(f);
  for (int i = 0; i < count; ++i) {
    const VertexId v = mesh.corner(f, i);
    if (!v.valid() || v.value() >= mesh.vertex_slots())
      return fmt::format("face {}: corner {} is no vertex", f.value(), i);
    if (!mesh.alive(v)) return fmt::format("face {}: corner {} is deleted {}", f.value(), i, at(mesh, v));
    for (int j = 0; j < i; ++j)
      if (mesh.corner(f, j) == v)
        return fmt::format("face {}: corners {} and {} are the same {}", f.value(), j, i, at(mesh, v));
  }
  return {};
}

std::string check_neighbours(const Mesh& mesh, FaceId f) {
  for (int i = 0; i < mesh.corner_count(f); ++i) {
    const SideId s(f, i);
    const SideId t = mesh.neighbour(s);
    if (!t.valid()) continue;
    if (t.face().value() >= mesh.face_slots() || !mesh.alive(t.face()) ||
        t.index() >= mesh.corner_count(t.face()))
      return fmt::format("neighbour of side {}.{} is no side of a face", f.value(), i);
    if (mesh.neighbour(t) != s)
      return fmt::format("neighbour of side {}.{} is {}.{}, whose neighbour is another side", f.value(), i,
                         t.face().value(), t.index());
    if (mesh.origin(s) != mesh.target(t) || mesh.origin(t) != mesh.target(s))
      return fmt::format("neighbours {}.{} and {}.{} do not join the same two vertices", f.value(), i,
                         t.face().value(), t.index());
  }
  return {};
}

// corners: how many corners of faces lie at the vertex.
std::string check_star(const Mesh& mesh, VertexId v, std::uint32_t corners) {
  const SideId first = mesh.side_of(v);
  if (!first.valid() || first.face().value() >= mesh.face_slots() || !mesh.alive(first.face()) ||
      mesh.origin(first) != v)
    return fmt::format("side_of({}) does not start there", at(mesh, v));
  std::uint32_t seen = 0;
  for (SideId s = first; s.valid();) {
    if (++seen > corners) return fmt::format("the turn around {} does not close", at(mesh, v));
    s = mesh.turn_left(s);
    if (s == first) break;
  }
  if (seen != corners)
    return fmt::format(
        "one turn around {} meets {} of its {} corners: two fans, or side_of is not the most clockwise",
        at(mesh, v), seen, corners);
  return {};
}

template <class Check>
std::string first_failure(std::size_t size, Check&& check) {
  return parallel::reduce_ordered(
      size, std::string(),
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
          if (std::string failure = check(i); !failure.empty()) return failure;
        return std::string();
      },
      [](std::string first, std::string second) { return first.empty() ? second : first; });
}

}  // namespace

bool all_corners_turn_left(const Mesh& mesh, FaceId f) {
  const int count = mesh.corner_count(f);
  if (count == 3)
    return orient2d(mesh.point(mesh.corner(f, 0)), mesh.point(mesh.corner(f, 1)),
                    mesh.point(mesh.corner(f, 2))) > 0;
  for (int i = 0; i < 4; ++i)
    if (!(orient2d(mesh.point(mesh.corner(f, (i + 3) & 3)), mesh.point(mesh.corner(f, i)),
                   mesh.point(mesh.corner(f, (i + 1) & 3))) > 0))
      return false;
  return true;
}

std::string validate(const Mesh& mesh, GeometryCheck geometry) {
  std::string failure = first_failure(mesh.face_slots(), [&](std::size_t i) {
    const FaceId f(i);
    if (!mesh.alive(f)) return std::string();
    std::string found = check_corners(mesh, f);
    if (found.empty()) found = check_neighbours(mesh, f);
    if (found.empty() && geometry == GeometryCheck::kPlanarCorners && !all_corners_turn_left(mesh, f))
      found =
          fmt::format("face {} at {} has a corner that does not turn left", i, at(mesh, mesh.corner(f, 0)));
    return found;
  });
  if (!failure.empty()) return failure;

  std::vector<std::uint32_t> corners(mesh.vertex_slots(), 0);
  for (const FaceId f : mesh.faces())
    if (mesh.alive(f))
      for (int i = 0; i < mesh.corner_count(f); ++i) ++corners[mesh.corner(f, i).value()];
  failure = first_failure(mesh.vertex_slots(), [&](std::size_t i) {
    const VertexId v(i);
    if (!mesh.alive(v))
      return corners[i] == 0 ? std::string() : fmt::format("deleted {} is a corner", at(mesh, v));
    return check_star(mesh, v, corners[i]);
  });
  if (!failure.empty()) return failure;
  return first_failure(mesh.edge_slots(), [&](std::size_t i) {
    const auto [a, b] = mesh.edge_ends(EdgeId(i));
    if (!mesh.alive(a) || !mesh.alive(b)) return fmt::format("edge {} has a deleted end", i);
    return std::string();
  });
}

}  // namespace quarry
