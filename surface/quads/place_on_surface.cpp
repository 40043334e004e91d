#include "surface/quads/place_on_surface.hpp"

#include <algorithm>
#include <span>
#include <vector>

#include "engine/parallel/parallel.hpp"
#include "kernels/smooth/sweep.hpp"
#include "surface/quads/face_verdict.hpp"
#include "surface/quads/normal_around.hpp"

namespace quarry {
namespace {

// What subdivide_in_space left fixed in the middle of a feature between two nodes slides on that feature; not
// on a join, where the other sheets know nothing of it.
Support support_on_feature(const Mesh& mesh, const ConstraintTags& tags, const CurveNetwork& network,
                           VertexId v) {
  const Support support = tags.support[v];
  if (!support.is_fixed() || support.is_node()) return support;
  std::vector<Support> ends;
  for_each_constrained_neighbour(mesh, tags, v, [&](VertexId w) { ends.push_back(tags.support[w]); });
  if (ends.size() != 2 || !ends[0].is_node() || !ends[1].is_node()) return support;
  const PieceId curve = network.under_edge(ends[0], ends[1], mesh.point3(v));
  return curve.valid() && network.curves[curve].kind != FeatureKind::kJoin ? Support::on(curve) : support;
}

// Moves vertices to where they belong as far as the faces around them bear it: what halving leaves lies flat
// in its triangle, and all at once some would be turned over where the surface bends much.
class PlacingMover {
 public:
  PlacingMover(Tag<VertexId, Vec3> normals, std::span<const Vec3> targets)
      : normals_(normals), targets_(targets) {}

  [[nodiscard]] bool may_move(VertexId) const { return true; }
  void first_look(const Mesh& mesh, WakeList& list) const {
    parallel::for_each(mesh.vertex_slots(), [&](std::size_t i) {
      const VertexId v(i);
      if (mesh.alive(v) && !(mesh.point3(v) == targets_[i])) list.wake(v);
    });
  }

  bool move(Mesh& mesh, VertexId v) const {
    const Vec3 place = mesh.point3(v);
    const Vec3 step = targets_[v.value()] - place;
    if (step == Vec3()) return false;
    const double content = std::min(kContent, worst_around(mesh, normals_, v));
    for (const double share : {1.0, 0.5, 0.25}) {
      mesh.set_point3(v, share == 1 ? targets_[v.value()] : place + share * step);
      if (worst_around(mesh, normals_, v) >= content) return true;
    }
    mesh.set_point3(v, place);
    return false;
  }

 private:
  // No face may become worse that is worse than this.
  static constexpr double kContent = 0.3;

  Tag<VertexId, Vec3> normals_;
  std::span<const Vec3> targets_;
};

constexpr int kPlacingSweeps = 4;
// The cosine of the angle between the normal of the surface and that of the faces around a vertex.
constexpr double kLeastAgreement = 0.5;

}  // namespace

void bind_middles(const Mesh& mesh, ConstraintTags tags, const CurveNetwork& network) {
  // Read all before any is written: supports of neighbours are looked at.
  std::vector<Support> supports(mesh.vertex_slots());
  parallel::for_each(mesh.vertex_slots(), [&](std::size_t i) {
    if (mesh.alive(VertexId(i))) supports[i] = support_on_feature(mesh, tags, network, VertexId(i));
  });
  parallel::for_each(mesh.vertex_slots(), [&](std::size_t i) {
    if (mesh.alive(VertexId(i))) tags.support[VertexId(i)] = supports[i];
  });
}

void place_on_surface(Mesh& mesh, ConstraintTags tags, const SurfaceModel& model, const CurveNetwork& network,
                      const Progress& progress) {
  std::vector<Vec3> targets(mesh.vertex_slots());
  auto normals = mesh.add_normals();
  parallel::for_each(mesh.vertex_slots(), [&](std::size_t i) {
    const VertexId v(i);
    if (!mesh.alive(v)) return;
    const Support support = tags.support[v];
    targets[i] = mesh.point3(v);
    if (support.is_free()) {
      const Vec3 around = normal_around(mesh, v);
      const SpacePoint foot = model.project({targets[i], around});
      // Where an element bridges a fold the nearest point lies on one side of it: its normal says nothing.
      const bool agrees = dot(foot.up, around) >= kLeastAgreement;
      if (agrees) targets[i] = foot.place;
      normals[v] = agrees ? foot.up : around;
    } else if (support.slides()) {
      targets[i] = network.project(support.piece(), targets[i]);
    }
  });
  VertexColouring colouring(mesh);
  run_sweeps(mesh, colouring, PlacingMover(normals, targets), kPlacingSweeps, progress);
}

void set_feature_normals(Mesh& cut_open, const ConstraintTags& tags) {
  auto normals = cut_open.normals();
  parallel::for_each(cut_open.vertex_slots(), [&](std::size_t i) {
    const VertexId v(i);
    if (cut_open.alive(v) && !tags.support[v].is_free()) normals[v] = normal_around(cut_open, v);
  });
}

void clear_feature_normals(Mesh& mesh, const ConstraintTags& tags) {
  auto normals = mesh.normals();
  parallel::for_each(mesh.vertex_slots(), [&](std::size_t i) {
    if (mesh.alive(VertexId(i)) && !tags.support[VertexId(i)].is_free()) normals[VertexId(i)] = Vec3();
  });
}

}  // namespace quarry
