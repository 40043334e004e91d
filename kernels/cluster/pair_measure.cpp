#include "kernels/cluster/pair_measure.hpp"

#include <algorithm>
#include <cmath>

namespace quarry {
namespace {

double signed_square_of_sine(Vec2 previous, Vec2 here, Vec2 next) {
  const Vec2 out = next - here;
  const Vec2 back = previous - here;
  const double area = cross(out, back);
  const double lengths = squared_length(out) * squared_length(back);
  return lengths > 0 ? area * std::abs(area) / lengths : -1.0;
}

double squared_length_of(const Mesh& mesh, SideId s) {
  const Vec3 edge = mesh.point3(mesh.target(s)) - mesh.point3(mesh.origin(s));
  return dot(edge, edge);
}

}  // namespace

std::array<VertexId, 4> merged_corners(const Mesh& mesh, SideId s) {
  const SideId t = mesh.neighbour(s);
  return {mesh.target(s), mesh.origin(mesh.previous(s)), mesh.origin(s), mesh.origin(mesh.previous(t))};
}

double worst_corner_signed_square(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  return std::min(std::min(signed_square_of_sine(d, a, b), signed_square_of_sine(a, b, c)),
                  std::min(signed_square_of_sine(b, c, d), signed_square_of_sine(c, d, a)));
}

bool longest_of_its_face(const Mesh& mesh, SideId s) {
  const double mine = squared_length_of(mesh, s);
  return mine >= squared_length_of(mesh, mesh.next(s)) && mine >= squared_length_of(mesh, mesh.previous(s));
}

}  // namespace quarry
