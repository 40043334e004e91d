#include "kernels/linework/conflicts.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "engine/geometry/segment.hpp"
#include "engine/parallel/sort.hpp"
#include "kernels/linework/gather.hpp"

namespace quarry::linework {
namespace {

constexpr std::size_t kNodesPerChunk = 1024;
constexpr std::size_t kEdgesPerChunk = 256;
constexpr std::size_t kCellsPerChunk = 4096;
// In snapping distances: the side of the squares in which edges are put together in memory.
constexpr double kPlaceSide = 64;
// Above this share of young edges the grid of all of them is built anew.
constexpr std::size_t kMostYoung = 4;  // one in so many

std::uint64_t key_of(const Hit& hit) { return std::uint64_t{hit.node.value()} << 32 | hit.edge; }
std::uint64_t key_of(const Crossing& crossing) {
  return std::uint64_t{crossing.first} << 32 | crossing.second;
}

// One that shares several cells is found in each of them.
template <class Found>
std::vector<Found> sorted_unique(std::vector<Found> found, const std::vector<Found>& more = {}) {
  found.insert(found.end(), more.begin(), more.end());
  std::vector<std::uint64_t> keys(found.size());
  for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = key_of(found[i]);
  std::vector<Found> result;
  for (const std::uint32_t i : parallel::sorted_order(std::move(keys)))
    if (result.empty() || key_of(found[i]) != key_of(result.back())) result.push_back(found[i]);
  return result;
}

bool apart(double a, double b, double c, double d) {
  return std::max(a, b) < std::min(c, d) || std::max(c, d) < std::min(a, b);
}

// Cheaper than the exact answer, and true for most pairs.
bool boxes_apart(const Segment& s, const Segment& t) {
  return apart(s.from.x, s.to.x, t.from.x, t.to.x) || apart(s.from.y, s.to.y, t.from.y, t.to.y);
}

bool crosses(const Segment& s, const Segment& t) {
  return !boxes_apart(s, t) && meeting(s.from, s.to, t.from, t.to) == Meeting::kProper;
}

}  // namespace

void ConflictSearch::update() {
  ++round_;
  find_changed_nodes();
  find_changed_edges();
  in_conflict_.assign(network_.edges.size(), 0);
  build_grids();
}

void ConflictSearch::find_changed_nodes() {
  const std::vector<Vec2>& nodes = network_.nodes.raw();
  node_changed_.resize(nodes.size(), round_);
  parallel::for_each(nodes_.size(), [&](std::size_t n) {
    const bool joins = used_[n] == 0 && network_.used(NodeId(n));
    if (joins || !(nodes[n] == nodes_[n])) node_changed_[n] = round_;
  });
  nodes_ = nodes;
  used_.resize(nodes.size());
  parallel::for_each(nodes.size(), [&](std::size_t n) { used_[n] = network_.used(NodeId(n)) ? 1 : 0; });
}

// Both lists of edges ascend by their ends.
void ConflictSearch::find_changed_edges() {
  const std::vector<Edge>& edges = network_.edges;
  std::vector<std::uint64_t> keys(edges.size());
  std::vector<std::uint32_t> changed(edges.size(), round_);
  std::vector<std::uint32_t> now(keys_.size(), kGone);  // what each edge of the last round is
  std::vector<Segment> segments(edges.size());
  std::size_t old = 0;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    keys[e] = std::uint64_t{edges[e].from.value()} << 32 | edges[e].to.value();
    while (old < keys_.size() && keys_[old] < keys[e]) ++old;
    const bool was_there = old < keys_.size() && keys_[old] == keys[e];
    const bool moved =
        node_changed_[edges[e].from.value()] == round_ || node_changed_[edges[e].to.value()] == round_;
    // What lies in a row already need not be gathered from the nodes again.
    segments[e] = was_there && !moved ? segments_[old]
                                      : Segment{network_.nodes[edges[e].from], network_.nodes[edges[e].to]};
    if (!was_there || moved || in_conflict_[old] != 0) continue;
    changed[e] = edge_changed_[old];
    now[old] = static_cast<std::uint32_t>(e);
  }
  parallel::for_each(old_edges_.size(), [&](std::size_t i) {
    if (old_edges_[i] != kGone) old_edges_[i] = now[old_edges_[i]];
  });
  keys_ = std::move(keys);
  segments_ = std::move(segments);
  edge_changed_ = std::move(changed);
}

void ConflictSearch::build_grids() {
  const double side = 4 * snap_;
  young_edges_ = parallel::filter_indices(edge_changed_.size(),
                                          [&](std::size_t e) { return edge_changed_[e] > grid_round_; });
  if (young_edges_.size() * kMostYoung > segments_.size()) {
    young_edges_.clear();
    grid_round_ = round_;
    old_edges_ = edges_by_place();
    old_segments_ = segments_of(old_edges_);
    old_grid_.emplace(old_segments_, side);
  }
  young_segments_ = segments_of(young_edges_);
  young_grid_.emplace(young_segments_, side);
}

// All edges, those that begin near one another together: edges are numbered as lines were read, and what is
// looked at together should lie together in memory.
std::vector<std::uint32_t> ConflictSearch::edges_by_place() const {
  std::vector<Vec2> begins(segments_.size());
  parallel::for_each(begins.size(), [&](std::size_t e) { begins[e] = segments_[e].from; });
  const PointGrid grid(begins, kPlaceSide * snap_);
  return {grid.by_cells().begin(), grid.by_cells().end()};
}

std::vector<Segment> ConflictSearch::segments_of(const std::vector<std::uint32_t>& edges) const {
  std::vector<Segment> result(edges.size());
  parallel::for_each(edges.size(), [&](std::size_t i) { result[i] = segments_[edges[i]]; });
  return result;
}

// edge: may be gone; segment: its ends.
void ConflictSearch::add_hit(NodeId node, std::uint32_t edge, const Segment& segment,
                             std::vector<Hit>& found) const {
  const Vec2 p = network_.nodes[node];
  const auto [a, b] = segment;
  if (apart(a.x, b.x, p.x - snap_, p.x + snap_) || apart(a.y, b.y, p.y - snap_, p.y + snap_)) return;
  if (p == a || p == b) return;  // it ends here: nodes are apart, so that none has another's place
  const double squared = squared_distance(p, a, b);
  if (squared < snap_ * snap_ && edge != kGone) found.push_back({node, edge, squared});
}

std::vector<Hit> ConflictSearch::hits_everywhere() const {
  // By cells, so that what one node needs from memory is there for the next.
  const std::vector<std::uint32_t> order = old_grid_->by_cells(network_.nodes.raw());
  return gather<Hit>(
      order.size(),
      [&](std::size_t begin, std::size_t end, std::vector<Hit>& found) {
        for (std::size_t i = begin; i < end; ++i) {
          const NodeId node(order[i]);
          if (used_[node.value()] == 0) continue;
          const Vec2 p = network_.nodes[node];
          old_grid_->visit_near(Box2{p, p}.grown(snap_), [&](std::uint32_t k) {
            add_hit(node, old_edges_[k], old_segments_[k], found);
          });
        }
      },
      kNodesPerChunk);
}

std::vector<Hit> ConflictSearch::hits_of_young_edges() const {
  return gather<Hit>(
      network_.nodes.size(),
      [&](std::size_t begin, std::size_t end, std::vector<Hit>& found) {
        for (std::size_t n = begin; n < end; ++n) {
          if (used_[n] == 0) continue;
          const Vec2 p = network_.nodes[NodeId(n)];
          young_grid_->visit_near(Box2{p, p}.grown(snap_), [&](std::uint32_t i) {
            const std::uint32_t e = young_edges_[i];
            if (edge_changed_[e] == round_ || node_changed_[n] == round_)
              add_hit(NodeId(n), e, young_segments_[i], found);
          });
        }
      },
      kNodesPerChunk);
}

std::vector<Hit> ConflictSearch::hits_of_changed_nodes() const {
  return gather<Hit>(
      network_.nodes.size(),
      [&](std::size_t begin, std::size_t end, std::vector<Hit>& found) {
        for (std::size_t n = begin; n < end; ++n) {
          if (used_[n] == 0 || node_changed_[n] != round_) continue;
          const Vec2 p = network_.nodes[NodeId(n)];
          old_grid_->visit_near(Box2{p, p}.grown(snap_), [&](std::uint32_t i) {
            add_hit(NodeId(n), old_edges_[i], old_segments_[i], found);
          });
        }
      },
      kNodesPerChunk);
}

std::vector<Hit> ConflictSearch::hits() {
  const bool all = grid_round_ == round_;
  std::vector<Hit> found =
      all ? sorted_unique(hits_everywhere()) : sorted_unique(hits_of_young_edges(), hits_of_changed_nodes());
  for (const Hit& hit : found) in_conflict_[hit.edge] = 1;
  return found;
}

void ConflictSearch::add_crossing(std::uint32_t e, std::uint32_t f, std::vector<Crossing>& found) const {
  if (e == kGone || f == kGone) return;
  if (edge_changed_[e] > crossings_round_ || edge_changed_[f] > crossings_round_)
    found.push_back({std::min(e, f), std::max(e, f)});
}

// grid: of these segments; edge_of: the edge that each of them is, or gone.
std::vector<Crossing> ConflictSearch::crossings_among(const SegmentGrid& grid,
                                                      const std::vector<Segment>& segments,
                                                      const std::vector<std::uint32_t>& edge_of) const {
  return gather<Crossing>(
      grid.cell_count(),
      [&](std::size_t begin, std::size_t end, std::vector<Crossing>& found) {
        for (std::size_t cell = begin; cell < end; ++cell) {
          const std::span<const std::uint32_t> entries = grid.entries(cell);
          for (std::size_t i = 0; i < entries.size(); ++i) {
            const Segment& s = segments[entries[i]];
            for (std::size_t k = i + 1; k < entries.size(); ++k)
              if (crosses(s, segments[entries[k]]))
                add_crossing(edge_of[entries[i]], edge_of[entries[k]], found);
          }
        }
      },
      kCellsPerChunk);
}

std::vector<Crossing> ConflictSearch::crossings_of_young_edges() const {
  return gather<Crossing>(
      young_edges_.size(),
      [&](std::size_t begin, std::size_t end, std::vector<Crossing>& found) {
        for (std::size_t i = begin; i < end; ++i) {
          const std::uint32_t e = young_edges_[i];
          old_grid_->visit_along(segments_[e], [&](std::uint32_t k) {
            if (crosses(segments_[e], old_segments_[k])) add_crossing(e, old_edges_[k], found);
          });
        }
      },
      kEdgesPerChunk);
}

std::vector<Crossing> ConflictSearch::crossings() {
  std::vector<Crossing> found = crossings_among(*old_grid_, old_segments_, old_edges_);
  const std::vector<Crossing> young = crossings_among(*young_grid_, young_segments_, young_edges_);
  found.insert(found.end(), young.begin(), young.end());
  found = sorted_unique(std::move(found), crossings_of_young_edges());
  for (const Crossing& crossing : found) in_conflict_[crossing.first] = in_conflict_[crossing.second] = 1;
  crossings_round_ = round_;
  return found;
}

}  // namespace quarry::linework
