#include "surface/quads/unfold_faces.hpp"

#include <cstdint>

#include "engine/geometry/model.hpp"
#include "engine/parallel/parallel.hpp"
#include "surface/quads/face_verdict.hpp"
#include "surface/quads/mend_faces.hpp"
#include "surface/quads/normal_around.hpp"
#include "surface/quads/place_on_surface.hpp"

namespace quarry {
namespace {

// Nothing holds a vertex but the plane that it lies in: there is no surface yet.
class FreeSpace final : public SpaceModel {
 public:
  [[nodiscard]] SpacePoint project(const SpacePoint& p) const override { return {p.place, normal(p)}; }
};

}  // namespace

std::vector<FaceId> find_folded_faces(Mesh& mesh) {
  auto normals = mesh.add_normals();
  parallel::for_each(mesh.vertex_slots(), [&](std::size_t i) {
    if (mesh.alive(VertexId(i))) normals[VertexId(i)] = normal_around(mesh, VertexId(i));
  });
  std::vector<FaceId> folded;
  for (const std::uint32_t f : parallel::filter_indices(mesh.face_slots(), [&](std::size_t i) {
         return mesh.alive(FaceId(i)) && !(face_verdict(mesh, normals, FaceId(i)) > kNotConvex);
       }))
    folded.emplace_back(f);
  return folded;
}

void unfold_faces(Mesh& mesh, const ConstraintTags& tags, const Progress& progress) {
  clear_feature_normals(mesh, tags);
  mend_faces(mesh, tags, FreeSpace(), progress);
  mesh.remove_normals();
}

}  // namespace quarry
