// What keeps a network from being noded: nodes too near to edges, and edges that cross.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/geometry/grid.hpp"
#include "kernels/linework/path_network.hpp"

namespace quarry::linework {

// A node nearer than snap to an edge that does not end there.
struct Hit {
  NodeId node;
  std::uint32_t edge;
  double squared;  // distance
};

struct Crossing {
  std::uint32_t first;
  std::uint32_t second;
};

// Finds all conflicts of a network that changes a little from round to round, and looks again only where it
// changed: two things that were found apart stay apart while neither changes.
class ConflictSearch {
 public:
  ConflictSearch(const PathNetwork& network, double snap) : network_(network), snap_(snap) {}

  // Takes up the network as it is after build_edges(). Whatever had conflicts that were found since the last
  // call counts as changed.
  void update();

  // Of the network's edges.
  [[nodiscard]] const std::vector<Segment>& segments() const { return segments_; }
  // By node, then edge. To be asked once in each round.
  [[nodiscard]] std::vector<Hit> hits();
  // By first, then second edge, the first being the smaller number.
  [[nodiscard]] std::vector<Crossing> crossings();

 private:
  static constexpr std::uint32_t kGone = 0xffffffff;

  void find_changed_nodes();
  void find_changed_edges();
  void build_grids();
  [[nodiscard]] std::vector<Hit> hits_everywhere() const;
  [[nodiscard]] std::vector<Hit> hits_of_young_edges() const;
  [[nodiscard]] std::vector<Hit> hits_of_changed_nodes() const;
  [[nodiscard]] std::vector<std::uint32_t> edges_by_place() const;
  [[nodiscard]] std::vector<Segment> segments_of(const std::vector<std::uint32_t>& edges) const;
  void add_hit(NodeId node, std::uint32_t edge, const Segment& segment, std::vector<Hit>& found) const;
  void add_crossing(std::uint32_t e, std::uint32_t f, std::vector<Crossing>& found) const;
  [[nodiscard]] std::vector<Crossing> crossings_among(const SegmentGrid& grid,
                                                      const std::vector<Segment>& segments,
                                                      const std::vector<std::uint32_t>& edge_of) const;
  [[nodiscard]] std::vector<Crossing> crossings_of_young_edges() const;

  const PathNetwork& network_;
  double snap_;
  std::uint32_t round_ = 0;
  std::uint32_t crossings_round_ = 0;  // in which crossings were looked for last

  // Of the last update: nodes, whether each is used, and the round in which it changed last.
  std::vector<Vec2> nodes_;
  std::vector<std::uint8_t> used_;
  std::vector<std::uint32_t> node_changed_;
  // The same of edges; keys: both ends, ascending.
  std::vector<std::uint64_t> keys_;
  std::vector<Segment> segments_;
  std::vector<std::uint32_t> edge_changed_;
  std::vector<std::uint8_t> in_conflict_;

  // All edges of an earlier round, and which they are now, or gone if they changed. Those that changed since
  // are young, and in a grid of their own.
  std::uint32_t grid_round_ = 0;
  std::vector<Segment> old_segments_;
  std::vector<std::uint32_t> old_edges_;
  std::optional<SegmentGrid> old_grid_;
  std::vector<std::uint32_t> young_edges_;
  std::vector<Segment> young_segments_;
  std::optional<SegmentGrid> young_grid_;
};

}  // namespace quarry::linework
