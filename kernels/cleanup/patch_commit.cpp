#include "kernels/cleanup/patch_commit.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <memory>

#include "kernels/cleanup/model_face.hpp"
#include "kernels/cleanup/patch_placement.hpp"

namespace quarry {
namespace {

constexpr int kMostSweeps = 256;
// More sweeps only where the first ones have come within this share of what is wanted: of the fills that are
// farther off one in a hundred gets there, at the price of most of the work. And only as long as such a share
// of what is missing comes with each round.
constexpr double kHopeful = 0.8;
constexpr double kLeastProgress = 0.25;
// Fills are looked at after so many sweeps, and given up where edges are then more unequal than may be by
// this factor: one in sixty would become good.
constexpr int kFirstSweeps = 2;
constexpr double kHopelessRatio = 1.75;

}  // namespace

template <GeometryModel Model>
struct PatchCommit<Model>::Worker {
  explicit Worker(const Model& model) : smoother(model) {}

  FaceReplacer replacer;
  LocalSmoother<Model> smoother;
  PatchLayout layout;
  LayoutNeighbours neighbours;
  std::vector<bool> on_line;            // by local number: inside on a line
  std::vector<Point> points;            // by local number
  std::vector<VertexId> vertices;       // by local number
  std::vector<FaceCorners> fresh, old;  // corners
  std::vector<Point> old_places;        // of the inner vertices, then of the rim
  std::vector<VertexId> movable;
  std::vector<FaceId> slots;
  std::vector<Support> old_supports;    // of the inner vertices, if there are lines
  std::vector<std::uint8_t> old_sides;  // constraint bits of the faces, if there are lines
  StampedMap<char> line_sides;          // by local numbers
};

template <GeometryModel Model>
PatchCommit<Model>::PatchCommit(const Mesh& mesh, const Model& model, const PatchOptions& options,
                                PatchStars& stars, PatchMemory& memory,
                                std::span<const PatchProposal> proposals)
    : model_(&model),
      options_(&options),
      stars_(&stars),
      memory_(&memory),
      proposals_(proposals),
      tags_(ConstraintTags::of(mesh)),
      outcomes_(proposals.size(), PatchOutcome::kWon),
      workers_([&model] { return std::make_unique<Worker>(model); }) {}

template <GeometryModel Model>
PatchCommit<Model>::~PatchCommit() = default;

template <GeometryModel Model>
bool PatchCommit<Model>::propose(const Mesh& /*mesh*/, Item item, Cavity& cavity, Plan& /*plan*/) const {
  const PatchProposal& proposal = proposals_[item];
  for (const auto* vertices : {&proposal.rim, &proposal.inner, &proposal.ring})
    for (const VertexId v : *vertices) cavity.claim(v);
  // A fill of the same rim has as many vertices more as it has faces more.
  const auto before = static_cast<std::uint32_t>(proposal.faces.size());
  const std::uint32_t more = proposal.fresh_faces > before ? proposal.fresh_faces - before : 0;
  cavity.will_create(more, more);
  return true;
}

template <GeometryModel Model>
void PatchCommit<Model>::apply(MeshEditor& editor, Item item, const Plan& /*plan*/, NewIds ids,
                               FollowUps<Item>& /*follow_ups*/) const {
  const PatchProposal& proposal = proposals_[item];
  const typename ScratchPool<Worker>::Loan worker(workers_);
  const double before = smallest_before(editor, proposal);
  const double ratio =
      std::max(options_->largest_edge_ratio, largest_edge_ratio(editor.mesh(), proposal.faces));
  const double least_mean = mean_quality(editor.mesh(), proposal.faces) - options_->most_mean_loss;
  const double longest = longest_allowed(editor.mesh(), proposal.faces);
  const double energy = energy_of(editor.mesh(), proposal.inner) + energy_of(editor.mesh(), proposal.rim);
  save(editor, proposal, *worker);
  place(editor, proposal, ids, *worker);
  const std::span<const FaceId> made =
      worker->replacer.replace(editor, tags_, proposal.faces, worker->fresh, ids);
  if (!proposal.lines.empty())
    tag_traces(editor, tags_, worker->layout, proposal.lines, made, worker->line_sides);
  const double wanted = std::min(options_->least_jacobian, before);
  const double after = smallest_after(editor, made, wanted, ratio, *worker);
  const bool good = after > 0 && after >= wanted && mean_quality(editor.mesh(), made) >= least_mean &&
                    largest_edge_ratio(editor.mesh(), made) <= ratio &&
                    (options_->longest_edge == 0 || longest_edge(editor.mesh(), made) <= longest);
  if (good)
    for (const VertexId v : worker->vertices) stars_->update(editor.mesh(), v);
  const bool gains = good && energy_of(editor.mesh(), worker->vertices) < energy;
  outcomes_[item] = gains ? PatchOutcome::kWon : (good ? PatchOutcome::kNoGain : PatchOutcome::kQuality);
  if (gains) {
    memory_->renew(editor.mesh(), made, proposal.rim, proposal.key);
  } else {
    // Every face gets its old number: other proposals name it.
    worker->slots = proposal.faces;
    for (std::size_t i = proposal.faces.size(); i < made.size(); ++i) worker->slots.push_back(made[i]);
    worker->replacer.replace(editor, tags_, worker->slots, worker->old, ids);
    restore(editor, proposal, *worker);
  }
  // Old inner vertices may be gone.
  const auto update = [&](VertexId v) { stars_->update(editor.mesh(), v); };
  std::for_each(proposal.inner.begin(), proposal.inner.end(), update);
  std::for_each(worker->vertices.begin(), worker->vertices.end(), update);
}

template <GeometryModel Model>
void PatchCommit<Model>::save(const MeshEditor& editor, const PatchProposal& proposal, Worker& worker) const {
  worker.old.clear();
  for (const FaceId f : proposal.faces)
    worker.old.push_back(
        {editor.corner(f, 0), editor.corner(f, 1), editor.corner(f, 2), editor.corner(f, 3)});
  worker.old_places.clear();
  for (const auto* vertices : {&proposal.inner, &proposal.rim})
    for (const VertexId v : *vertices) worker.old_places.push_back(place_of<Point>(editor, v));
  if (proposal.lines.empty()) return;
  worker.old_sides.clear();
  for (const FaceId f : proposal.faces) worker.old_sides.push_back(tags_.sides[f]);
  worker.old_supports.clear();
  for (const VertexId v : proposal.inner) worker.old_supports.push_back(editor.get(tags_.support, v));
}

template <GeometryModel Model>
void PatchCommit<Model>::restore(MeshEditor& editor, const PatchProposal& proposal,
                                 const Worker& worker) const {
  std::size_t i = 0;
  for (const auto* vertices : {&proposal.inner, &proposal.rim})
    for (const VertexId v : *vertices) set_place(editor, v, worker.old_places[i++]);
  if (proposal.lines.empty()) return;
  for (std::size_t k = 0; k < proposal.faces.size(); ++k)
    editor.set(tags_.sides, proposal.faces[k], worker.old_sides[k]);
  for (std::size_t k = 0; k < proposal.inner.size(); ++k)
    editor.set(tags_.support, proposal.inner[k], worker.old_supports[k]);
}

// Names and places the vertices of the fill, and writes down its faces.
template <GeometryModel Model>
void PatchCommit<Model>::place(MeshEditor& editor, const PatchProposal& proposal, NewIds& ids,
                               Worker& worker) const {
  worker.layout.build(proposal.fill, static_cast<std::uint32_t>(proposal.rim.size()), proposal.cuts,
                      proposal.sides.corner_places());
  place_points(editor, proposal, worker);
  name_vertices(proposal, ids, worker);
  worker.movable.clear();
  for (std::uint32_t i = worker.layout.rim(); i < worker.layout.vertices(); ++i) {
    if (!worker.on_line[i]) worker.movable.push_back(worker.vertices[i]);
    set_place(editor, worker.vertices[i], model_->project(worker.points[i]));
  }
  if (!proposal.lines.empty()) bind_vertices(editor, proposal, worker);
  for (const VertexId v : proposal.rim)
    if (stars_->movable(v)) worker.movable.push_back(v);
  worker.fresh.clear();
  for (const PatchLayout::Quad& quad : worker.layout.quads())
    worker.fresh.push_back({worker.vertices[quad[0]], worker.vertices[quad[1]], worker.vertices[quad[2]],
                            worker.vertices[quad[3]]});
}

// Nodes keep their numbers; the others take those of the inner vertices in turn, then new ones.
template <GeometryModel Model>
void PatchCommit<Model>::name_vertices(const PatchProposal& proposal, NewIds& ids, Worker& worker) const {
  worker.vertices = proposal.rim;
  worker.vertices.resize(worker.layout.vertices());
  for (const PatchNode& node : proposal.nodes) worker.vertices[node.place] = node.vertex;
  const auto is_node = [&](VertexId v) {
    return std::any_of(proposal.nodes.begin(), proposal.nodes.end(),
                       [&](const PatchNode& node) { return node.vertex == v; });
  };
  auto unused = proposal.inner.begin();
  for (std::size_t i = worker.layout.rim(); i < worker.vertices.size(); ++i) {
    VertexId& v = worker.vertices[i];
    if (v.valid()) continue;
    while (unused != proposal.inner.end() && is_node(*unused)) ++unused;
    v = unused != proposal.inner.end() ? *unused++ : ids.take_vertex();
  }
}

// Lines are straight between the ends of their traces, with vertices evenly on them that stay there: the
// sweeps over the mesh slide them.
template <GeometryModel Model>
void PatchCommit<Model>::place_points(const MeshEditor& editor, const PatchProposal& proposal,
                                      Worker& worker) const {
  worker.points.clear();
  for (const VertexId v : proposal.rim) worker.points.push_back(place_of<Point>(editor, v));
  place_layout(worker.layout, worker.points);
  worker.on_line.assign(worker.layout.vertices(), false);
  for (const PatchNode& node : proposal.nodes)
    worker.points[node.place] = place_of<Point>(editor, node.vertex);
  for (const PatchLine& line : proposal.lines) {
    detail::place_line(line.trace, worker.points);
    for (const std::uint32_t v : line.trace) worker.on_line[v] = v >= worker.layout.rim();
  }
  if (worker.layout.quads().size() > options_->harmonic_from)
    relax_layout(worker.layout, worker.on_line, worker.points, worker.neighbours);
}

// The numbers of vertices that were on lines may be those of free ones now.
template <GeometryModel Model>
void PatchCommit<Model>::bind_vertices(MeshEditor& editor, const PatchProposal& proposal,
                                       const Worker& worker) const {
  for (std::size_t i = worker.layout.rim(); i < worker.vertices.size(); ++i)
    if (!editor.get(tags_.support, worker.vertices[i]).is_node())
      editor.set(tags_.support, worker.vertices[i], Support::free());
  for (const PatchLine& line : proposal.lines)
    for (std::size_t i = 1; i + 1 < line.trace.size(); ++i)
      editor.set(tags_.support, worker.vertices[line.trace[i]], line.support);
}

template <GeometryModel Model>
double PatchCommit<Model>::smallest_before(const MeshEditor& editor, const PatchProposal& proposal) const {
  double smallest = 1;
  for (const FaceId f : proposal.faces)
    smallest = std::min(smallest, signed_scaled_jacobian(editor.mesh(), *model_, f));
  // Faces around the rim are moved as well. Those of the patch are met twice, which changes no minimum.
  for (const VertexId v : proposal.rim) {
    if (!stars_->movable(v)) continue;
    for_each_side_around(editor.mesh(), v, [&](SideId s) {
      smallest = std::min(smallest, signed_scaled_jacobian(editor.mesh(), *model_, s.face()));
    });
  }
  return smallest;
}

template <GeometryModel Model>
double PatchCommit<Model>::smallest_after(MeshEditor& editor, std::span<const FaceId> made, double wanted,
                                          double ratio, Worker& worker) const {
  double smallest = 1;
  // The smoother does not look at faces that it cannot change.
  const auto moves = [&](VertexId v) {
    return !editor.mesh().on_boundary(v) && editor.get(tags_.support, v).is_free();
  };
  for (const FaceId f : made) {
    bool frozen = true;
    for (int k = 0; k < 4; ++k) frozen = frozen && !moves(editor.corner(f, k));
    if (frozen) smallest = std::min(smallest, signed_scaled_jacobian(editor.mesh(), *model_, f));
  }
  if (!(smallest > 0) || worker.movable.empty()) return smallest;
  // A sweep carries a change over one row: wide patches get more of them if they need them.
  const int rows = static_cast<int>(std::sqrt(static_cast<double>(made.size())));
  LocalShapeOptions smoothing = options_->smoothing;
  const int sweeps = smoothing.sweeps;
  const int most = std::min(3 * rows, kMostSweeps);
  const auto smooth = [&](int more) {
    smoothing.sweeps = more;
    return worker.smoother.run(editor, worker.movable, smoothing);
  };
  const int first = std::min(kFirstSweeps, sweeps);
  double smoothed = smooth(first);
  if (!(smoothed > 0) || largest_edge_ratio(editor.mesh(), made) > kHopelessRatio * ratio) return 0;
  if (sweeps > first) smoothed = smooth(sweeps - first);
  for (int spent = sweeps; smoothed < wanted && smoothed > kHopeful * wanted && spent < most;) {
    const double before = smoothed;
    const int more = std::min(spent, most - spent);
    smoothed = smooth(more);
    if (smoothed - before < kLeastProgress * (wanted - before)) break;
    spent += more;
  }
  return std::min(smallest, smoothed);
}

template <GeometryModel Model>
double PatchCommit<Model>::mean_quality(const Mesh& mesh, std::span<const FaceId> faces) const {
  double sum = 0;
  for (const FaceId f : faces) sum += signed_scaled_jacobian(mesh, *model_, f);
  return sum / static_cast<double>(faces.size());
}

template <GeometryModel Model>
double PatchCommit<Model>::largest_edge_ratio(const Mesh& mesh, std::span<const FaceId> faces) const {
  double largest = 1;
  for (const FaceId f : faces) largest = std::max(largest, edge_ratio<Model>(mesh, f));
  return largest;
}

template <GeometryModel Model>
double PatchCommit<Model>::longest_edge(const Mesh& mesh, std::span<const FaceId> faces) const {
  double longest = 0;
  for (const FaceId f : faces)
    for (int k = 0; k < mesh.corner_count(f); ++k)
      longest = std::max(longest, length(mesh.point3(mesh.corner(f, (k + 1) % mesh.corner_count(f))) -
                                         mesh.point3(mesh.corner(f, k))));
  return longest;
}

template <GeometryModel Model>
double PatchCommit<Model>::longest_allowed(const Mesh& mesh, std::span<const FaceId> faces) const {
  if (options_->longest_edge == 0) return 0;
  double area = 0;
  for (const FaceId f : faces) {
    const auto corner = [&](int k) { return mesh.point3(mesh.corner(f, k)); };
    area += mesh.corner_count(f) == 4 ? 0.5 * length(cross(corner(2) - corner(0), corner(3) - corner(1)))
                                      : 0.5 * length(cross(corner(1) - corner(0), corner(2) - corner(0)));
  }
  return std::max(options_->longest_edge * std::sqrt(area / static_cast<double>(faces.size())),
                  longest_edge(mesh, faces));
}

template <GeometryModel Model>
double PatchCommit<Model>::energy_of(const Mesh& mesh, std::span<const VertexId> vertices) const {
  double energy = 0;
  for (const VertexId v : vertices) energy += stars_->energy(mesh, v);
  return energy;
}

template class PatchCommit<PlaneModel>;
template class PatchCommit<SpaceModel>;

}  // namespace quarry
