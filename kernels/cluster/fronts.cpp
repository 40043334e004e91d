#include "kernels/cluster/fronts.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "engine/base/random.hpp"
#include "engine/geometry/segment.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/cluster/pair_measure.hpp"
#include "kernels/local/flip.hpp"
#include "kernels/local/split.hpp"
#include "kernels/quality/element.hpp"

namespace quarry {
namespace {

// An edge named by its ends, which survives what happens around it.
struct EdgeName {
  VertexId a, b;
};

struct NoPlan {};

// Swaps the diagonal of two triangles if both new ones are good enough.
class SwapOperation {
 public:
  using Item = EdgeName;
  using Plan = NoPlan;

  SwapOperation(ConstraintTags tags, double min_quality) : tags_(tags), min_quality_(min_quality) {}

  bool propose(const Mesh& mesh, Item item, Cavity& cavity, Plan&) const {
    const SideId s = mesh.find_side(item.a, item.b);
    if (!s.valid() || !mesh.neighbour(s).valid() || tags_.constrained(s) || !can_flip(mesh, s)) return false;
    const EdgeDiamond diamond = diamond_of(mesh, s);
    const Vec2 a = mesh.point(diamond.a);
    const Vec2 b = mesh.point(diamond.b);
    const Vec2 c = mesh.point(diamond.c);
    const Vec2 d = mesh.point(diamond.d);
    if (std::min(lo_measure(c, a, d), lo_measure(d, b, c)) < min_quality_) return false;
    claim_flip(mesh, s, cavity);
    return true;
  }
  void apply(MeshEditor& editor, Item item, const Plan&, NewIds, FollowUps<Item>&) const {
    flip_edge(editor, tags_, editor.mesh().find_side(item.a, item.b));
  }

 private:
  ConstraintTags tags_;
  double min_quality_;
};

// Halves an edge.
class HalveOperation {
 public:
  using Item = EdgeName;
  struct Plan {
    Vec2 point;
    Support support;
  };

  HalveOperation(ConstraintTags tags, const NodedLines& lines) : tags_(tags), lines_(lines), finder_(lines) {}

  bool propose(const Mesh& mesh, Item item, Cavity& cavity, Plan& plan) const {
    const SideId s = mesh.find_side(item.a, item.b);
    if (!s.valid()) return false;
    plan.point = midpoint(mesh.point(item.a), mesh.point(item.b));
    plan.support = mesh.neighbour(s).valid() ? Support::free() : Support::fixed();
    if (tags_.constrained(s)) {
      const PieceId id = finder_.under_edge(tags_.support[item.a], tags_.support[item.b]);
      const Piece& piece = lines_.pieces[id];
      plan.support = Support::on(id);
      plan.point = closest_point(plan.point, lines_.nodes[piece.from], lines_.nodes[piece.to]);
    }
    if (!can_split_edge(mesh, s, plan.point)) return false;
    claim_split_edge(mesh, s, cavity);
    return true;
  }
  void apply(MeshEditor& editor, Item item, const Plan& plan, NewIds ids, FollowUps<Item>&) const {
    split_edge(editor, tags_, editor.mesh().find_side(item.a, item.b), plan.point, plan.support, ids);
  }

 private:
  ConstraintTags tags_;
  const NodedLines& lines_;
  PieceFinder finder_;
};

class Fronts {
 public:
  Fronts(Mesh& mesh, const NodedLines& lines, const FrontOptions& options)
      : mesh_(mesh), tags_(ConstraintTags::of(mesh)), lines_(lines), options_(options) {}

  void run(FrontReport& report, const Progress& progress) {
    std::vector<EdgeName> front = first_front();
    for (int step = 0; step <= options_.steps && !front.empty(); ++step) {
      if (step == options_.steps) std::erase_if(front, [](EdgeName edge) { return !goes_further(edge); });
      ++report.steps;
      label(front);
      report.splits.add(run_pass(mesh_, HalveOperation(tags_, lines_), front, {}, progress));
      // Midpoints bear no label: next to them lie the triangles just halved.
      labelled_.resize(mesh_.vertex_slots(), 0);
      const std::vector<EdgeName> swapped = edges_to_swap();
      front = edges_opposite_labels();
      report.swaps.add(swap(swapped, front, progress));
    }
  }

 private:
  [[nodiscard]] static bool goes_further(EdgeName edge) {
    const auto [low, high] = std::minmax(edge.a, edge.b);
    return (mix32(low.value() ^ mix32(high.value())) & 1U) != 0;
  }

  // The sides for which keep(side) holds, one a edge, in their order.
  template <class Keep>
  [[nodiscard]] std::vector<EdgeName> edges_where(const Keep& keep) const {
    const auto sides = parallel::filter_indices(mesh_.face_slots() * 4, [&](std::size_t i) {
      const SideId s(static_cast<std::uint32_t>(i));
      if (s.index() == 3 || !mesh_.alive(s.face())) return false;
      const SideId across = mesh_.neighbour(s);
      return (!across.valid() || s < across) && keep(s);
    });
    std::vector<EdgeName> edges(sides.size());
    parallel::for_each(edges.size(), [&](std::size_t i) {
      edges[i] = {mesh_.origin(SideId(sides[i])), mesh_.target(SideId(sides[i]))};
    });
    return edges;
  }

  [[nodiscard]] bool longest_of_both(SideId s) const {
    const SideId across = mesh_.neighbour(s);
    return across.valid() && longest_of_its_face(mesh_, s) && longest_of_its_face(mesh_, across);
  }
  [[nodiscard]] bool labelled(VertexId v) const { return labelled_[v] != 0; }
  [[nodiscard]] bool label_opposite(SideId s) const {
    return labelled(mesh_.origin(mesh_.previous(s))) ||
           labelled(mesh_.origin(mesh_.previous(mesh_.neighbour(s))));
  }

  [[nodiscard]] std::vector<EdgeName> first_front() const {
    return edges_where([&](SideId s) {
      if (!tags_.constrained(s)) return false;
      return longest_of_its_face(mesh_, s) && (!mesh_.neighbour(s).valid() || longest_of_both(s));
    });
  }
  [[nodiscard]] std::vector<EdgeName> edges_opposite_labels() const {
    return edges_where(
        [&](SideId s) { return !tags_.constrained(s) && longest_of_both(s) && label_opposite(s); });
  }
  [[nodiscard]] std::vector<EdgeName> edges_to_swap() const {
    return edges_where([&](SideId s) {
      return !tags_.constrained(s) && longest_of_both(s) && !label_opposite(s) &&
             labelled(mesh_.origin(s)) != labelled(mesh_.target(s));
    });
  }

  // Only what this step labels counts in the next front.
  void label(const std::vector<EdgeName>& front) {
    labelled_.clear();
    labelled_.resize(mesh_.vertex_slots(), 0);
    for (const EdgeName edge : front) labelled_[edge.a] = labelled_[edge.b] = 1;
  }

  // Appends the edges that come out of it to the front.
  PassReport swap(const std::vector<EdgeName>& edges, std::vector<EdgeName>& front,
                  const Progress& progress) {
    std::vector<EdgeName> after;
    for (const EdgeName edge : edges) {
      const EdgeDiamond diamond = diamond_of(mesh_, mesh_.find_side(edge.a, edge.b));
      after.push_back({diamond.c, diamond.d});
    }
    PassReport report = run_pass(mesh_, SwapOperation(tags_, options_.min_quality), edges,
                                 {.window = 16384, .cutoff = 1, .reverse = false}, progress);
    for (const EdgeName edge : after)
      if (mesh_.find_side(edge.a, edge.b).valid() || mesh_.find_side(edge.b, edge.a).valid())
        front.push_back(edge);
    return report;
  }

  Mesh& mesh_;
  ConstraintTags tags_;
  const NodedLines& lines_;
  FrontOptions options_;
  IdVector<VertexId, std::uint8_t> labelled_;
};

}  // namespace

void align_fronts(Mesh& triangles, const NodedLines& lines, const FrontOptions& options, FrontReport& report,
                  const Progress& progress) {
  if (options.steps > 0) Fronts(triangles, lines, options).run(report, progress);
}

}  // namespace quarry
