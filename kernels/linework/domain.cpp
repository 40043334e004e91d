#include "kernels/linework/domain.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/geometry/box.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/linework/raw_stretch.hpp"
#include "kernels/linework/ring_locator.hpp"

namespace quarry::linework {
namespace {

// The edges that rings run along, each with the polygons whose inside it parts from their outside, and a
// table of those edges by height so that rays to the left meet few.
class RingEdges {
 public:
  explicit RingEdges(const PathNetwork& network) : network_(network) {
    collect_polygons();
    fill_rows();
  }

  [[nodiscard]] EdgePlace place(std::uint32_t edge) const {
    const auto [a, b] = ends(edge);
    // The middle is at least half the snapping distance away from all other edges but near its ends, so
    // rounding it changes no answer. Just left of the edge (just above it if it is level).
    std::vector<std::uint32_t> within = polygons_left_of(midpoint(a, b), edge);
    const bool left = keep_odd(within);
    if (polygon_begin_[edge] == polygon_begin_[edge + 1])
      return left ? EdgePlace::kInside : EdgePlace::kOutside;
    append_polygons(edge, within);
    const bool right = keep_odd(within);
    if (left != right) return EdgePlace::kBoundary;
    return left ? EdgePlace::kInside : EdgePlace::kOutside;
  }

  // Whether a node that ends no edge lies in the domain.
  [[nodiscard]] bool holds(NodeId node) const {
    constexpr std::uint32_t kNoEdge = 0xffffffff;
    std::vector<std::uint32_t> within = polygons_left_of(network_.nodes[node], kNoEdge);
    return keep_odd(within);
  }

 private:
  [[nodiscard]] std::pair<Vec2, Vec2> ends(std::uint32_t edge) const {
    return {network_.nodes[network_.edges[edge].from], network_.nodes[network_.edges[edge].to]};
  }

  // Keeps one of each value that occurs an odd number of times; whether any is left.
  template <class T>
  static bool keep_odd(std::vector<T>& values) {
    std::sort(values.begin(), values.end());
    std::size_t kept = 0;
    for (std::size_t i = 0; i < values.size();) {
      std::size_t end = i;
      while (end < values.size() && values[end] == values[i]) ++end;
      if ((end - i) % 2 == 1) values[kept++] = values[i];
      i = end;
    }
    values.resize(kept);
    return kept > 0;
  }

  void append_polygons(std::uint32_t edge, std::vector<std::uint32_t>& polygons) const {
    polygons.insert(polygons.end(), polygons_.begin() + polygon_begin_[edge],
                    polygons_.begin() + polygon_begin_[edge + 1]);
  }

  void collect_polygons() {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (std::size_t p = 0; p < network_.paths.size(); ++p) {
      const Path& path = network_.paths[p];
      if (!path.outline) continue;
      for (std::size_t i = network_.edge_begin[p]; i < network_.edge_begin[p + 1]; ++i)
        pairs.emplace_back(network_.edge_of_step[i], network_.raw[path.raw].polygon);
    }
    keep_odd(pairs);
    polygon_begin_.assign(network_.edges.size() + 1, 0);
    for (const auto& [edge, polygon] : pairs) {
      ++polygon_begin_[edge + 1];
      polygons_.push_back(polygon);
    }
    for (std::size_t i = 0; i + 1 < polygon_begin_.size(); ++i) polygon_begin_[i + 1] += polygon_begin_[i];
  }

  void fill_rows() {
    Box2 box;
    std::vector<std::uint32_t> edges;
    for (std::uint32_t e = 0; e < network_.edges.size(); ++e) {
      if (polygon_begin_[e] == polygon_begin_[e + 1]) continue;
      edges.push_back(e);
      box.extend(ends(e).first);
      box.extend(ends(e).second);
    }
    rows_ = Rows(box.low.y, box.high.y, std::clamp<std::size_t>(edges.size() / 2, 1, 4096));
    for (const std::uint32_t e : edges) rows_.enter(e, ends(e).first.y, ends(e).second.y);
  }

  // The polygons of the edges that a level ray from p to the left crosses. except: an edge that does not
  // count.
  [[nodiscard]] std::vector<std::uint32_t> polygons_left_of(Vec2 p, std::uint32_t except) const {
    std::vector<std::uint32_t> polygons;
    for (const std::uint32_t e : rows_.at(p.y))
      if (e != except && left_ray_crosses(p, ends(e).first, ends(e).second)) append_polygons(e, polygons);
    return polygons;
  }

  const PathNetwork& network_;
  std::vector<std::uint32_t> polygon_begin_;
  std::vector<std::uint32_t> polygons_;
  Rows rows_{0, 0, 1};
};

// Whether a path has edges and all of them lie in the domain, as of most lines.
bool lies_inside(const PathNetwork& network, const std::vector<EdgePlace>& places, std::size_t p) {
  for (std::size_t i = network.edge_begin[p]; i < network.edge_begin[p + 1]; ++i)
    if (places[network.edge_of_step[i]] == EdgePlace::kOutside) return false;
  return network.edge_begin[p] != network.edge_begin[p + 1];
}

}  // namespace

std::vector<EdgePlace> edge_places(const PathNetwork& network) {
  std::vector<EdgePlace> places(network.edges.size());
  const RingEdges rings(network);
  parallel::for_each(
      places.size(), [&](std::size_t e) { places[e] = rings.place(static_cast<std::uint32_t>(e)); }, 512);
  return places;
}

void drop_points_outside(PathNetwork& network, const std::vector<EdgePlace>& places) {
  if (std::ranges::none_of(network.marked, [](std::uint8_t mark) { return mark != 0; })) return;
  std::vector<std::uint8_t> reached(network.nodes.size(), 0);
  for (std::size_t e = 0; e < places.size(); ++e) {
    if (places[e] == EdgePlace::kOutside) continue;
    reached[network.edges[e].from.value()] = reached[network.edges[e].to.value()] = 1;
  }
  const RingEdges rings(network);
  for (Path& path : network.paths) {
    if (!network.raw[path.raw].point.valid() || path.steps.empty()) continue;
    const NodeId node = path.steps.front().node;
    if (reached[node.value()] == 0 && (network.degree[node.value()] > 0 || !rings.holds(node)))
      path.steps.clear();
  }
}

std::vector<double> clip_to_domain(PathNetwork& network, const std::vector<EdgePlace>& places) {
  std::vector<double> clipped(network.raw.size(), 0);
  std::vector<Path> kept;
  for (std::size_t p = 0; p < network.paths.size(); ++p) {
    const Path& path = network.paths[p];
    const RawLine& raw = network.raw[path.raw];
    if (raw.point.valid() || (raw.line.valid() && !path.outline && lies_inside(network, places, p))) {
      kept.push_back(std::move(network.paths[p]));
      continue;
    }
    Path run;
    run.raw = path.raw;
    run.steps.reserve(path.steps.size());
    for (std::size_t i = 0; i + 1 < path.steps.size(); ++i) {
      const EdgePlace place = places[network.edge_of_step[network.edge_begin[p] + i]];
      const bool boundary = path.outline && place == EdgePlace::kBoundary;
      const bool keep = raw.line.valid() ? place != EdgePlace::kOutside : boundary;
      if (!run.steps.empty() && (!keep || boundary != run.outline)) {
        kept.push_back(run);
        run.steps.clear();
      }
      if (!keep) {
        clipped[path.raw] += stretch_length(raw.points, path.steps[i].at, path.steps[i + 1].at);
        continue;
      }
      run.outline = boundary;
      if (run.steps.empty()) run.steps.push_back(path.steps[i]);
      run.steps.push_back(path.steps[i + 1]);
    }
    if (!run.steps.empty()) kept.push_back(std::move(run));
  }
  network.paths = std::move(kept);
  return clipped;
}

}  // namespace quarry::linework
