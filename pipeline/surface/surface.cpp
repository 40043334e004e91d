#include "pipeline/surface/surface.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "engine/mesh/compact.hpp"
#include "engine/mesh/pinch.hpp"
#include "engine/parallel/parallel.hpp"
#include "io/lines/line_reader.hpp"
#include "kernels/quality/face.hpp"
#include "pipeline/surface/read_surface.hpp"
#include "surface/feature/bind.hpp"
#include "surface/model/surface_model.hpp"
#include "surface/remesh/remesh.hpp"
#include "surface/repair/coarsen_joins.hpp"
#include "surface/repair/sheets.hpp"
#include "surface/repair/split_joins.hpp"
#include "surface/size/detail_size.hpp"
#include "surface/size/surface_sizes.hpp"

namespace quarry {
namespace {

double area_of(const TriangleSurface& surface) {
  double area = 0;
  for (const SurfaceTriangle& t : surface.triangles) area += 0.5 * length(doubled_area(surface, t));
  return area;
}

// The area of an equilateral triangle, and of a square, of edge 1.
double element_area(Elements elements) { return elements == Elements::kTriangle ? 0.25 * std::sqrt(3.0) : 1; }

// Triangles of this edge are to make quads of edge 1: two that are paired make four, one that is not makes
// three, as about one in eight does.
const double kTrianglesForQuads = std::sqrt(2.12 * 4 / std::sqrt(3.0));

// How fast sizes grow away from details: by this share of the distance.
constexpr double kGrowth = 0.3;
// How much larger elements become elsewhere, at most, where details need more of a wanted number; and how
// many more than their area asks for there may be, if the size is given.
constexpr double kMostStretch = 1.25;
constexpr double kMostForDetails = 1.25;
// Where that does not do, details are meshed more coarsely, by up to this factor.
constexpr double kMostLenient = 16;
constexpr double kFitTolerance = 1e-3;
// Of lines: how they are led, in edges of triangles; and by default, in sizes, what they snap to and how far
// from the surface they may lie.
constexpr double kImprintStep = 0.5;
constexpr double kDefaultSnap = 0.05;
constexpr double kImprintReach = 1;

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
    const double edge = result_.size * (makes_quads() ? kTrianglesForQuads : 1);
    RemeshOptions remesh;
    result_.repaired = repaired.surface;
    coarsen_joins(repaired, {.shortest = remesh.shortest * edge,
                             .longest = remesh.longest * edge,
                             .deviation = remesh.feature_deviation * edge});
    const std::vector<LineEdge> lines = imprint(repaired, edge);
    split_joins(repaired, remesh.longest * edge);
    clock_.start("finding features");
    FeatureOptions features = options_.features;
    features.size = edge;
    const FeatureEdges found = find_feature_edges(repaired, features, lines);
    const CurveNetwork network = make_curve_network(repaired.surface, found.edges, features);
    count(found, network);
    Mesh& mesh = result_.mesh;
    mesh = make_sheets(repaired);
    const ConstraintTags tags = bind_features(mesh, network);
    const SurfaceModel model(mesh, tags);
    clock_.start("finding sizes");
    const SurfaceSizes sizes = find_sizes(edge);
    if (options_.count) remesh.wanted_faces = area_ / (0.25 * std::sqrt(3.0) * edge * edge);
    clock_.start("remeshing");
    result_.remesh = remesh_surface(mesh, model, network, sizes, remesh, progress_);
    if (makes_quads()) {
      clock_.start("making quads");
      SurfaceQuadOptions quads;
      quads.cleanup = options_.cleanup;
      quads.graded = !sizes.uniform();
      // With a wanted edge and details as many as there are: the details need more.
      if (options_.count || sizes.uniform())
        quads.wanted_faces = static_cast<std::size_t>(area_ / (result_.size * result_.size));
      mesh = make_surface_quads(std::move(mesh), model, network, quads, result_.quads, progress_);
    }
    clock_.start("finishing");
    require_valid(model);
    set_regions(repaired.surface, model);
    finish(network);
    result_.repair = std::move(repaired.report);
    clock_.stop();
    result_.times = clock_.times();
    return std::move(result_);
  }

 private:
  void find_size(const TriangleSurface& surface) {
    const double area = area_ = area_of(surface);
    if (!(area > 0)) throw Error(ErrorKind::kGeometry, "the surface has no area");
    result_.size = options_.size ? *options_.size
                                 : std::sqrt(area / (element_area(options_.elements) * *options_.count));
    const double elements = area / (element_area(options_.elements) * result_.size * result_.size);
    if (elements > options_.max_elements)
      throw Error(ErrorKind::kBudget,
                  fmt::format("about {:.3g} elements are to be expected, more than --max-elements "
                              "{:g}: take a larger --size",
                              elements, options_.max_elements));
  }

  [[nodiscard]] std::vector<LineEdge> imprint(RepairedSurface& repaired, double edge) {
    if (options_.lines.empty()) return {};
    clock_.start("imprinting lines");
    const LineSet input = read_lines(options_.lines);
    result_.lines = input.lines.size();
    std::vector<SurfaceLine> lines;
    for (const InputLine& line : input.lines) {
      SurfaceLine on_surface;
      on_surface.has_heights = !line.heights.empty();
      for (std::size_t i = 0; i < line.points.size(); ++i)
        on_surface.points.push_back(
            {line.points[i].x, line.points[i].y, on_surface.has_heights ? line.heights[i] : 0});
      lines.push_back(std::move(on_surface));
    }
    ImprintOptions imprint;
    imprint.step = kImprintStep * edge;
    imprint.snap = options_.snap.value_or(kDefaultSnap * result_.size);
    imprint.reach = kImprintReach * result_.size;
    return imprint_lines(repaired, lines, imprint, result_.imprint);
  }

  // Where the surface has details elements are smaller.
  [[nodiscard]] SurfaceSizes find_sizes(double edge) const {
    const Mesh& mesh = result_.mesh;
    DetailOptions details;
    details.edge = edge;
    SurfaceSizes sizes(mesh, detail_sizes(mesh, ConstraintTags::of(mesh), details), kGrowth, edge);
    if (sizes.uniform()) return sizes;
    const double wanted = area_ / (edge * edge) * (options_.count ? 1 : kMostForDetails);
    if (options_.count)
      fit(sizes, wanted, edge, kMostStretch * edge, [&](double longer) { sizes.set_edge(longer); });
    fit(sizes, wanted, 1, kMostLenient, [&](double factor) { sizes.set_leniency(factor); });
    return sizes;
  }

  // The least value from low to high with which no more squares have room than are wanted; else high.
  template <class Set>
  static void fit(const SurfaceSizes& sizes, double wanted, double low, double high, const Set& set) {
    set(low);
    if (sizes.squares() <= wanted) return;
    while (high - low > kFitTolerance * low) {
      const double middle = 0.5 * (low + high);
      set(middle);
      (sizes.squares() > wanted ? low : high) = middle;
    }
    set(high);
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

  [[nodiscard]] bool makes_quads() const { return options_.elements != Elements::kTriangle; }

  // Upside down on the surface: its own corners do not tell.
  [[nodiscard]] bool lies_upside_down(const SurfaceModel& model, FaceId f) const {
    const Mesh& mesh = result_.mesh;
    const int count = mesh.corner_count(f);
    const auto corner = [&](int k) { return mesh.point3(mesh.corner(f, k)); };
    Vec3 middle;
    for (int k = 0; k < count; ++k) middle = middle + (1.0 / count) * corner(k);
    double size = 0;
    for (int k = 0; k < count; ++k) size = std::max(size, length(corner(k) - middle));
    const Vec3 normal = count == 4 ? cross(corner(2) - corner(0), corner(3) - corner(1))
                                   : cross(corner(1) - corner(0), corner(2) - corner(0));
    return !model.faces_along(middle, normal, 0.5 * size);
  }

  // Where a wall or a gap is thinner than the elements are long, nothing good may be left to be done.
  void require_valid(const SurfaceModel& model) const {
    const Mesh& mesh = result_.mesh;
    const auto bad = parallel::filter_indices(mesh.face_slots(), [&](std::size_t i) {
      const FaceId f(i);
      return mesh.alive(f) && (!(scaled_jacobian(mesh, f) > 0) || lies_upside_down(model, f));
    });
    if (bad.empty()) return;
    const Vec3 p = mesh.point3(mesh.corner(FaceId(bad.front()), 0));
    throw Error(ErrorKind::kGeometry,
                fmt::format("{} elements are inverted or upside down, the first at ({:.9g}, {:.9g}, {:.9g}): "
                            "the surface has details or "
                            "walls smaller than the elements there; take a smaller --size",
                            bad.size(), p.x, p.y, p.z));
  }

  // Each part between features has the group that most of its faces lie on.
  void set_regions(const TriangleSurface& surface, const SurfaceModel& model) {
    Mesh& mesh = result_.mesh;
    const ConstraintTags tags = ConstraintTags::of(mesh);
    const std::vector<std::int32_t>& groups = surface.groups;
    if (std::equal(groups.begin() + 1, groups.end(), groups.begin())) {
      mesh.add_tag<FaceId, std::int32_t>("region", groups.front());
      return;
    }
    auto region = mesh.add_tag<FaceId, std::int32_t>("region", -1);
    std::vector<FaceId> part;
    for (const FaceId first : mesh.faces()) {
      if (!mesh.alive(first) || region[first] >= 0) continue;
      part.assign(1, first);
      region[first] = 0;
      std::map<std::int32_t, std::size_t> votes;
      for (std::size_t i = 0; i < part.size(); ++i) {
        const Vec3 middle =
            0.5 * (mesh.point3(mesh.corner(part[i], 0)) + mesh.point3(mesh.corner(part[i], 2)));
        ++votes[groups[model.nearest({middle, Vec3()}).triangle.value()]];
        for (int k = 0; k < mesh.corner_count(part[i]); ++k) {
          const SideId s(part[i], k);
          const SideId t = mesh.neighbour(s);
          if (tags.constrained(s) || !t.valid() || region[t.face()] >= 0) continue;
          region[t.face()] = 0;
          part.push_back(t.face());
        }
      }
      const auto most = std::max_element(votes.begin(), votes.end(),
                                         [](const auto& a, const auto& b) { return a.second < b.second; });
      for (const FaceId f : part) region[f] = most->first;
    }
  }

  [[nodiscard]] std::int32_t number_of(const CurveNetwork& network, PieceId curve) const {
    const std::int32_t line = network.curves[curve].line;
    return line >= 0 ? line : static_cast<std::int32_t>(result_.lines + curve.value());
  }

  // Edge entities and points that sheets share, in the place of what the kernels work with.
  void finish(const CurveNetwork& network) {
    Mesh& mesh = result_.mesh;
    const ConstraintTags tags = ConstraintTags::of(mesh);
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
        constraint[e] = curve.valid() ? number_of(network, curve) : -1;
        if (!t.valid()) kind[e] = kOuterBoundary;
      }
    }
    auto pinch = mesh.add_tag<VertexId, std::uint8_t>(kPinchTag);
    for (const VertexId v : mesh.vertices())
      if (mesh.alive(v)) pinch[v] = tags.support[v].is_fixed() ? 1 : 0;
    if (!makes_quads()) {
      mesh.remove_tag<FaceId>(kSurfaceGroupTag);
      mesh.remove_tag<VertexId>(kSurfacePointTag);
    }
    mesh.remove_normals();
    mesh.remove_tag<VertexId>("support");
    mesh.remove_tag<FaceId>("constrained_sides");
    compact(mesh, EntityOrder::kHilbert);
  }

  const SurfaceOptions& options_;
  const Progress& progress_;
  StageClock clock_;
  double area_ = 0;  // of the repaired surface
  SurfaceResult result_;
};

}  // namespace

SurfaceResult mesh_surface(const SurfaceOptions& options, const Progress& progress) {
  return SurfaceJob(options, progress).run();
}

}  // namespace quarry
