#include "kernels/cleanup/ideal.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "engine/parallel/parallel.hpp"
#include "kernels/cleanup/model_face.hpp"

namespace quarry {
namespace {

constexpr double kRightAngle = std::numbers::pi / 2;
constexpr double kMostFaces = 255;

// The last vertex of a counter-clockwise turn around a boundary vertex.
VertexId last_neighbour(const Mesh& mesh, VertexId v) {
  SideId s = mesh.side_of(v);
  while (true) {
    const SideId last = mesh.previous(s);
    if (!mesh.neighbour(last).valid()) return mesh.origin(last);
    s = mesh.neighbour(last);
  }
}

}  // namespace

template <GeometryModel Model>
double sector_angle(const Mesh& mesh, const Model& model, VertexId v) {
  using Point = typename Model::Point;
  const VertexId first = mesh.target(mesh.side_of(v));
  const VertexId last = last_neighbour(mesh, v);
  if (first == last) return 2 * std::numbers::pi;
  const Point here = point_of<Point>(mesh, v);
  const Point a = point_of<Point>(mesh, first);
  const Point b = point_of<Point>(mesh, last);
  const Point out = a - here;
  const Point back = b - here;
  const double side = model.orientation(here, a, b);
  const double angle = std::atan2(size_of(cross(out, back)), dot(out, back));
  if (side > 0) return angle;
  if (side < 0) return 2 * std::numbers::pi - angle;
  return dot(out, back) > 0 ? 2 * std::numbers::pi : std::numbers::pi;
}

template <GeometryModel Model>
Tag<VertexId, std::uint8_t> set_ideal_faces(Mesh& mesh, const Model& model) {
  auto ideal = mesh.find_tag<VertexId, std::uint8_t>(kIdealTag);
  if (!ideal.valid()) ideal = mesh.add_tag<VertexId, std::uint8_t>(kIdealTag, 4);
  parallel::for_each(mesh.vertex_slots(), [&, ideal](std::size_t i) mutable {
    const VertexId v(i);
    ideal[v] = 4;
    if (!mesh.alive(v) || !mesh.on_boundary(v)) return;
    const double faces = std::round(sector_angle(mesh, model, v) / kRightAngle);
    ideal[v] = static_cast<std::uint8_t>(std::clamp(faces, 1.0, kMostFaces));
  });
  return ideal;
}

template double sector_angle(const Mesh&, const PlaneModel&, VertexId);
template double sector_angle(const Mesh&, const SpaceModel&, VertexId);
template Tag<VertexId, std::uint8_t> set_ideal_faces(Mesh&, const PlaneModel&);
template Tag<VertexId, std::uint8_t> set_ideal_faces(Mesh&, const SpaceModel&);

}  // namespace quarry
