// The state of cleaning: nodes, and for each line the path that it takes through them; that of an input point
// has one step. Edges are what
// consecutive nodes of the paths make; an edge that several lines take is one edge.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/geometry/line_set.hpp"

namespace quarry::linework {

// A line as it was read, a ring of the outline, or a point of the input.
struct RawLine {
  std::span<const Vec2> points;
  LineId line;                // none for a point, and for an outline that is no input line
  bool outline = false;       // a ring of the outline
  bool rigid = false;         // nothing may bend it
  std::uint32_t polygon = 0;  // of the outline ring
  PointId point = {};         // of the input; such a line has one point, and is rigid
};

// Somewhere among the points, so that offsets from it are small.
[[nodiscard]] Vec2 origin_of(const std::vector<RawLine>& raw);

struct PathStep {
  NodeId node;
  double at;  // the parameter of the raw line's point that the node stands for
};

// Steps follow the raw line: `at` never falls, and consecutive nodes differ. A path of one step has no edge.
struct Path {
  std::uint32_t raw = 0;
  bool outline = false;
  // Its edges were found to be near their stretches, and neither they nor their nodes changed since.
  bool checked = false;
  std::vector<PathStep> steps;
};

struct Edge {
  NodeId from;  // the smaller number
  NodeId to;
  bool outline = false;
};

// Nodes to put between the ends of edges, in rows.
struct Insertion {
  std::uint32_t edge;
  double at;  // along the edge
  NodeId node;
};

struct PathNetwork {
  PathNetwork() = default;
  PathNetwork(const PathNetwork&) = delete;  // would look at the points of the other
  PathNetwork& operator=(const PathNetwork&) = delete;
  PathNetwork(PathNetwork&&) = default;
  PathNetwork& operator=(PathNetwork&&) = default;
  ~PathNetwork() = default;

  std::vector<RawLine> raw;
  std::vector<Vec2> raw_points;  // what those look at, once they are ordered by place
  std::vector<Path> paths;
  IdVector<NodeId, Vec2> nodes;

  // Of the paths as they are: each edge once, by the smaller node, then the larger.
  std::vector<Edge> edges;
  // The edge of each pair of consecutive steps, all paths after one another; those of path p begin at
  // edge_begin[p].
  std::vector<std::uint32_t> edge_of_step;
  std::vector<std::size_t> edge_begin;
  std::vector<std::uint32_t> degree;  // of each node
  std::vector<std::uint8_t> marked;   // whether an input point is at the node

  void build_edges();
  // Ends an edge, or is an input point: what lines have to keep apart from.
  [[nodiscard]] bool used(NodeId node) const { return degree[node.value()] > 0 || marked[node.value()] != 0; }

  // Puts nodes into edges of the last build_edges(), in every path that takes them. Sorts what it is given.
  void insert(std::vector<Insertion>& insertions);
  // Replaces each node by substitute[node] and drops steps that stay where they are.
  void substitute(const IdVector<NodeId, NodeId>& substitute);
  // Takes back that paths through any of these nodes were checked.
  void uncheck_paths_through(const std::vector<NodeId>& moved);
  void drop_repeated_steps();
  void drop_repeated_steps(Path& path) const;

 private:
  std::vector<std::size_t> sort_by_edge(std::vector<Insertion>& insertions) const;
  // Whether path p takes an edge with a flag.
  [[nodiscard]] bool takes_any(std::size_t p, const std::vector<std::uint8_t>& flags) const;
  // begin: where the insertions of each edge begin; steps: scratch.
  void insert_into(std::size_t p, const std::vector<Insertion>& insertions,
                   const std::vector<std::size_t>& begin, std::vector<PathStep>& steps);
};

}  // namespace quarry::linework
