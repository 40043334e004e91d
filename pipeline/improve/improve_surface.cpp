#include "pipeline/improve/improve_surface.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "engine/base/heap.hpp"
#include "engine/mesh/validate.hpp"
#include "pipeline/improve/clean_up_floor.hpp"
#include "pipeline/improve/face_surface.hpp"
#include "pipeline/improve/group_labels.hpp"
#include "pipeline/improve/improve_notes.hpp"
#include "pipeline/improve/surface_lines.hpp"
#include "pipeline/surface/finish_surface.hpp"
#include "surface/feature/bind.hpp"
#include "surface/quads/quads.hpp"
#include "surface/quads/unfold_faces.hpp"
#include "surface/repair/sheets.hpp"
#include "surface/repair/surface_edges.hpp"

namespace quarry {
namespace {

// Rounds of stars from which a quad takes its area: with eight, as where sizes are asked for, those that
// other programs leave beside one another stay more uneven, and the mean scaled Jacobian is 0.001 to 0.003
// lower.
constexpr int kAreaAverages = 30;

// Of the points of the surface that faces have to come near to, in sides of faces.
constexpr double kPointSpacing = 0.5;

// How far a vertex may leave the surface where folds are taken out of it, in sides of faces: as much as a
// side bends on a coarse one.
constexpr double kFarthestUnfolded = 0.2;

// While a mesh is finished: the point of the file at each vertex that is a node.
constexpr const char* kNodePointTag = "node_point";

std::string place_text(Vec3 p) { return fmt::format("({:.10g}, {:.10g}, {:.10g})", p.x, p.y, p.z); }

void require_options_of_surfaces(const ImproveOptions& options) {
  const auto refuse = [&](bool given, const char* name, const char* instead) {
    if (given)
      throw Error(ErrorKind::kUsage,
                  fmt::format("{}: {} is for meshes of the plane, and this one is in space; {}",
                              options.input, name, instead));
  };
  refuse(options.size.has_value(), "--size", "quarry mesh gives a surface elements of another size");
  refuse(!options.irregular_price.empty(), "--irregular-price", "leave it out");
  refuse(options.mixed_quality.has_value(), "--elements mixed", "leave it out");
}

class ImproveSurfaceJob {
 public:
  ImproveSurfaceJob(const ImproveOptions& options, ReadCells cells, StageClock& clock,
                    const Progress& progress)
      : options_(options), cells_(std::move(cells)), clock_(clock), progress_(progress) {}

  ImproveResult run() {
    take_faces();
    clock_.start("binding");
    bind();
    clock_.start("clean-up");
    improve();
    clock_.start("finishing");
    finish();
    clock_.stop();
    result_.times = clock_.times();
    return std::move(result_);
  }

 private:
  void note(std::string text) { result_.notes.push_back(options_.input + ": " + std::move(text)); }

  void take_faces() {
    result_.names = cells_.names;
    labels_ = GroupLabels(cells_);
    result_.groups = labels_.groups();
    faces_ = make_face_surface(options_.input, cells_);
    result_.tolerance = options_.tolerance.value_or(rounding_of(surface()));
    result_.turned = faces_.turned;
    if (faces_.welded > 0)
      note(fmt::format("{} points lie where another one does: they are one", faces_.welded));
    if (faces_.narrowed > 0)
      note(fmt::format("{} quads have two corners at one place and are triangles now", faces_.narrowed));
    if (faces_.turned > 0)
      note(fmt::format("{} of {} faces are turned, so that neighbours agree on which side is up",
                       faces_.turned, cells_.faces.size()));
    result_.before = summarize_quality(make_mesh(options_.input, cells_));
    if (result_.before.quads.faces == 0) result_.notes.push_back(no_quads_note(options_.input));
    lines_ = find_surface_lines(cells_, faces_);
    unfold();
    area_ = area_of(surface());
    if (!(area_ > 0)) throw Error(ErrorKind::kGeometry, options_.input + ": the mesh has no area");
  }

  // Where faces are folded over, the surface that they are would be as well.
  void unfold() {
    make_meshes();
    Mesh& mesh = result_.mesh;
    const std::vector<FaceId> folded = find_folded_faces(mesh);
    result_.invalid = folded.size();
    if (folded.empty()) return mesh.remove_normals();
    result_.notes.push_back(invalid_faces_note(options_.input, folded.size(),
                                               place_text(mesh.point3(mesh.corner(folded.front(), 0)))));
    std::vector<FeatureEdge> features = find_features().edges;
    std::vector<std::uint8_t> touched(surface().points.size(), 0);
    const auto point = mesh.find_tag<VertexId, std::uint32_t>(kSurfacePointTag);
    for (const FaceId f : folded)
      for (int k = 0; k < mesh.corner_count(f); ++k) touched[point[mesh.corner(f, k)]] = 1;
    // A fold looks like a sharp edge.
    std::erase_if(features, [&](const FeatureEdge& edge) {
      return edge.kind == FeatureKind::kSharp && (touched[edge.ends[0]] != 0 || touched[edge.ends[1]] != 0);
    });
    network_ = make_curve_network(surface(), features, feature_options(), fixed_points());
    unfold_faces(mesh, bind_features(mesh, network_), progress_);
    take_places();
    make_meshes();
  }

  void make_meshes() {
    sheets_ = make_sheets(faces_.triangles);
    result_.mesh = make_face_mesh(faces_, sheets_, cells_.faces);
  }

  // Vertices that were moved within the surface leave it as it is but for folds; if one has left it, a sharp
  // edge was taken for one, and all stay.
  void take_places() {
    const Mesh& mesh = result_.mesh;
    const SurfaceModel before(sheets_, bind_features(sheets_, network_));
    std::vector<Vec3> places = surface().points;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const VertexId v(i);
      if (!mesh.alive(v) || mesh.point3(v) == places[i]) continue;
      places[i] = mesh.point3(v);
      if (length(before.nearest({places[i], Vec3()}).position - places[i]) >
          kFarthestUnfolded * faces_.mean_side)
        return;
    }
    faces_.triangles.surface.points = std::move(places);
  }

  [[nodiscard]] FeatureOptions feature_options() const {
    FeatureOptions features;
    features.sharp_degrees = options_.sharp_degrees;
    features.size = faces_.mean_side;
    features.straightness = result_.tolerance;
    return features;
  }
  [[nodiscard]] FeatureEdges find_features() const {
    return find_feature_edges(faces_.triangles, feature_options(), lines_.edges, faces_.within);
  }

  // Tagged edges, rims, borders of regions, what sheets share, and edges at which the surface turns sharply.
  void bind() {
    result_.tagged_edges = lines_.tagged;
    if (lines_.lost > 0) result_.notes.push_back(lost_lines_note(options_.input, lines_.lost));
    if (!lines_.apart.empty()) result_.notes.push_back(edges_apart_note(options_.input, lines_.apart.size()));
    const FeatureEdges found = find_features();
    for (const FeatureEdge& edge : found.edges)
      if (edge.kind == FeatureKind::kSharp) ++result_.sharp_edges;
    result_.sharp_degrees = found.sharp_degrees;
    network_ = make_curve_network(surface(), found.edges, feature_options(), fixed_points());
    result_.nodes = network_.nodes.size();
    result_.pieces = network_.curves.size();
  }

  // Points that stay: where sheets touch or meet each of them has a vertex of its own, behind those of all
  // points, which knows nothing of the others.
  [[nodiscard]] std::vector<std::uint32_t> fixed_points() const {
    const auto point = sheets_.find_tag<VertexId, std::uint32_t>(kSurfacePointTag);
    std::vector<std::uint32_t> fixed = lines_.fixed;
    for (std::size_t i = surface().points.size(); i < sheets_.vertex_slots(); ++i)
      fixed.push_back(point[VertexId(i)]);
    return fixed;
  }

  void improve() {
    static_cast<void>(bind_features(result_.mesh, network_));
    const SurfaceModel model(sheets_, bind_sheets(), kPointSpacing * faces_.mean_side);
    sheets_ = Mesh();
    SurfaceQuadOptions options;
    options.cleanup = options_.cleanup;
    options.area_averages = kAreaAverages;
    options.local.floor = options.patches.least_jacobian =
        clean_up_floor(result_.before, options.patches.least_jacobian);
    options.reach.least_jacobian = options.local.floor;
    give_back_freed_memory();
    SurfaceQuadReport report;
    result_.mesh =
        improve_surface_quads(std::move(result_.mesh), model, network_, options, report, progress_);
    result_.clean_up = std::move(report.clean_up);
    require_valid(model);
    set_surface_regions(result_.mesh, surface().groups, model);
  }

  // A point that is kept for its own sake is no tip of the surface.
  ConstraintTags bind_sheets() {
    ConstraintTags tags = bind_features(sheets_, network_);
    for (const std::uint32_t p : lines_.fixed)
      if (const Support support = tags.support[VertexId(p)];
          support.is_node() && network_.curves_at[support.node()].empty())
        tags.support[VertexId(p)] = Support::free();
    return tags;
  }

  void require_valid(const SurfaceModel& model) const {
    const Mesh& mesh = result_.mesh;
    const std::vector<FaceId> invalid = find_invalid_on_surface(mesh, model, area_);
    if (!invalid.empty())
      throw Error(
          ErrorKind::kGeometry,
          fmt::format("{}: {} faces cannot be made valid within the features around them, the first at "
                      "{}; nothing was written",
                      options_.input, invalid.size(),
                      place_text(mesh.point3(mesh.corner(invalid.front(), 0)))));
  }

  void finish() {
    Mesh& mesh = result_.mesh;
    mark_nodes();
    finish_surface_mesh(mesh, network_, [&](PieceId curve, bool rim) {
      return curve.valid() ? lines_.numbers_of(network_.curves[curve], rim) : std::vector<std::int32_t>();
    });
    restore_points();
    const std::string failure = validate(mesh, GeometryCheck::kNone);
    if (!failure.empty()) throw Error(ErrorKind::kBug, "the improved mesh is not valid: " + failure);
    require_lines_kept();
    labels_.restore(mesh);
  }

  void mark_nodes() {
    Mesh& mesh = result_.mesh;
    const ConstraintTags tags = ConstraintTags::of(mesh);
    auto point = mesh.add_tag<VertexId, std::int32_t>(kNodePointTag, -1);
    for (const VertexId v : mesh.vertices())
      if (mesh.alive(v) && tags.support[v].is_node())
        point[v] = static_cast<std::int32_t>(network_.nodes[tags.support[v].node()]);
  }

  // Points of the file, and edges that are no side of a face.
  void restore_points() {
    Mesh& mesh = result_.mesh;
    const auto point = mesh.find_tag<VertexId, std::int32_t>(kNodePointTag);
    std::map<std::uint32_t, VertexId> vertex_at;
    for (const VertexId v : mesh.vertices())
      if (point[v] >= 0) vertex_at.try_emplace(static_cast<std::uint32_t>(point[v]), v);
    mesh.remove_tag<VertexId>(kNodePointTag);
    const auto constraint = mesh.find_tag<EdgeId, std::int32_t>("constraint");
    for (const EdgeApart& edge : lines_.apart) {
      auto numbers = constraint;
      numbers[mesh.add_edge(vertex_at.at(edge.a), vertex_at.at(edge.b))] = edge.number;
    }
    if (cells_.points.empty()) return;
    auto number = mesh.add_tag<VertexId, std::int32_t>(kPointTag, -1);
    for (std::size_t i = 0; i < cells_.points.size(); ++i) {
      const auto found = vertex_at.find(cells_.points[i].value());
      if (found == vertex_at.end()) continue;
      std::int32_t& here = number[found->second];
      if (here < 0 || cells_.point_numbers[i] < here) here = cells_.point_numbers[i];
    }
  }

  // Each number's edges cover what they covered before.
  void require_lines_kept() const {
    const Mesh& mesh = result_.mesh;
    std::map<std::int32_t, double> now;
    const auto constraint = mesh.find_tag<EdgeId, std::int32_t>("constraint");
    for (const EdgeId e : mesh.edges()) {
      const auto [a, b] = mesh.edge_ends(e);
      if (constraint[e] >= 0) now[constraint[e]] += length(mesh.point3(b) - mesh.point3(a));
    }
    const double slack =
        1e-6 * std::sqrt(area_) + 2 * result_.tolerance * static_cast<double>(mesh.edge_slots());
    for (const auto& [number, whole] : lines_.lengths(surface()))
      if (const double kept = now[number]; std::abs(kept - whole) > slack)
        throw Error(ErrorKind::kBug, fmt::format("{}: tagged edges {} had a length of {} and have {} now",
                                                 options_.input, labels_.constraint(number), whole, kept));
  }

  [[nodiscard]] const TriangleSurface& surface() const { return faces_.triangles.surface; }

  const ImproveOptions& options_;
  ReadCells cells_;
  StageClock& clock_;
  const Progress& progress_;
  ImproveResult result_;
  GroupLabels labels_;
  FaceSurface faces_;
  double area_ = 0;
  SurfaceLines lines_;
  Mesh sheets_;  // of triangles
  CurveNetwork network_;
};

}  // namespace

ImproveResult improve_surface(const ImproveOptions& options, ReadCells cells, StageClock& clock,
                              const Progress& progress) {
  require_options_of_surfaces(options);
  return ImproveSurfaceJob(options, std::move(cells), clock, progress).run();
}

}  // namespace quarry
