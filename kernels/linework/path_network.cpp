#include "kernels/linework/path_network.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "engine/parallel/parallel.hpp"
#include "engine/parallel/sort.hpp"
#include "kernels/linework/raw_stretch.hpp"

namespace quarry::linework {
namespace {

constexpr std::size_t kPathsPerChunk = 512;

}  // namespace

Vec2 origin_of(const std::vector<RawLine>& raw) {
  Vec2 origin;
  for (const RawLine& line : raw)
    if (!line.points.empty()) origin = line.points.front();
  return origin;
}

void PathNetwork::build_edges() {
  edge_begin.assign(paths.size() + 1, 0);
  parallel::for_each(paths.size(), [&](std::size_t p) {
    edge_begin[p] = paths[p].steps.empty() ? 0 : paths[p].steps.size() - 1;
  });
  const std::size_t count = parallel::exclusive_scan(std::span(edge_begin));
  std::vector<std::uint64_t> keys(count);
  std::vector<std::uint8_t> outline_steps(count);
  parallel::for_each(
      paths.size(),
      [&](std::size_t p) {
        const Path& path = paths[p];
        for (std::size_t i = 0; i + 1 < path.steps.size(); ++i) {
          const auto [low, high] = std::minmax(path.steps[i].node, path.steps[i + 1].node);
          keys[edge_begin[p] + i] = std::uint64_t{low.value()} << 32 | high.value();
          outline_steps[edge_begin[p] + i] = path.outline ? 1 : 0;
        }
      },
      kPathsPerChunk);
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0U);
  parallel::stable_sort_by_key(keys, order);
  // Where the steps that take one edge begin.
  const std::vector<std::uint32_t> first =
      parallel::filter_indices(count, [&](std::size_t i) { return i == 0 || keys[i] != keys[i - 1]; });
  edges.assign(first.size(), Edge());
  edge_of_step.assign(count, 0);
  parallel::for_each(first.size(), [&](std::size_t e) {
    const std::uint64_t key = keys[first[e]];
    Edge& edge = edges[e];
    edge.from = NodeId(static_cast<std::uint32_t>(key >> 32));
    edge.to = NodeId(static_cast<std::uint32_t>(key));
    const std::size_t end = e + 1 < first.size() ? first[e + 1] : count;
    for (std::size_t i = first[e]; i < end; ++i) {
      edge.outline = edge.outline || outline_steps[order[i]] != 0;
      edge_of_step[order[i]] = static_cast<std::uint32_t>(e);
    }
  });
  degree.assign(nodes.size(), 0);
  marked.assign(nodes.size(), 0);
  for (const Path& path : paths)
    if (raw[path.raw].point.valid())
      for (const PathStep& step : path.steps) marked[step.node.value()] = 1;
  for (const Edge& edge : edges) {
    ++degree[edge.from.value()];
    ++degree[edge.to.value()];
  }
}

void PathNetwork::insert(std::vector<Insertion>& insertions) {
  if (insertions.empty()) return;
  const std::vector<std::size_t> begin = sort_by_edge(insertions);
  // Bytes, which fit the cache: nearly all that most paths need to know.
  std::vector<std::uint8_t> has_any(edges.size(), 0);
  for (const Insertion& insertion : insertions) has_any[insertion.edge] = 1;
  parallel::for_each_chunk(paths.size(), kPathsPerChunk, [&](std::size_t first, std::size_t last) {
    std::vector<PathStep> steps;
    for (std::size_t p = first; p < last; ++p)
      if (takes_any(p, has_any)) insert_into(p, insertions, begin, steps);
  });
}

// Sorts insertions by edge, then along it; returns where those of each edge begin, and the end of the last.
std::vector<std::size_t> PathNetwork::sort_by_edge(std::vector<Insertion>& insertions) const {
  std::vector<std::size_t> begin(edges.size() + 1, 0);
  for (const Insertion& insertion : insertions) ++begin[insertion.edge];
  (void)parallel::exclusive_scan(std::span(begin));
  std::vector<Insertion> sorted(insertions.size());
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  for (const Insertion& insertion : insertions) sorted[next[insertion.edge]++] = insertion;
  insertions.swap(sorted);
  parallel::for_each(edges.size(), [&](std::size_t edge) {
    if (begin[edge + 1] - begin[edge] < 2) return;
    std::sort(insertions.begin() + static_cast<std::ptrdiff_t>(begin[edge]),
              insertions.begin() + static_cast<std::ptrdiff_t>(begin[edge + 1]),
              [](const Insertion& a, const Insertion& b) {
                return std::tie(a.at, a.node) < std::tie(b.at, b.node);
              });
  });
  return begin;
}

bool PathNetwork::takes_any(std::size_t p, const std::vector<std::uint8_t>& flags) const {
  for (std::size_t i = edge_begin[p]; i < edge_begin[p + 1]; ++i)
    if (flags[edge_of_step[i]] != 0) return true;
  return false;
}

void PathNetwork::insert_into(std::size_t p, const std::vector<Insertion>& insertions,
                              const std::vector<std::size_t>& begin, std::vector<PathStep>& steps) {
  Path& path = paths[p];
  steps.clear();
  for (std::size_t i = 0; i + 1 < path.steps.size(); ++i) {
    steps.push_back(path.steps[i]);
    const std::uint32_t edge = edge_of_step[edge_begin[p] + i];
    const bool forward = edges[edge].from == path.steps[i].node;
    const std::size_t size = begin[edge + 1] - begin[edge];
    for (std::size_t k = 0; k < size; ++k) {
      const NodeId node = insertions[forward ? begin[edge] + k : begin[edge + 1] - 1 - k].node;
      const double at =
          nearest_parameter(raw[path.raw].points, steps.back().at, path.steps[i + 1].at, nodes[node]);
      steps.push_back({node, at});
    }
  }
  steps.push_back(path.steps.back());
  path.steps = steps;
  path.checked = false;
  drop_repeated_steps(path);
}

void PathNetwork::substitute(const IdVector<NodeId, NodeId>& substitute) {
  parallel::for_each(
      paths.size(),
      [&](std::size_t p) {
        bool touched = false;
        for (PathStep& step : paths[p].steps) {
          touched = touched || substitute[step.node] != step.node;
          step.node = substitute[step.node];
        }
        if (!touched) return;
        paths[p].checked = false;
        drop_repeated_steps(paths[p]);
      },
      kPathsPerChunk);
}

void PathNetwork::uncheck_paths_through(const std::vector<NodeId>& moved) {
  if (moved.empty()) return;
  std::vector<std::uint8_t> has_moved(nodes.size(), 0);
  for (const NodeId node : moved) has_moved[node.value()] = 1;
  parallel::for_each(
      paths.size(),
      [&](std::size_t p) {
        for (const PathStep& step : paths[p].steps)
          if (has_moved[step.node.value()] != 0) paths[p].checked = false;
      },
      kPathsPerChunk);
}

void PathNetwork::drop_repeated_steps() {
  parallel::for_each(
      paths.size(), [&](std::size_t p) { drop_repeated_steps(paths[p]); }, kPathsPerChunk);
}

void PathNetwork::drop_repeated_steps(Path& path) const {
  std::vector<PathStep>& steps = path.steps;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < steps.size();) {
    std::size_t end = i + 1;
    while (end < steps.size() && steps[end].node == steps[i].node) ++end;
    double at = steps[i].at;
    if (end == steps.size()) {
      at = i == 0 ? at : steps[end - 1].at;
    } else if (i > 0 && end - i > 1) {
      at = nearest_parameter(raw[path.raw].points, steps[i].at, steps[end - 1].at, nodes[steps[i].node]);
    }
    steps[kept++] = {steps[i].node, at};
    i = end;
  }
  steps.resize(kept);
}

}  // namespace quarry::linework
