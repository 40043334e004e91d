#include "surface/quads/place_on_surface.hpp"

#include <vector>

#include "engine/parallel/parallel.hpp"

namespace quarry {
namespace {

// Twice the area of a face, along its normal.
Vec3 area_vector(const Mesh& mesh, FaceId f) {
  const Vec3 a = mesh.point3(mesh.corner(f, 0));
  const Vec3 b = mesh.point3(mesh.corner(f, 1));
  const Vec3 c = mesh.point3(mesh.corner(f, 2));
  return mesh.corner_count(f) == 3 ? cross(b - a, c - a) : cross(c - a, mesh.point3(mesh.corner(f, 3)) - b);
}

Vec3 normal_around(const Mesh& mesh, VertexId v) {
  Vec3 sum;
  for_each_side_around(mesh, v, [&](SideId s) { sum = sum + area_vector(mesh, s.face()); });
  const double size = length(sum);
  return size > 0 ? (1 / size) * sum : Vec3{0, 0, 1};
}

// What subdivide_in_space left fixed in the middle of a feature between two nodes slides on that feature.
Support support_on_feature(const Mesh& mesh, const ConstraintTags& tags, const CurveNetwork& network,
                           VertexId v) {
  const Support support = tags.support[v];
  if (!support.is_fixed() || support.is_node()) return support;
  std::vector<Support> ends;
  for_each_constrained_neighbour(mesh, tags, v, [&](VertexId w) { ends.push_back(tags.support[w]); });
  if (ends.size() != 2 || !ends[0].is_node() || !ends[1].is_node()) return support;
  const PieceId curve = network.under_edge(ends[0], ends[1], mesh.point3(v));
  return curve.valid() ? Support::on(curve) : support;
}

}  // namespace

void place_on_surface(Mesh& mesh, ConstraintTags tags, const SurfaceModel& model,
                      const CurveNetwork& network) {
  // Read all before any is written: supports and places of neighbours are looked at.
  std::vector<Support> supports(mesh.vertex_slots());
  std::vector<SpacePoint> places(mesh.vertex_slots());
  parallel::for_each(mesh.vertex_slots(), [&](std::size_t i) {
    const VertexId v(i);
    if (!mesh.alive(v)) return;
    supports[i] = support_on_feature(mesh, tags, network, v);
    places[i] = {mesh.point3(v), Vec3()};
    if (supports[i].is_free())
      places[i] = model.project({places[i].place, normal_around(mesh, v)});
    else if (supports[i].slides())
      places[i].place = network.project(supports[i].piece(), places[i].place);
  });
  auto normals = mesh.add_normals();
  parallel::for_each(mesh.vertex_slots(), [&](std::size_t i) {
    const VertexId v(i);
    if (!mesh.alive(v)) return;
    tags.support[v] = supports[i];
    mesh.set_point3(v, places[i].place);
    normals[v] = places[i].up;
  });
}

void set_feature_normals(Mesh& cut_open, const ConstraintTags& tags) {
  auto normals = cut_open.normals();
  parallel::for_each(cut_open.vertex_slots(), [&](std::size_t i) {
    const VertexId v(i);
    if (cut_open.alive(v) && !tags.support[v].is_free()) normals[v] = normal_around(cut_open, v);
  });
}

}  // namespace quarry
