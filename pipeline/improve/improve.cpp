#include "pipeline/improve/improve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "engine/base/heap.hpp"
#include "engine/mesh/compact.hpp"
#include "engine/mesh/validate.hpp"
#include "io/mesh/mesh_format.hpp"
#include "kernels/field/size_field.hpp"
#include "kernels/smooth/optimise.hpp"
#include "kernels/smooth/optimise_shape.hpp"
#include "kernels/smooth/square_corners.hpp"
#include "pipeline/improve/clean_up_floor.hpp"
#include "pipeline/improve/group_labels.hpp"
#include "pipeline/improve/improve_notes.hpp"
#include "pipeline/improve/improve_surface.hpp"
#include "pipeline/improve/input_size.hpp"
#include "pipeline/improve/tagged_lines.hpp"
#include "pipeline/improve/untangle.hpp"
#include "pipeline/section/price_source.hpp"

namespace quarry {
namespace {

// At most; they end when nothing moves any more.
constexpr int kShapeSweeps = 30;
constexpr int kCornerSweeps = 20;
// What areas count beside angles: twice as much as in a mesh of quarry's own, since those of other programs
// are more even than what clean-up makes of them.
constexpr double kEvenness = 0.5;

void require_usable(const ImproveOptions& options) {
  if (options.size && !(*options.size > 0 && std::isfinite(*options.size)))
    throw Error(ErrorKind::kUsage,
                fmt::format("--size is {}: it must be a length above 0 in input units", *options.size));
  if (options.tolerance && !(*options.tolerance >= 0 && std::isfinite(*options.tolerance)))
    throw Error(ErrorKind::kUsage,
                fmt::format("--tolerance is {}: it must be a length of 0 or more in input units",
                            *options.tolerance));
}

// Points of no face do not count.
bool is_planar(const ReadCells& cells) {
  return std::all_of(cells.faces.begin(), cells.faces.end(), [&](const FaceCorners& face) {
    return std::all_of(face.begin(), face.end(), [&](VertexId v) {
      return !v.valid() || v.value() >= cells.z.size() || cells.z[v.value()] == 0;
    });
  });
}

std::string place_of(const Mesh& mesh, FaceId face) {
  const Vec2 p = mesh.point(mesh.corner(face, 0));
  return format_point(p.x, p.y);
}

// A vertex that rounds within the digits of the file still lies on its line.
double tolerance_of(const ImproveOptions& options, const Box2& box) {
  if (options.tolerance) return *options.tolerance;
  const double largest =
      std::max({std::abs(box.low.x), std::abs(box.low.y), std::abs(box.high.x), std::abs(box.high.y)});
  return std::max(1e-9 * box.longer_side(), 4 * std::numeric_limits<double>::epsilon() * largest);
}

using Lengths = std::map<std::int32_t, double>;

// The length that the edges of each number have together.
Lengths lengths_of_pieces(const TaggedLines& tagged, const Mesh& mesh) {
  Lengths lengths;
  const NodedLines& lines = tagged.lines;
  for (const PieceId p : IdRange<PieceId>(lines.pieces.size()))
    for (const std::int32_t number : tagged.numbers_of(p))
      lengths[number] += distance(lines.nodes[lines.pieces[p].from], lines.nodes[lines.pieces[p].to]);
  const auto constraint = mesh.find_tag<EdgeId, std::int32_t>("constraint");
  for (const EdgeId e : mesh.edges()) {
    const auto [a, b] = mesh.edge_ends(e);
    lengths[constraint[e]] += distance(mesh.point(a), mesh.point(b));
  }
  return lengths;
}

// The boundary without a number counts as no line.
Lengths lengths_of_edges(const Mesh& mesh) {
  Lengths lengths;
  const auto constraint = mesh.find_tag<EdgeId, std::int32_t>("constraint");
  const auto kind = mesh.find_tag<EdgeId, std::int32_t>("kind");
  for (const EdgeId e : mesh.edges()) {
    const auto [a, b] = mesh.edge_ends(e);
    if (constraint[e] >= 0 || kind[e] != kOuterBoundary)
      lengths[constraint[e]] += distance(mesh.point(a), mesh.point(b));
  }
  return lengths;
}

class ImproveJob {
 public:
  ImproveJob(const ImproveOptions& options, StageClock& clock, const Progress& progress)
      : options_(options), progress_(progress), clock_(clock), prices_(options.irregular_price) {}

  ImproveResult run(ReadCells cells) {
    take(std::move(cells));
    clock_.start("binding");
    lines_ = bind_lines(result_.mesh, tagged_, result_.tolerance);
    lengths_ = lengths_of_pieces(lines_, result_.mesh);
    if (lines_.apart > 0) result_.notes.push_back(edges_apart_note(options_.input, lines_.apart));
    result_.nodes = lines_.lines.nodes.size();
    result_.pieces = lines_.lines.pieces.size();
    clock_.start("untangling");
    untangle_faces();
    find_size();
    clock_.start("clean-up");
    clean_up_quads();
    clock_.start("smoothing");
    smooth();
    clock_.start("finishing");
    finish();
    clock_.stop();
    result_.times = clock_.times();
    return std::move(result_);
  }

 private:
  void take(ReadCells cells) {
    result_.turned = turn_counterclockwise(options_.input, cells);
    if (result_.turned > 0)
      result_.notes.push_back(fmt::format("{}: {} of {} faces were clockwise and are turned", options_.input,
                                          result_.turned, cells.faces.size()));
    result_.names = cells.names;
    result_.before = summarize_quality(make_mesh(options_.input, cells));
    if (result_.before.quads.faces == 0) result_.notes.push_back(no_quads_note(options_.input));
    labels_ = GroupLabels(cells);
    result_.groups = labels_.groups();
    make_bare_mesh(std::move(cells));
    result_.tolerance = tolerance_of(options_, result_.mesh.box());
    const std::vector<std::uint32_t> invalid = invalid_faces(result_.mesh);
    result_.invalid = invalid.size();
    if (!invalid.empty())
      result_.notes.push_back(invalid_faces_note(options_.input, invalid.size(),
                                                 place_of(result_.mesh, FaceId(invalid.front()))));
  }

  // Tagged edges are plain pairs of vertices while the mesh is worked on.
  void make_bare_mesh(ReadCells cells) {
    const auto edges = std::exchange(cells.edges, {});
    const auto numbers = std::exchange(cells.constraints, {});
    cells.kinds.clear();
    Mesh& mesh = result_.mesh;
    mesh = make_mesh(options_.input, std::move(cells));
    mesh.remove_tag<EdgeId>("constraint");
    mesh.remove_tag<EdgeId>("kind");
    const std::size_t slots = mesh.vertex_slots();
    const Renumbering renumbering = compact(mesh, EntityOrder::kHilbert);
    std::vector<VertexId> vertex(slots);
    for (std::size_t i = 0; i < renumbering.old_vertex.size(); ++i)
      vertex[renumbering.old_vertex[i]] = VertexId(i);
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const TaggedEdge edge{vertex[edges[i].first.value()], vertex[edges[i].second.value()], numbers[i]};
      if (edge.a.valid() && edge.b.valid() && edge.a != edge.b)
        tagged_.push_back(edge);
      else
        ++lost_;
    }
    result_.tagged_edges = tagged_.size();
    if (lost_ > 0) result_.notes.push_back(lost_lines_note(options_.input, lost_));
  }

  // Clean-up compares shapes, which says little about faces that are turned over.
  void untangle_faces() {
    if (result_.invalid > 0) untangle(result_.mesh, lines_.lines, progress_);
  }

  // Sizes that drift with each change of the topology would end anywhere.
  void find_size() {
    if (options_.size)
      size_ = std::make_unique<UniformSize>(*options_.size);
    else
      size_ = std::make_unique<InputSize>(result_.mesh);
  }

  void clean_up_quads() {
    CleanUpOptions options;
    options.level = options_.cleanup;
    const double floor = clean_up_floor(result_.before, options.patches.least_jacobian);
    options.local.price = options.patches.price = prices_.price(lines_.lines);
    options.local.floor = floor;
    options.patches.least_jacobian = floor;
    options.size = size_.get();
    // They would take a tenth of the faces, for as many irregular vertices: quads of other tools are not
    // halved ones, in which opposite charges lie two steps apart.
    options.chords.most_rounds = 0;
    // That is what smooth() does, with and without clean-up.
    options.square_corners.rounds_together = options.square_corners.sweeps = 0;
    give_back_freed_memory();
    clean_up(result_.mesh, lines_.lines, options, result_.clean_up, progress_);
  }

  void smooth() {
    ShapeOptions shape;
    shape.sweeps = kShapeSweeps;
    shape.size = size_.get();
    result_.smoothing = optimise_shape(result_.mesh, lines_.lines, shape, progress_);
    SquareCornersOptions squaring = CleanUpOptions().square_corners;
    squaring.size = size_.get();
    squaring.evenness = kEvenness;
    result_.squaring = square_corners(result_.mesh, lines_.lines, squaring, progress_);
    OptimiseOptions worst;
    worst.sweeps = kCornerSweeps;
    worst.target = 0.9;
    result_.corners = optimise_corners(result_.mesh, lines_.lines, worst, progress_);
  }

  void finish() {
    Mesh& mesh = result_.mesh;
    if (options_.mixed_quality) result_.low_quads = cut_low_quads(mesh, {.quality = *options_.mixed_quality});
    restore_groups(mesh, lines_);
    compact(mesh, EntityOrder::kHilbert);
    require_valid();
    require_lines_kept();
    labels_.restore(mesh);
  }

  void require_valid() const {
    const std::vector<std::uint32_t> invalid = invalid_faces(result_.mesh);
    if (!invalid.empty())
      throw Error(
          ErrorKind::kGeometry,
          fmt::format("{}: {} faces cannot be made valid within the lines around them, the first at {}; "
                      "nothing was written",
                      options_.input, invalid.size(), place_of(result_.mesh, FaceId(invalid.front()))));
    const std::string failure = validate(result_.mesh, GeometryCheck::kPlanarCorners);
    if (!failure.empty()) throw Error(ErrorKind::kBug, "the improved mesh is not valid: " + failure);
  }

  // Each number's edges cover what they covered before.
  void require_lines_kept() const {
    const Lengths now = lengths_of_edges(result_.mesh);
    const auto edges = static_cast<double>(result_.mesh.edge_slots());
    const double slack = 1e-6 * result_.mesh.box().longer_side() + 2 * result_.tolerance * edges;
    for (const auto& [number, length] : lengths_) {
      const auto found = now.find(number);
      const double kept = found == now.end() ? 0 : found->second;
      if (std::abs(kept - length) > slack)
        throw Error(ErrorKind::kBug, fmt::format("tagged edges {} had a length of {} and have {} now",
                                                 labels_.constraint(number), length, kept));
    }
  }

  const ImproveOptions& options_;
  const Progress& progress_;
  StageClock& clock_;
  PriceSource prices_;
  ImproveResult result_;
  std::vector<TaggedEdge> tagged_;
  TaggedLines lines_;
  GroupLabels labels_;
  std::unique_ptr<SizeField> size_;
  Lengths lengths_;
  std::size_t lost_ = 0;
};

}  // namespace

ImproveResult improve_mesh(const ImproveOptions& options, const Progress& progress) {
  require_usable(options);
  StageClock clock(progress);
  clock.start("reading");
  ReadCells cells = read_cells(options.input);
  if (cells.faces.empty())
    throw Error(ErrorKind::kGeometry, fmt::format("{}: the mesh has no face to improve", options.input));
  if (!is_planar(cells)) return improve_surface(options, std::move(cells), clock, progress);
  if (options.sharp_degrees)
    throw Error(ErrorKind::kUsage,
                fmt::format("{}: --sharp is for meshes in space, and this one is planar; leave it out",
                            options.input));
  std::fill(cells.z.begin(), cells.z.end(), 0.0);  // those of points of no face too
  return ImproveJob(options, clock, progress).run(std::move(cells));
}

}  // namespace quarry
