#include "surface/model/far_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "surface/project/triangle_tree.hpp"

namespace quarry {
// Quads are two triangles for this: how they are cut matters little.
std::vector<NearestFace> find_nearest_faces(const Mesh& mesh, const SurfaceModel& model,
                                            std::span<const std::uint32_t> points) {
  std::vector<Vec3> corners;
  for (const VertexId v : mesh.vertices()) corners.push_back(mesh.point3(v));
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<FaceId> faces;
  for (const FaceId f : mesh.faces())
    for (int k = 1; mesh.alive(f) && k + 1 < mesh.corner_count(f); ++k) {
      triangles.push_back(
          {mesh.corner(f, 0).value(), mesh.corner(f, k).value(), mesh.corner(f, k + 1).value()});
      faces.push_back(f);
    }
  const TriangleTree tree(corners, triangles);
  std::vector<Vec3> places, normals;
  for (const std::uint32_t i : points) {
    places.push_back(model.free_points()[i].place);
    normals.push_back(model.free_points()[i].up);
  }
  ClosestQuery query;
  query.least_cosine = kSameSide;
  std::vector<NearestFace> nearest(points.size());
  const std::vector<SurfacePoint> found = tree.closest_all(places, query, normals);
  for (std::size_t i = 0; i < found.size(); ++i)
    if (found[i].triangle.valid())
      nearest[i] = {faces[found[i].triangle.value()], std::sqrt(found[i].squared_distance)};
  return nearest;
}

double edge_of_square(const Mesh& mesh, FaceId f) {
  const auto corner = [&](int k) { return mesh.point3(mesh.corner(f, k)); };
  const int last = mesh.corner_count(f) - 1;
  return std::sqrt(0.5 * length(cross(corner(2) - corner(0), corner(last) - corner(1))));
}

std::vector<Vec3> find_lost_places(const Mesh& mesh, const SurfaceModel& model, double far, double apart) {
  std::vector<std::uint32_t> points(model.free_points().size());
  std::iota(points.begin(), points.end(), 0U);
  const std::vector<NearestFace> nearest = find_nearest_faces(mesh, model, points);
  std::erase_if(points, [&](std::uint32_t i) {
    const NearestFace& near = nearest[i];
    return !near.face.valid() || near.distance <= far * edge_of_square(mesh, near.face);
  });
  std::stable_sort(points.begin(), points.end(), [&](std::uint32_t a, std::uint32_t b) {
    return nearest[a].distance > nearest[b].distance;
  });
  std::vector<Vec3> lost;
  for (const std::uint32_t i : points) {
    const Vec3 place = model.free_points()[i].place;
    if (std::none_of(lost.begin(), lost.end(), [&](Vec3 other) { return length(place - other) < apart; }))
      lost.push_back(place);
  }
  return lost;
}

}  // namespace quarry
