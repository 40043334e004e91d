#include "pipeline/surface/finish_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "engine/mesh/compact.hpp"
#include "engine/mesh/constraint.hpp"
#include "engine/mesh/pinch.hpp"
#include "engine/parallel/parallel.hpp"
#include "io/mesh/mesh_file.hpp"
#include "kernels/quality/face.hpp"
#include "surface/quads/normal_around.hpp"
#include "surface/repair/sheets.hpp"

namespace quarry {
namespace {

// A face whose scaled Jacobian is no more than this has no direction that means anything.
constexpr double kFlat = 1e-3;

// What of the surface is about as near to the middle of a face as the nearest point: this share of the size
// of the face farther away, for faces that bend over an edge. But where faces are large, that would be what
// faces the right way on the far side of a wall, or beyond a gap, and no excuse for a face that lies on the
// other one: no more than this share of the size of the whole surface away along it, as far as a mesh may lie
// from it.
constexpr double kSlack = 0.5;
constexpr double kReach = 3e-3;

// Upside down on the surface: its own corners do not tell.
bool lies_upside_down(const Mesh& mesh, const SurfaceModel& model, FaceId f, double reach) {
  const int count = mesh.corner_count(f);
  const auto corner = [&](int k) { return mesh.point3(mesh.corner(f, k)); };
  Vec3 middle;
  for (int k = 0; k < count; ++k) middle = middle + (1.0 / count) * corner(k);
  double size = 0;
  for (int k = 0; k < count; ++k) size = std::max(size, length(corner(k) - middle));
  return !model.faces_along(middle, area_vector(mesh, f), kSlack * size, reach);
}

// The constrained edges by the places of their ends: where sheets meet several of them lie in one place, and
// an edge within one sheet may bear others.
class ConstrainedEdges {
 public:
  ConstrainedEdges(const Mesh& mesh, const ConstraintTags& tags) : mesh_(mesh) {
    for (const FaceId f : mesh.faces())
      for (int k = 0; mesh.alive(f) && k < mesh.corner_count(f); ++k) {
        const SideId s(f, k);
        const SideId t = mesh.neighbour(s);
        if (tags.constrained(s) && (!t.valid() || s < t)) ++ends_[key(s)].sheets;
      }
  }

  // Of a constrained side.
  [[nodiscard]] bool is_shared(SideId s) const { return ends_.at(key(s)).sheets > 1; }
  // True once for each edge.
  bool take(SideId s) { return !std::exchange(ends_.at(key(s)).taken, true); }

 private:
  using Place = std::array<double, 3>;
  struct Uses {
    int sheets = 0;
    bool taken = false;
  };

  [[nodiscard]] std::pair<Place, Place> key(SideId s) const {
    const Vec3 a = mesh_.point3(mesh_.origin(s)), b = mesh_.point3(mesh_.target(s));
    const Place from{a.x, a.y, a.z}, to{b.x, b.y, b.z};
    return {std::min(from, to), std::max(from, to)};
  }

  const Mesh& mesh_;
  std::map<std::pair<Place, Place>, Uses> ends_;
};

}  // namespace

std::vector<FaceId> find_invalid_on_surface(const Mesh& mesh, const SurfaceModel& model, double area) {
  const double reach = kReach * std::sqrt(area);
  std::vector<FaceId> bad;
  for (const std::uint32_t i : parallel::filter_indices(mesh.face_slots(), [&](std::size_t i) {
         const FaceId f(i);
         return mesh.alive(f) &&
                (!(scaled_jacobian(mesh, f) > kFlat) || lies_upside_down(mesh, model, f, reach));
       }))
    bad.emplace_back(i);
  return bad;
}

void set_surface_regions(Mesh& mesh, const std::vector<std::int32_t>& groups, const SurfaceModel& model) {
  const ConstraintTags tags = ConstraintTags::of(mesh);
  if (std::equal(groups.begin() + 1, groups.end(), groups.begin())) {
    mesh.add_tag<FaceId, std::int32_t>("region", groups.front());
    return;
  }
  auto region = mesh.add_tag<FaceId, std::int32_t>("region", -1);
  std::vector<std::uint8_t> seen(mesh.face_slots(), 0);
  std::vector<FaceId> part;
  for (const FaceId first : mesh.faces()) {
    if (!mesh.alive(first) || seen[first.value()] != 0) continue;
    part.assign(1, first);
    seen[first.value()] = 1;
    std::map<std::int32_t, std::size_t> votes;
    for (std::size_t i = 0; i < part.size(); ++i) {
      const Vec3 middle = 0.5 * (mesh.point3(mesh.corner(part[i], 0)) + mesh.point3(mesh.corner(part[i], 2)));
      ++votes[groups[model.nearest({middle, area_vector(mesh, part[i])}).triangle.value()]];
      for (int k = 0; k < mesh.corner_count(part[i]); ++k) {
        const SideId s(part[i], k);
        const SideId t = mesh.neighbour(s);
        if (tags.constrained(s) || !t.valid() || std::exchange(seen[t.face().value()], 1) != 0) continue;
        part.push_back(t.face());
      }
    }
    const auto most = std::max_element(votes.begin(), votes.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    for (const FaceId f : part) region[f] = most->first;
  }
}

void finish_surface_mesh(Mesh& mesh, const CurveNetwork& network, const NumbersOfCurve& numbers) {
  const ConstraintTags tags = ConstraintTags::of(mesh);
  auto constraint = mesh.add_tag<EdgeId, std::int32_t>("constraint", -1);
  auto kind = mesh.add_tag<EdgeId, std::int32_t>("kind", kInteriorConstraint);
  ConstrainedEdges edges(mesh, tags);
  for (const FaceId f : mesh.faces()) {
    for (int k = 0; mesh.alive(f) && k < mesh.corner_count(f); ++k) {
      const SideId s(f, k);
      const SideId t = mesh.neighbour(s);
      if (!tags.constrained(s) || (t.valid() && t < s)) continue;
      const VertexId a = mesh.origin(s);
      const VertexId b = mesh.target(s);
      if (!edges.take(s)) continue;
      const bool rim = !t.valid() && !edges.is_shared(s);
      const Vec3 middle = 0.5 * (mesh.point3(a) + mesh.point3(b));
      for (const std::int32_t number :
           numbers(network.under_edge(tags.support[a], tags.support[b], middle), rim)) {
        const EdgeId e = mesh.add_edge(a, b);
        constraint[e] = number;
        if (rim) kind[e] = kOuterBoundary;
      }
    }
  }
  auto pinch = mesh.add_tag<VertexId, std::uint8_t>(kPinchTag);
  for (const VertexId v : mesh.vertices())
    if (mesh.alive(v)) pinch[v] = tags.support[v].is_fixed() ? 1 : 0;
  if (mesh.find_tag<FaceId, std::int32_t>(kSurfaceGroupTag).valid())
    mesh.remove_tag<FaceId>(kSurfaceGroupTag);
  if (mesh.find_tag<VertexId, std::uint32_t>(kSurfacePointTag).valid())
    mesh.remove_tag<VertexId>(kSurfacePointTag);
  mesh.remove_normals();
  mesh.remove_tag<VertexId>("support");
  mesh.remove_tag<FaceId>("constrained_sides");
  compact(mesh, EntityOrder::kHilbert);
}

}  // namespace quarry
