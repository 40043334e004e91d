#include "kernels/cleanup/patch_strands.hpp"

#include <algorithm>

namespace quarry {

bool PatchStrands::find(const Mesh& mesh, const PatchStars& stars, const PatchGrowth& growth,
                        std::span<const VertexId> rim) {
  mesh_ = &mesh;
  stars_ = &stars;
  growth_ = &growth;
  rim_ = rim;
  strands_.clear();
  stops_.clear();
  nodes_.clear();
  arms_.clear();
  node_of_.clear(growth.vertices().size());
  inner_ = 0;
  for (std::uint32_t i = 0; i < rim.size(); ++i) {
    if (!stars.on_line(rim[i])) continue;
    const bool known =
        std::any_of(strands_.begin(), strands_.end(), [&](const Strand& strand) { return strand.to == i; });
    if (known) continue;
    // One line enters at most: the growth of the patch sees to it.
    SideId entering;
    for_each_side_around(mesh, rim[i], [&](SideId s) {
      if (stars.tags().constrained(s) && growth.holds_both_sides(s)) entering = s;
    });
    if (entering.valid()) follow(entering, i);
  }
  return !strands_.empty() && complete();
}

void PatchStrands::follow(SideId side, std::uint32_t from) {
  Strand strand;
  strand.from = from;
  strand.begin = static_cast<std::uint32_t>(stops_.size());
  while (side.valid()) {
    Stop stop = walk(side);
    const VertexId v = mesh_->target(side);
    if (growth_->on_rim(v)) {
      strand.to = static_cast<std::uint32_t>(std::find(rim_.begin(), rim_.end(), v) - rim_.begin());
      side = SideId();
    } else {
      side = pass(side, stop);
    }
    stops_.push_back(stop);
  }
  strand.end = static_cast<std::uint32_t>(stops_.size());
  strands_.push_back(strand);
}

// To the end of the piece, or to the rim; side: the first of the way, and its last one afterwards.
PatchStrands::Stop PatchStrands::walk(SideId& side) {
  const ConstraintTags& tags = stars_->tags();
  const auto measure = [&] {
    return length(mesh_->point(mesh_->target(side)) - mesh_->point(mesh_->origin(side)));
  };
  Stop stop;
  stop.support = Support::on(
      stars_->pieces().under_edge(tags.support[mesh_->origin(side)], tags.support[mesh_->target(side)]));
  stop.edges = 1;
  stop.length = measure();
  for (VertexId v = mesh_->target(side); tags.support[v].slides() && !growth_->on_rim(v);
       v = mesh_->target(side)) {
    const VertexId back = mesh_->origin(side);
    for_each_side_around(*mesh_, v, [&](SideId s) {
      if (tags.constrained(s) && mesh_->target(s) != back) side = s;
    });
    ++inner_;
    ++stop.edges;
    stop.length += measure();
  }
  return stop;
}

// The side across the node that `in` leads to; none if there is none.
SideId PatchStrands::pass(SideId in, Stop& stop) {
  const VertexId v = mesh_->target(in);
  const auto [node, is_new] = node_of_.insert(stamped_key(v));
  if (is_new) {
    node = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({v, kNone, kNone});
    arms_.push_back({stars_->arms(*mesh_, v), 0});
    ++inner_;
  }
  const auto here = static_cast<std::uint32_t>(stops_.size());
  (nodes_[node].first == kNone ? nodes_[node].first : nodes_[node].second) = here;
  stop.node = node;
  auto& [arms, walked] = arms_[node];
  int came = 0;
  while (mesh_->target(arms.side(came)) != mesh_->origin(in)) ++came;
  stop.slot = static_cast<std::uint8_t>(arms.slot(came));
  walked = static_cast<std::uint8_t>(walked | 1U << came);
  for (int i = 0; i < arms.count(); ++i) {
    if (!arms.opposite(i, came)) continue;
    walked = static_cast<std::uint8_t>(walked | 1U << i);
    return arms.side(i);
  }
  return {};
}

bool PatchStrands::complete() const {
  for (const Arms& node : arms_)
    if (node.walked != (1U << node.arms.count()) - 1) return false;
  std::size_t inner = 0;
  for (const VertexId v : growth_->vertices()) inner += stars_->on_line(v) && !growth_->on_rim(v) ? 1 : 0;
  return inner == inner_;
}

}  // namespace quarry
