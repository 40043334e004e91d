#include "surface/quads/reach_far_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/parallel/parallel.hpp"
#include "kernels/smooth/local_smoother.hpp"
#include "surface/project/triangle_tree.hpp"
#include "surface/quads/face_verdict.hpp"

namespace quarry {
namespace {

// The cosine of the turn of the mesh from the surface up to which it counts as near it.
constexpr double kSameSide = 0.17;

class FarPoints {
 public:
  FarPoints(Mesh& mesh, const ConstraintTags& tags, const SurfaceModel& model, const ReachOptions& options)
      : mesh_(mesh),
        tags_(tags),
        model_(model),
        options_(options),
        smoother_(model),
        normals_(mesh.normals()) {}

  std::size_t run_round() {
    find_far();
    held_.assign(mesh_.vertex_slots(), 0);
    std::vector<VertexId> moved;
    for (const Far& far : far_)
      if (const VertexId v = nearest_free(far); v.valid() && held_[v.value()] == 0 && reach(v, far)) {
        moved.push_back(v);
        for_each_face_mate(v, [&](VertexId w) { held_[w.value()] = 1; });
        held_[v.value()] = 1;
      }
    smooth_around(moved);
    return moved.size();
  }

 private:
  struct Far {
    double distance;
    std::uint32_t point;
    FaceId face;  // where the mesh is nearest
  };

  template <class Visit>
  void for_each_face_mate(VertexId v, const Visit& visit) const {
    for_each_side_around(mesh_, v, [&](SideId s) {
      for (int k = 0; k < mesh_.corner_count(s.face()); ++k) visit(mesh_.corner(s.face(), k));
    });
  }

  // Quads are two triangles for this: how they are cut matters little.
  void find_far() {
    std::vector<Vec3> points;
    for (const VertexId v : mesh_.vertices()) points.push_back(mesh_.point3(v));
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<FaceId> faces;
    for (const FaceId f : mesh_.faces())
      for (int k = 1; mesh_.alive(f) && k + 1 < mesh_.corner_count(f); ++k) {
        triangles.push_back(
            {mesh_.corner(f, 0).value(), mesh_.corner(f, k).value(), mesh_.corner(f, k + 1).value()});
        faces.push_back(f);
      }
    const TriangleTree tree(points, triangles);
    const std::span<const SpacePoint> own = model_.free_points();
    std::vector<Vec3> places, normals;
    for (const SpacePoint& p : own) {
      places.push_back(p.place);
      normals.push_back(p.up);
    }
    ClosestQuery query;
    query.least_cosine = kSameSide;
    const std::vector<SurfacePoint> found = tree.closest_all(places, query, normals);
    far_.clear();
    for (std::uint32_t i = 0; i < found.size(); ++i) {
      if (!found[i].triangle.valid()) continue;
      const FaceId f = faces[found[i].triangle.value()];
      const double distance = std::sqrt(found[i].squared_distance);
      if (distance > options_.far * edge_of(f)) far_.push_back({distance, i, f});
    }
    std::stable_sort(far_.begin(), far_.end(),
                     [](const Far& a, const Far& b) { return a.distance > b.distance; });
  }

  [[nodiscard]] double edge_of(FaceId f) const {
    const auto corner = [&](int k) { return mesh_.point3(mesh_.corner(f, k)); };
    const int last = mesh_.corner_count(f) - 1;
    return std::sqrt(0.5 * length(cross(corner(2) - corner(0), corner(last) - corner(1))));
  }

  [[nodiscard]] VertexId nearest_free(const Far& far) const {
    VertexId best;
    double least = 0;
    const Vec3 aim = model_.free_points()[far.point].place;
    for (int k = 0; k < mesh_.corner_count(far.face); ++k) {
      const VertexId v = mesh_.corner(far.face, k);
      if (!tags_.support[v].is_free()) continue;
      const double distance = length(mesh_.point3(v) - aim);
      if (best.valid() && !(distance < least)) continue;
      best = v;
      least = distance;
    }
    return best;
  }

  bool reach(VertexId v, const Far& far) {
    const SpacePoint before{mesh_.point3(v), normals_[v]};
    const double content = std::min(options_.least_jacobian, worst_around(mesh_, normals_, v));
    const SpacePoint& aim = model_.free_points()[far.point];
    mesh_.set_point3(v, aim.place);
    normals_[v] = aim.up;
    if (worst_around(mesh_, normals_, v) >= content) return true;
    mesh_.set_point3(v, before.place);
    normals_[v] = before.up;
    return false;
  }

  // Two rings of free vertices around those that stay where they were brought.
  void smooth_around(const std::vector<VertexId>& moved) {
    std::vector<VertexId> around;
    for (const VertexId v : moved) for_each_face_mate(v, [&](VertexId w) { around.push_back(w); });
    const std::vector<VertexId> ring = around;
    for (const VertexId v : ring) for_each_face_mate(v, [&](VertexId w) { around.push_back(w); });
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    std::vector<VertexId> stay = moved;
    std::sort(stay.begin(), stay.end());
    std::erase_if(around, [&](VertexId v) {
      return !tags_.support[v].is_free() || mesh_.on_boundary(v) ||
             std::binary_search(stay.begin(), stay.end(), v);
    });
    if (around.empty()) return;
    MeshEditor editor(mesh_);
    smoother_.run(editor, around, {.untangling_sweeps = 0, .sweeps = options_.sweeps, .area_averages = 4});
  }

  Mesh& mesh_;
  const ConstraintTags& tags_;
  const SurfaceModel& model_;
  const ReachOptions& options_;
  LocalSmoother<SpaceModel> smoother_;
  Tag<VertexId, Vec3> normals_;
  std::vector<Far> far_;
  std::vector<std::uint8_t> held_;
};

}  // namespace

std::size_t reach_far_points(Mesh& mesh, const ConstraintTags& tags, const SurfaceModel& model,
                             const ReachOptions& options, const Progress& progress) {
  FarPoints far(mesh, tags, model, options);
  std::size_t moved = 0;
  for (int round = 0; round < options.rounds; ++round) {
    progress.throw_if_cancelled();
    const std::size_t now = far.run_round();
    if (now == 0) break;
    moved += now;
  }
  return moved;
}

}  // namespace quarry
