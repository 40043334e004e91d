#include "pipeline/surface/surface.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "io/lines/line_reader.hpp"
#include "pipeline/report/count_note.hpp"
#include "pipeline/surface/elements.hpp"
#include "pipeline/surface/find_surface_sizes.hpp"
#include "pipeline/surface/finish_surface.hpp"
#include "pipeline/surface/read_surface.hpp"
#include "pipeline/surface/surface_lines.hpp"
#include "pipeline/surface/surface_notes.hpp"
#include "surface/feature/bind.hpp"
#include "surface/join/divide_joins.hpp"
#include "surface/model/surface_model.hpp"
#include "surface/repair/sheets.hpp"

namespace quarry {
namespace {

// Of the points of the surface that elements have to come near to, in sizes.
constexpr double kPointSpacing = 0.5;

// With --count: how often a mesh is made with another size, by how much that changes at once, and what is
// near enough.
constexpr int kMostRounds = 3;
constexpr double kMostScale = 1.4;
constexpr double kCountTolerance = 0.05;

// How often a job is done with ever smaller elements where some were invalid, and from which time on details
// everywhere are less coarse: that may multiply the elements (boot_scan of odedstein/meshes with 9,000 quads:
// 44,000, and 9,200 without). With more invalid ones than that it is no matter of single places.
constexpr int kMostAttempts = 10;
constexpr int kFirstStrict = 4;
constexpr std::size_t kMostInvalid = 24;

// Edges of rims that are kept are long for elements from so many sizes on.
constexpr double kLongKeptRim = 2;
// Beside longer ones than that remeshing makes ever more triangles, none of which is good.
constexpr double kLongestKeptRim = 4;

double longest_outer_edge(const Mesh& mesh) {
  double longest = 0;
  for (const FaceId f : mesh.faces())
    for (int k = 0; k < mesh.corner_count(f); ++k)
      if (const SideId s(f, k); !mesh.neighbour(s).valid())
        longest = std::max(longest, length(mesh.point3(mesh.target(s)) - mesh.point3(mesh.origin(s))));
  return longest;
}

class SurfaceJob {
 public:
  SurfaceJob(const SurfaceOptions& options, SurfaceResult& result, const Progress& progress)
      : options_(options), progress_(progress), clock_(progress), result_(result) {}

  void run() {
    clock_.start("reading");
    TriangleSurface surface = read_surface(options_.inputs, result_.names);
    clock_.start("repairing");
    RepairedSurface repaired = repair_surface(std::move(surface), options_.repair);
    result_.repaired = repaired.surface;
    result_.repair = repaired.report;
    if (!options_.lines.empty()) result_.lines = read_lines(options_.lines);
    if (options_.repair.weld == 0) add(crack_note(repaired));
    find_size(repaired.surface);
    meet_count(repaired);
    add(count_note(options_.count, result_.mesh, "features and details"));
    clock_.stop();
    result_.times = clock_.times();
  }

 private:
  // Elements along features, rims and details take up another area than that of their size: with a wanted
  // count the size is mended, and the mesh that comes nearest is kept. Not where single places asked for
  // more: those count beyond it.
  void meet_count(const RepairedSurface& repaired) {
    const std::vector<std::string> notes = result_.notes;
    const auto miss = [&] {
      return std::abs(static_cast<double>(result_.mesh.count_alive_faces()) / *options_.count - 1);
    };
    mesh_by_method(repaired);
    for (int round = 1; options_.count && tight_.empty() && round < kMostRounds && miss() > kCountTolerance;
         ++round) {
      const double before = miss();
      const double ratio = static_cast<double>(result_.mesh.count_alive_faces()) / *options_.count;
      SurfaceResult last = std::exchange(result_, {});
      result_.names = last.names;
      result_.repaired = std::move(last.repaired);
      result_.repair = last.repair;
      result_.lines = std::move(last.lines);
      result_.notes = notes;
      result_.size = last.size * std::clamp(std::sqrt(ratio), 1 / kMostScale, kMostScale);
      if (meshes_by_method(repaired) && miss() < before) continue;
      last.repaired = std::move(result_.repaired);
      last.lines = std::move(result_.lines);
      result_ = std::move(last);
      return;
    }
  }

  // False where that cannot be had with the size of the result.
  bool meshes_by_method(const RepairedSurface& repaired) {
    try {
      mesh_by_method(repaired);
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::kGeometry) throw;
      return false;
    }
    return true;
  }

  void mesh_by_method(const RepairedSurface& repaired) {
    choose_method();
    if (result_.method == SurfaceQuads::kCluster || !follow_wish(repaired)) mesh_validly(repaired);
    add(limit_note(limited_));
  }

  void add(const std::optional<std::string>& note) {
    if (note) result_.notes.push_back(*note);
  }

  // False, with a note why, if quads have to be made as clusters, as if nothing else had been tried.
  bool follow_wish(const RepairedSurface& repaired) {
    try {
      if (mesh_validly(repaired)) return true;
      note_clusters("features or walls lie nearer to one another than two elements in many places");
    } catch (const Error& error) {
      // Clusters would halve the edges of rims.
      if (error.kind() != ErrorKind::kGeometry || options_.keep_boundary) throw;
      note_clusters(result_.method == SurfaceQuads::kField
                        ? "a lattice leaves elements inverted or upside down"
                        : "matching leaves elements inverted or upside down");
    }
    result_.method = SurfaceQuads::kCluster;
    return false;
  }
  void note_clusters(const char* why) {
    result_.notes.push_back(std::string(why) + ": quads are made as by --quads cluster");
  }

  // By the method of the result; false if that cannot be had. Where elements come out inverted or upside down
  // it is done anew with smaller ones there, and at last with less coarse ones at all details: they were too
  // large for them.
  bool mesh_validly(const RepairedSurface& repaired) {
    tight_.clear();
    strictness_ = 1;
    for (int attempt = 1;; ++attempt) {
      ElementsMade made = mesh(repaired);
      if (made == ElementsMade::kSurfaceLost) made = mesh(repaired);
      if (made == ElementsMade::kTooManyCells) return false;
      if (invalid_.empty()) break;
      // Beside edges of rims that stay as long as they are, smaller elements are no help.
      if (attempt == kMostAttempts || invalid_.size() > kMostInvalid || kept_rim_ > 0)
        throw Error(ErrorKind::kGeometry, invalid_note(invalid_, kept_rim_));
      tight_.insert(tight_.end(), invalid_.begin(), invalid_.end());
      if (attempt >= kFirstStrict) strictness_ *= 2;
    }
    if (!tight_.empty())
      result_.notes.push_back(fmt::format(
          "elements are smaller at {} places where some had been inverted or upside down", tight_.size()));
    return true;
  }

  // Where faces are invalid, and half the edge that they began with.
  void find_invalid(const SurfaceModel& model, const SurfaceSizes& sizes) {
    invalid_.clear();
    const Mesh& mesh = result_.mesh;
    for (const FaceId f : find_invalid_on_surface(mesh, model, area_)) {
      const Vec3 p = 0.5 * (mesh.point3(mesh.corner(f, 0)) + mesh.point3(mesh.corner(f, 2)));
      invalid_.push_back({p, 0.5 * sizes.at(model.nearest({p, Vec3()}))});
    }
  }

  // By the method of the result, with smaller elements at tight places and where the first remeshing of all
  // lost the surface; tells which ones are invalid.
  ElementsMade mesh(RepairedSurface repaired) {
    const double edge = first_edge(options_.elements, result_.method) * result_.size;
    FeatureOptions features = options_.features;
    features.size = edge;
    const std::vector<LineEdge> lines = divide_curves(repaired, features);
    clock_.start("finding features");
    const FeatureEdges found = find_feature_edges(repaired, features, lines);
    const CurveNetwork network = make_curve_network(repaired.surface, found.edges, features);
    count(found, network);
    Mesh& elements = result_.mesh;
    elements = make_sheets(repaired);
    const ConstraintTags tags = bind_features(elements, network);
    if (options_.keep_boundary) {
      fix_rims(elements, tags);
      const double longest = longest_outer_edge(elements);
      if (longest > kLongestKeptRim * result_.size) throw Error(ErrorKind::kGeometry, kept_rim_note(longest));
      kept_rim_ = longest > kLongKeptRim * result_.size ? longest : 0;
    }
    const SurfaceModel model(elements, tags, kPointSpacing * result_.size);
    clock_.start("finding sizes");
    SizeDemands demands{.edge = edge, .size = result_.size, .area = area_, .tight = tight_};
    demands.tight.insert(demands.tight.end(), lost_.begin(), lost_.end());
    demands.most_lenient /= strictness_;
    const SurfaceSizes sizes = find_surface_sizes(elements, options_, demands, progress_);
    limited_ = sizes.limited();
    limited_.smallest *= result_.size / edge;
    const bool first = !std::exchange(looked_for_lost_, true);
    const ElementsMade made = make_elements({model, network, sizes, area_}, options_, result_,
                                            first ? &lost_ : nullptr, clock_, progress_);
    if (made != ElementsMade::kAll) return made;
    clock_.start("finishing");
    find_invalid(model, sizes);
    if (!invalid_.empty()) return ElementsMade::kAll;
    set_surface_regions(elements, repaired.surface.groups, model);
    finish_surface_mesh(elements, network, [&](PieceId curve, bool) {
      return std::vector<std::int32_t>{curve.valid() ? number_of(network, curve) : -1};
    });
    return ElementsMade::kAll;
  }

  // What sheets share gets its edges, and lines theirs, which are returned. Nothing but halving would make
  // sheets even that end in joins alone, and no sheet may do so on its own: for a matching joins are made
  // twice as long and halved.
  [[nodiscard]] std::vector<LineEdge> divide_curves(RepairedSurface& repaired,
                                                    const FeatureOptions& features) {
    const double edge = features.size;
    const bool halved = makes_quads() && result_.method == SurfaceQuads::kMatching;
    divide_joins(repaired, {.edge = join_edge(options_.elements, result_.method) * result_.size,
                            .deviation = RemeshOptions().feature_deviation * edge,
                            .corners = features});
    if (!options_.lines.empty()) clock_.start("imprinting lines");
    std::vector<LineEdge> lines = imprint_input(repaired, options_, result_);
    if (halved) halve_joins(repaired);
    return lines;
  }

  // Curves that are part of no line are numbered behind the lines.
  [[nodiscard]] std::int32_t number_of(const CurveNetwork& network, PieceId curve) const {
    const std::int32_t line = network.curves[curve].line;
    return line >= 0 ? line : static_cast<std::int32_t>(result_.lines.lines.size() + curve.value());
  }

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

  void choose_method() { result_.method = makes_quads() ? options_.method : SurfaceQuads::kCluster; }

  const SurfaceOptions& options_;
  const Progress& progress_;
  StageClock clock_;
  double area_ = 0;  // of the repaired surface
  // Of an attempt: how much less lenient it is than the first one, where elements are to be smaller, and
  // where they came out invalid.
  double strictness_ = 1;
  std::vector<TightPlace> tight_, invalid_;
  std::vector<TightPlace> lost_;  // what the first remeshing of all lost, for all that follow
  bool looked_for_lost_ = false;
  double kept_rim_ = 0;  // as for invalid_note
  SurfaceSizes::Limited limited_;
  SurfaceResult& result_;
};

}  // namespace

const char* name_of(SurfaceQuads method) {
  if (method == SurfaceQuads::kMatching) return "matching";
  return method == SurfaceQuads::kField ? "field" : "cluster";
}

void mesh_surface(const SurfaceOptions& options, SurfaceResult& result, const Progress& progress) {
  SurfaceJob(options, result, progress).run();
}

SurfaceResult mesh_surface(const SurfaceOptions& options, const Progress& progress) {
  SurfaceResult result;
  mesh_surface(options, result, progress);
  return result;
}

}  // namespace quarry
