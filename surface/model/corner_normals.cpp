#include "surface/model/corner_normals.hpp"

#include <cmath>

#include "engine/parallel/parallel.hpp"

namespace quarry {
namespace {

// The normal of the face times its angle at the origin of s.
Vec3 weighted_normal(const Mesh& mesh, SideId s) {
  const Vec3 here = mesh.point3(mesh.origin(s));
  const Vec3 out = mesh.point3(mesh.target(s)) - here;
  const Vec3 back = mesh.point3(mesh.origin(mesh.previous(s))) - here;
  const Vec3 n = cross(out, back);
  const double size = length(n);
  if (!(size > 0)) return {};
  return (std::atan2(size, dot(out, back)) / size) * n;
}

Vec3 unit(Vec3 n) {
  const double size = length(n);
  return size > 0 ? (1 / size) * n : Vec3{0, 0, 1};
}

}  // namespace

std::vector<CornerNormals> corner_normals(const Mesh& triangles, const ConstraintTags& tags) {
  std::vector<CornerNormals> normals(triangles.face_slots());
  parallel::for_each(triangles.vertex_slots(), [&](std::size_t i) {
    const VertexId v(i);
    if (!triangles.alive(v)) return;
    // Inside: begins at a constrained side, if there is one. The first side at a rim is one.
    SideId first = triangles.side_of(v);
    bool on_curve = triangles.on_boundary(v);
    if (!on_curve)
      for_each_side_around(triangles, v, [&](SideId s) {
        if (!tags.constrained(s)) return;
        first = s;
        on_curve = true;
      });
    const bool tip = !on_curve && !tags.support[v].is_free();
    std::vector<SideId> fan;
    Vec3 sum;
    const auto close = [&] {
      if (fan.empty()) return;
      const Vec3 normal = unit(sum);
      for (const SideId s : fan) normals[s.face().value()][static_cast<std::size_t>(s.index())] = normal;
      fan.clear();
      sum = {};
    };
    for (SideId s = first; s.valid();) {
      if (tip || tags.constrained(s)) close();
      fan.push_back(s);
      sum = sum + weighted_normal(triangles, s);
      s = triangles.turn_left(s);
      if (s == first) break;
    }
    close();
  });
  return normals;
}

}  // namespace quarry
