#include "kernels/cleanup/node_slots.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "engine/parallel/parallel.hpp"

namespace quarry {
namespace {

constexpr double kRightAngle = std::numbers::pi / 2;

// Edges of a node that stay cut open.
int count_open(const Mesh& mesh, const ConstraintTags& tags, VertexId v,
               const std::vector<std::uint8_t>& regular) {
  int open = 0;
  for_each_constrained_neighbour(mesh, tags, v, [&](VertexId w) {
    if (!tags.support[w].slides() && regular[w.value()] == 0) ++open;
  });
  return open;
}

}  // namespace

NodeSlots::NodeSlots(const NodedLines& lines)
    : lines_(&lines), pieces_(lines), regular_(lines.nodes.size(), 0), slots_(2 * lines.pieces.size(), 0) {
  parallel::for_each(lines.nodes.size(), [&](std::size_t i) { find_slots(NodeId(i)); });
}

void NodeSlots::find_slots(NodeId node) {
  struct Arm {
    double angle;
    std::uint32_t place;  // in slots_
  };
  const std::span<const PieceId> pieces = pieces_.at(node);
  const std::size_t count = pieces.size();
  if (count == 0 || count > std::size_t{NodeArms::kSlots}) return;
  std::array<Arm, NodeArms::kSlots> arms;
  for (std::size_t i = 0; i < count; ++i) {
    const Piece& piece = lines_->pieces[pieces[i]];
    const bool last = piece.to == node;
    const Vec2 out = lines_->nodes[last ? piece.from : piece.to] - lines_->nodes[node];
    arms[i] = {std::atan2(out.y, out.x), 2 * pieces[i].value() + (last ? 1 : 0)};
  }
  std::sort(arms.begin(), arms.begin() + static_cast<std::ptrdiff_t>(count),
            [](const Arm& a, const Arm& b) { return a.angle < b.angle; });
  int slot = 0;
  for (std::size_t i = 0; i < count; ++i) {
    slots_[arms[i].place] = static_cast<std::uint8_t>(slot);
    const double next = i + 1 < count ? arms[i + 1].angle : arms[0].angle + 2 * std::numbers::pi;
    const int right_angles = static_cast<int>(std::lround((next - arms[i].angle) / kRightAngle));
    if (right_angles == 0) return;
    slot += right_angles;
  }
  regular_[node.value()] = slot == NodeArms::kSlots ? 1 : 0;
}

std::optional<NodeArms> NodeSlots::arms_of(const Mesh& mesh, const ConstraintTags& tags, VertexId v) const {
  const Support here = tags.support[v];
  const bool slides = here.slides();
  if (!slides && !(here.is_node() && regular(here.node()))) return std::nullopt;
  const std::size_t wanted = slides ? 2 : pieces_.at(here.node()).size();
  NodeArms arms;
  std::size_t met = 0;
  int first = 0;
  bool rising = true;
  for_each_side_around(mesh, v, [&](SideId s) {
    if (!tags.constrained(s) || ++met > wanted) return;
    int at = static_cast<int>(2 * met);
    if (!slides) at = slot(pieces_.under_edge(here, tags.support[mesh.target(s)]), here.node());
    if (met == 1) first = at;
    const int turned = (at - first + NodeArms::kSlots) % NodeArms::kSlots;
    rising = rising && (met == 1 || turned > arms.slot(arms.count() - 1));
    arms.add(s, turned);
  });
  return met == wanted && rising ? std::optional(arms) : std::nullopt;
}

std::vector<std::uint8_t> find_regular_nodes(const Mesh& mesh, const ConstraintTags& tags,
                                             const NodeSlots& slots) {
  std::vector<std::uint8_t> regular(mesh.vertex_slots(), 0);
  const std::vector<std::uint32_t> nodes = parallel::filter_indices(mesh.vertex_slots(), [&](std::size_t i) {
    const VertexId v(i);
    return mesh.alive(v) && tags.support[v].is_node() && !mesh.on_boundary(v) &&
           slots.arms_of(mesh, tags, v).has_value();
  });
  parallel::for_each(nodes.size(), [&](std::size_t i) { regular[nodes[i]] = 1; });
  for (;;) {
    // With two edges cut open a node is in two pieces, with all of them it is as it was.
    const std::vector<std::uint32_t> cut = parallel::filter_indices(nodes.size(), [&](std::size_t i) {
      const VertexId v(nodes[i]);
      if (regular[v.value()] == 0) return false;
      const int open = count_open(mesh, tags, v, regular);
      return open > 1 || open == slots.arms_of(mesh, tags, v)->count();
    });
    if (cut.empty()) return regular;
    parallel::for_each(cut.size(), [&](std::size_t i) { regular[nodes[cut[i]]] = 0; });
  }
}

}  // namespace quarry
