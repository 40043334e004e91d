#include "surface/quads/place_on_surface.hpp"

#include <utility>
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

// The ends of the constrained edges at a vertex.
std::vector<VertexId> constrained_neighbours(const Mesh& mesh, const ConstraintTags& tags, VertexId v) {
  std::vector<VertexId> ends;
  for_each_side_around(mesh, v, [&](SideId s) {
    if (tags.constrained(s)) ends.push_back(mesh.target(s));
    const SideId in = mesh.previous(s);
    if (!mesh.neighbour(in).valid()) ends.push_back(mesh.origin(in));
  });
  return ends;
}

}  // namespace

void place_on_surface(Mesh& mesh, const ConstraintTags& given, const SurfaceModel& model,
                      const CurveNetwork& network) {
  ConstraintTags tags = given;
  auto normals = mesh.add_normals();
  parallel::for_each(mesh.vertex_slots(), [&](std::size_t i) {
    const VertexId v(i);
    if (!mesh.alive(v)) return;
    if (tags.support[v].is_free() || tags.support[v].slides() || tags.support[v].is_node()) return;
    const std::vector<VertexId> ends = constrained_neighbours(mesh, tags, v);
    if (ends.size() != 2 || !given.support[ends[0]].is_node() || !given.support[ends[1]].is_node()) return;
    const PieceId curve = network.under_edge(given.support[ends[0]], given.support[ends[1]], mesh.point3(v));
    if (curve.valid()) tags.support[v] = Support::on(curve);
  });
  std::vector<SpacePoint> places(mesh.vertex_slots());
  parallel::for_each(mesh.vertex_slots(), [&](std::size_t i) {
    const VertexId v(i);
    if (!mesh.alive(v)) return;
    places[i] = {mesh.point3(v), Vec3()};
    if (tags.support[v].is_free())
      places[i] = model.project({places[i].place, normal_around(mesh, v)});
    else if (tags.support[v].slides())
      places[i].place = network.project(tags.support[v].piece(), places[i].place);
  });
  parallel::for_each(mesh.vertex_slots(), [&](std::size_t i) {
    const VertexId v(i);
    if (!mesh.alive(v)) return;
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
