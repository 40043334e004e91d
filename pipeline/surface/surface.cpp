#include "pipeline/surface/surface.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "engine/mesh/compact.hpp"
#include "engine/mesh/pinch.hpp"
#include "pipeline/surface/read_surface.hpp"
#include "surface/feature/bind.hpp"
#include "surface/model/surface_model.hpp"
#include "surface/remesh/remesh.hpp"
#include "surface/remesh/triangle_guard.hpp"
#include "surface/repair/sheets.hpp"
#include "surface/repair/split_joins.hpp"

namespace quarry {
namespace {

double area_of(const TriangleSurface& surface) {
  double area = 0;
  for (const SurfaceTriangle& t : surface.triangles) area += 0.5 * length(doubled_area(surface, t));
  return area;
}

// Equilateral triangles of that edge, so many on the area.
double size_for_count(double count, double area) { return std::sqrt(4 * area / (std::sqrt(3.0) * count)); }

class SurfaceJob {
 public:
  SurfaceJob(const SurfaceOptions& options, const Progress& progress)
      : options_(options), progress_(progress), clock_(progress) {}

  SurfaceResult run() {
    clock_.start("reading");
    TriangleSurface surface = read_surface(options_.inputs, result_.names);
    clock_.start("repairing");
    RepairedSurface repaired = repair_surface(std::move(surface), options_.repair);
    find_size(repaired.surface);
    RemeshOptions remesh;
    remesh.edge = result_.size;
    split_joins(repaired, remesh.longest * remesh.edge);
    clock_.start("finding features");
    FeatureOptions features = options_.features;
    features.size = result_.size;
    const FeatureEdges found = find_feature_edges(repaired, features);
    const CurveNetwork network = make_curve_network(repaired.surface, found.edges, features);
    count(found, network);
    Mesh& mesh = result_.mesh;
    mesh = make_sheets(repaired);
    const ConstraintTags tags = bind_features(mesh, network);
    const SurfaceModel model(mesh, tags);
    clock_.start("remeshing");
    result_.remesh = remesh_surface(mesh, model, network, remesh, progress_);
    clock_.start("finishing");
    finish(network);
    result_.repaired = std::move(repaired.surface);
    result_.repair = std::move(repaired.report);
    clock_.stop();
    result_.times = clock_.times();
    return std::move(result_);
  }

 private:
  void find_size(const TriangleSurface& surface) {
    const double area = area_of(surface);
    if (!(area > 0)) throw Error(ErrorKind::kGeometry, "the surface has no area");
    result_.size = options_.size ? *options_.size : size_for_count(*options_.count, area);
    const double elements = 4 * area / (std::sqrt(3.0) * result_.size * result_.size);
    if (elements > options_.max_elements)
      throw Error(ErrorKind::kBudget,
                  fmt::format("about {:.3g} elements are to be expected, more than --max-elements "
                              "{:g}: take a larger --size",
                              elements, options_.max_elements));
  }

  void count(const FeatureEdges& found, const CurveNetwork& network) {
    FeatureCounts& counts = result_.features;
    counts.nodes = network.nodes.size();
    counts.curves = network.curves.size();
    counts.sharp_degrees = found.sharp_degrees;
    for (const FeatureEdge& edge : found.edges) {
      if (edge.kind == FeatureKind::kSharp) ++counts.sharp_edges;
      if (edge.kind == FeatureKind::kBorder) ++counts.border_edges;
      if (edge.kind == FeatureKind::kRim) ++counts.rim_edges;
      if (edge.kind == FeatureKind::kJoin) ++counts.join_edges;
    }
  }

  // Regions, edge entities and points that sheets share, in the place of what the kernels work with.
  void finish(const CurveNetwork& network) {
    Mesh& mesh = result_.mesh;
    const ConstraintTags tags = ConstraintTags::of(mesh);
    auto region = mesh.add_tag<FaceId, std::int32_t>("region");
    const auto group = mesh.find_tag<FaceId, std::int32_t>(kSurfaceGroupTag);
    for (const FaceId f : mesh.faces()) region[f] = group[f];
    auto constraint = mesh.add_tag<EdgeId, std::int32_t>("constraint", -1);
    auto kind = mesh.add_tag<EdgeId, std::int32_t>("kind", kInteriorConstraint);
    for (const FaceId f : mesh.faces()) {
      for (int k = 0; mesh.alive(f) && k < mesh.corner_count(f); ++k) {
        const SideId s(f, k);
        const SideId t = mesh.neighbour(s);
        if (!tags.constrained(s) || (t.valid() && t < s)) continue;
        const VertexId a = mesh.origin(s);
        const VertexId b = mesh.target(s);
        const EdgeId e = mesh.add_edge(a, b);
        const Vec3 middle = 0.5 * (mesh.point3(a) + mesh.point3(b));
        const PieceId curve = network.under_edge(tags.support[a], tags.support[b], middle);
        constraint[e] = curve.valid() ? static_cast<std::int32_t>(curve.value()) : -1;
        if (!t.valid()) kind[e] = kOuterBoundary;
      }
    }
    auto pinch = mesh.add_tag<VertexId, std::uint8_t>(kPinchTag);
    for (const VertexId v : mesh.vertices())
      if (mesh.alive(v)) pinch[v] = tags.support[v].is_fixed() ? 1 : 0;
    mesh.remove_tag<FaceId>(kSurfaceGroupTag);
    mesh.remove_tag<VertexId>(kSurfacePointTag);
    mesh.remove_tag<VertexId>(kSurfaceNormalTag);
    mesh.remove_tag<VertexId>("support");
    mesh.remove_tag<FaceId>("constrained_sides");
    compact(mesh, EntityOrder::kHilbert);
  }

  const SurfaceOptions& options_;
  const Progress& progress_;
  StageClock clock_;
  SurfaceResult result_;
};

}  // namespace

SurfaceResult mesh_surface(const SurfaceOptions& options, const Progress& progress) {
  return SurfaceJob(options, progress).run();
}

}  // namespace quarry
