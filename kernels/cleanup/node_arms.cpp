#include "kernels/cleanup/node_arms.hpp"

#include <cmath>
#include <numbers>

#include "engine/parallel/parallel.hpp"

namespace quarry {
namespace {

// How far from a right angle, in right angles, an angle may be. Less than a half, so that it is the same one
// wherever along the lines the next vertices lie.
constexpr double kMostOff = 0.45;

// Right angles counter-clockwise from a to b, in (0, 4]; 4 from a line to itself.
double right_angles(Vec2 a, Vec2 b) {
  const double angle = std::atan2(cross(a, b), dot(a, b)) / (std::numbers::pi / 2);
  return angle > 0 ? angle : angle + NodeArms::kSlots;
}

// Edges that stay cut open: to nodes that may not be in one piece.
int open_arms(const Mesh& mesh, const ConstraintTags& tags, VertexId v,
              const std::vector<std::uint8_t>& regular) {
  int open = 0;
  for_each_constrained_neighbour(mesh, tags, v, [&](VertexId w) {
    if (tags.support[w].is_fixed() && regular[w.value()] == 0) ++open;
  });
  return open;
}

}  // namespace

std::optional<NodeArms> arms_of(const Mesh& mesh, const ConstraintTags& tags, VertexId v) {
  NodeArms arms;
  bool too_many = false;
  for_each_side_around(mesh, v, [&](SideId s) {
    if (!tags.constrained(s)) return;
    too_many = too_many || arms.count == NodeArms::kSlots;
    if (!too_many) arms.sides[static_cast<std::size_t>(arms.count++)] = s;
  });
  if (too_many || arms.count == 0) return std::nullopt;
  if (tags.support[v].slides()) {
    arms.slots = {0, 2, 0, 0};
    return arms.count == 2 ? std::optional(arms) : std::nullopt;
  }
  const auto direction = [&](int i) {
    return mesh.point(mesh.target(arms.sides[static_cast<std::size_t>(i)])) - mesh.point(v);
  };
  int slot = 0;
  for (int i = 0; i < arms.count; ++i) {
    arms.slots[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(slot);
    const double angle =
        arms.count == 1 ? NodeArms::kSlots : right_angles(direction(i), direction((i + 1) % arms.count));
    const double nearest = std::round(angle);
    if (nearest < 1 || std::abs(angle - nearest) > kMostOff) return std::nullopt;
    slot += static_cast<int>(nearest);
    if (slot > NodeArms::kSlots) return std::nullopt;
  }
  return slot == NodeArms::kSlots ? std::optional(arms) : std::nullopt;
}

std::vector<std::uint8_t> find_regular_nodes(const Mesh& mesh, const ConstraintTags& tags) {
  std::vector<std::uint8_t> regular(mesh.vertex_slots(), 0);
  std::vector<std::uint32_t> nodes = parallel::filter_indices(mesh.vertex_slots(), [&](std::size_t i) {
    const VertexId v(i);
    return mesh.alive(v) && tags.support[v].is_node() && !mesh.on_boundary(v) &&
           arms_of(mesh, tags, v).has_value();
  });
  parallel::for_each(nodes.size(), [&](std::size_t i) { regular[nodes[i]] = 1; });
  for (;;) {
    // With two edges cut open a node is in two pieces, with all of them it is as it was.
    const std::vector<std::uint32_t> cut = parallel::filter_indices(nodes.size(), [&](std::size_t i) {
      const VertexId v(nodes[i]);
      if (regular[v.value()] == 0) return false;
      const int open = open_arms(mesh, tags, v, regular);
      return open > 1 || open == arms_of(mesh, tags, v)->count;
    });
    if (cut.empty()) return regular;
    parallel::for_each(cut.size(), [&](std::size_t i) { regular[nodes[cut[i]]] = 0; });
  }
}

}  // namespace quarry
