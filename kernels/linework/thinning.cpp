#include "kernels/linework/thinning.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <queue>
#include <tuple>

#include "engine/geometry/grid.hpp"
#include "engine/geometry/predicates.hpp"
#include "engine/geometry/segment.hpp"
#include "kernels/linework/gather.hpp"
#include "kernels/linework/linked_paths.hpp"

namespace quarry::linework {
namespace {

// Angles below these make bad elements (radians): none is made narrower by the removal of a bend, which could
// as well be left, or by the collapse of a short edge, which is as bad as a rather narrow angle.
constexpr double kNarrowForBend = 25 * std::numbers::pi / 180;
constexpr double kNarrowForCollapse = 12 * std::numbers::pi / 180;

constexpr double kNever = std::numeric_limits<double>::infinity();

class Thinner {
 public:
  // cut_dangles: of each raw line, to be added to.
  Thinner(PathNetwork& network, const CleanOptions& options, CleanCounts& counts, const Progress& progress,
          std::vector<std::uint32_t>& cut_dangles)
      : network_(network),
        options_(options),
        counts_(counts),
        progress_(progress),
        cut_dangles_(cut_dangles),
        links_(network),
        grid_(network.nodes.raw(), 4 * options.snap),
        version_(network.nodes.size(), 0) {}

  void run() {
    simplify();
    collapse();
    simplify();
    links_.write_back();
  }

 private:
  struct Candidate {
    double cost;  // the deviation, with the smallest ones taken as equal
    double
        stretch;  // raw segments that the joined edge stands for: short ones first keeps the total work low
    NodeId node;
    std::uint32_t version;
    friend bool operator>(const Candidate& a, const Candidate& b) {
      return std::tuple(a.cost, a.stretch, a.node) > std::tuple(b.cost, b.stretch, b.node);
    }
  };

  using Queue = std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>>;

  // A bend: two neighbours, passed by every path from one to the other.
  [[nodiscard]] std::optional<std::array<NodeId, 2>> neighbours_of_bend(NodeId node) const {
    NodeId a;
    NodeId b;
    for (const std::uint32_t step : links_.at(node)) {
      if (links_.is_end(step)) return std::nullopt;
      NodeId before = links_.node_before(step);
      NodeId after = links_.node_after(step);
      if (after < before) std::swap(before, after);
      if (!a.valid()) std::tie(a, b) = std::tie(before, after);
      if (before != a || after != b || a == b) return std::nullopt;
    }
    if (!a.valid()) return std::nullopt;
    return std::array{a, b};
  }

  // Deviation of the joined edge, and whether it is within the limit for each line. The limit of a stretch is
  // never below what its edges deviate already.
  struct Joined {
    double deviation = 0;
    double stretch = 0;
    bool allowed = true;
  };
  [[nodiscard]] Joined join_at(NodeId node, double limit) const {
    Joined result;
    for (const std::uint32_t step : links_.at(node)) {
      const std::uint32_t before = links_.before(step);
      const std::uint32_t after = links_.after(step);
      const double now = std::max(links_.deviation(before, step), links_.deviation(step, after));
      const double then = links_.deviation(before, after);
      result.deviation = std::max(result.deviation, then);
      result.stretch += links_.parameter(after) - links_.parameter(before);
      const double own = links_.rigid(step) ? options_.snap * 1e-6 : std::max(limit, now);
      result.allowed = result.allowed && then <= own;
    }
    return result;
  }

  [[nodiscard]] bool in_triangle(Vec2 p, Vec2 a, Vec2 b, Vec2 c) const {
    const double ab = orient2d(a, b, p);
    const double bc = orient2d(b, c, p);
    const double ca = orient2d(c, a, p);
    return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
  }

  // Whether edge ab may take the place of the way from a over n to b: no node lies in the triangle or nearer
  // than snap to the edge. Edges cannot cross ab then: they would have to end in the triangle or to cross its
  // other sides.
  [[nodiscard]] bool free_to_sweep(NodeId a, NodeId n, NodeId b) const {
    const Vec2 pa = network_.nodes[a];
    const Vec2 pb = network_.nodes[b];
    const Vec2 pn = network_.nodes[n];
    const double margin = std::max(options_.snap, std::sqrt(squared_distance(pn, pa, pb)));
    const auto parts = static_cast<int>(std::clamp(distance(pa, pb) / (8 * margin), 1.0, 64.0));
    for (int k = 0; k < parts; ++k) {
      Box2 box;
      box.extend(point_at(static_cast<double>(k) / parts, pa, pb));
      box.extend(point_at(static_cast<double>(k + 1) / parts, pa, pb));
      grid_.find(box.grown(margin), near_);
      for (const std::uint32_t id : near_) {
        const NodeId m(id);
        if (m == a || m == b || m == n || links_.alone(m)) continue;
        const Vec2 p = network_.nodes[m];
        if (squared_distance(p, pa, pb) < options_.snap * options_.snap || in_triangle(p, pa, pn, pb))
          return false;
      }
    }
    return true;
  }

  // The smallest angle between edges that leave a point for these nodes.
  [[nodiscard]] double smallest_angle_at(Vec2 center, const std::vector<NodeId>& others) const {
    std::vector<double> angles;
    for (const NodeId other : others) {
      const Vec2 along = network_.nodes[other] - center;
      angles.push_back(std::atan2(along.y, along.x));
    }
    std::sort(angles.begin(), angles.end());
    double smallest = angles.size() < 2 ? kNever : angles.front() + 2 * std::numbers::pi - angles.back();
    for (std::size_t i = 1; i < angles.size(); ++i) smallest = std::min(smallest, angles[i] - angles[i - 1]);
    return smallest;
  }

  // Whether an edge of a node that leads to `now` instead of `before` makes a narrow angle there that was
  // not.
  [[nodiscard]] bool narrows(NodeId node, NodeId before, NodeId now, double limit) const {
    const Vec2 center = network_.nodes[node];
    std::vector<NodeId> others = links_.neighbours(node);
    const double was = smallest_angle_at(center, others);
    std::erase(others, now);
    std::replace(others.begin(), others.end(), before, now);
    return smallest_angle_at(center, others) < std::min(was, limit);
  }

  // If the node is a bend that may go.
  [[nodiscard]] std::optional<Candidate> candidate(NodeId node) const {
    if (!neighbours_of_bend(node)) return std::nullopt;
    const Joined joined = join_at(node, options_.tolerance);
    if (!joined.allowed) return std::nullopt;
    const double cost = std::max(joined.deviation, options_.tolerance / 16);
    return Candidate{cost, joined.stretch, node, version_[node.value()]};
  }

  void push(NodeId node) {
    ++version_[node.value()];
    if (const auto bend = candidate(node)) queue_.push(*bend);
  }

  void push_all() {
    for (std::uint32_t& version : version_) ++version;
    queue_ = Queue(std::greater<>(),
                   gather<Candidate>(network_.nodes.size(),
                                     [&](std::size_t begin, std::size_t end, std::vector<Candidate>& found) {
                                       for (std::size_t n = begin; n < end; ++n)
                                         if (const auto bend = candidate(NodeId(n))) found.push_back(*bend);
                                     }));
  }

  void simplify() {
    push_all();
    while (!queue_.empty()) {
      const Candidate next = queue_.top();
      queue_.pop();
      if (next.version != version_[next.node.value()]) continue;
      if (counts_.simplified % 1024 == 0) progress_.throw_if_cancelled();
      const auto ends = neighbours_of_bend(next.node);
      if (!ends || !remove_bend(next.node, *ends, kNarrowForBend)) continue;
      ++counts_.simplified;
      push((*ends)[0]);
      push((*ends)[1]);
    }
  }

  bool remove_bend(NodeId node, std::array<NodeId, 2> ends, double narrow) {
    if (links_.joined(ends[0], ends[1]) || !free_to_sweep(ends[0], node, ends[1])) return false;
    if (narrows(ends[0], node, ends[1], narrow) || narrows(ends[1], node, ends[0], narrow)) return false;
    links_.remove_node(node);
    return true;
  }

  void collapse() {
    links_.write_back();
    network_.build_edges();
    std::vector<std::pair<double, Edge>> short_edges;
    for (const Edge& edge : network_.edges) {
      const double length = distance(network_.nodes[edge.from], network_.nodes[edge.to]);
      if (length < options_.min_edge) short_edges.emplace_back(length, edge);
    }
    std::stable_sort(short_edges.begin(), short_edges.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [length, edge] : short_edges)
      if (links_.joined(edge.from, edge.to) && collapse_edge(edge.from, edge.to)) ++counts_.collapsed;
  }

  [[nodiscard]] double limit() const { return options_.snap + options_.min_edge; }

  bool collapse_edge(NodeId u, NodeId v) {
    const bool u_dangles = links_.dangles(u);
    const bool v_dangles = links_.dangles(v);
    if (u_dangles && v_dangles) return drop_alone(u, v);
    if (u_dangles || v_dangles) return shorten(u_dangles ? u : v, u_dangles ? v : u);
    return remove_short_bend(u, v) || merge_better(u, v);
  }

  // A whole line that is shorter than the shortest piece; but not one that joins two points of the input.
  bool drop_alone(NodeId u, NodeId v) {
    if (links_.marked(u) && links_.marked(v)) return false;
    links_.merge(links_.marked(u) ? v : u, links_.marked(u) ? u : v);
    return true;
  }

  // A dangling end: the bend before it gives way; at a junction the end does.
  bool shorten(NodeId end, NodeId inner) {
    const auto ends = neighbours_of_bend(inner);
    if (ends && join_at(inner, limit()).allowed && remove_bend(inner, *ends, kNarrowForCollapse)) return true;
    if (!merge_allowed(end, inner)) return false;
    if (!ends)
      for (const std::uint32_t step : links_.at(end)) ++cut_dangles_[links_.raw_number(step)];
    links_.merge(end, inner);
    return true;
  }

  bool remove_short_bend(NodeId u, NodeId v) {
    const double u_cost = bend_cost(u);
    const double v_cost = bend_cost(v);
    const bool u_first = u_cost <= v_cost;
    for (const bool u_goes : {u_first, !u_first})
      if ((u_goes ? u_cost : v_cost) < kNever &&
          remove_bend(u_goes ? u : v, *neighbours_of_bend(u_goes ? u : v), kNarrowForCollapse))
        return true;
    return false;
  }

  [[nodiscard]] double bend_cost(NodeId node) const {
    if (!neighbours_of_bend(node)) return kNever;
    const Joined joined = join_at(node, limit());
    return joined.allowed ? joined.deviation : kNever;
  }

  // Whether every line through `gone` stays within the limit if it runs through `kept` instead.
  [[nodiscard]] bool merge_allowed(NodeId gone, NodeId kept) const { return merge_cost(gone, kept) < kNever; }

  [[nodiscard]] double merge_cost(NodeId gone, NodeId kept) const {
    double worst = 0;
    for (const std::uint32_t step : links_.at(gone)) {
      const double then = links_.deviation_if_moved(step, kept);
      if (then > (links_.rigid(step) ? options_.snap * 1e-6 : limit())) return kNever;
      worst = std::max(worst, then);
    }
    return worst;
  }

  bool merge_better(NodeId u, NodeId v) {
    const bool u_outline = links_.on_outline(u);
    const bool v_outline = links_.on_outline(v);
    // Merging across the domain would pinch it, and a hole of three edges would close.
    if (u_outline && v_outline && !(links_.joined_by_outline(u, v) && !links_.share_outline_neighbour(u, v)))
      return false;
    const double u_cost = v_outline >= u_outline ? merge_cost(u, v) : kNever;
    const double v_cost = u_outline >= v_outline ? merge_cost(v, u) : kNever;
    const bool u_first = u_cost <= v_cost;
    for (const bool u_goes : {u_first, !u_first}) {
      const NodeId gone = u_goes ? u : v;
      const NodeId kept = u_goes ? v : u;
      if ((u_goes ? u_cost : v_cost) == kNever || !free_to_merge(gone, kept)) continue;
      links_.merge(gone, kept);
      return true;
    }
    return false;
  }

  [[nodiscard]] bool free_to_merge(NodeId gone, NodeId kept) const {
    const std::vector<NodeId> others = links_.neighbours(gone);
    for (const NodeId other : others)
      if (other != kept &&
          (!free_to_sweep(kept, gone, other) || narrows(other, gone, kept, kNarrowForCollapse)))
        return false;
    std::vector<NodeId> joined = links_.neighbours(kept);
    const double was = std::min(smallest_angle_at(network_.nodes[gone], others),
                                smallest_angle_at(network_.nodes[kept], joined));
    joined.insert(joined.end(), others.begin(), others.end());
    std::erase(joined, gone);
    std::erase(joined, kept);
    std::sort(joined.begin(), joined.end());
    joined.erase(std::unique(joined.begin(), joined.end()), joined.end());
    return smallest_angle_at(network_.nodes[kept], joined) >= std::min(was, kNarrowForCollapse);
  }

  PathNetwork& network_;
  const CleanOptions& options_;
  CleanCounts& counts_;
  const Progress& progress_;
  std::vector<std::uint32_t>& cut_dangles_;
  LinkedPaths links_;
  PointGrid grid_;
  std::vector<std::uint32_t> version_;
  Queue queue_;
  mutable std::vector<std::uint32_t> near_;
};

}  // namespace

std::vector<std::uint32_t> thin_out(PathNetwork& network, const CleanOptions& options, CleanCounts& counts,
                                    const Progress& progress) {
  std::vector<std::uint32_t> cut_dangles(network.raw.size(), 0);
  if (!network.nodes.empty()) Thinner(network, options, counts, progress, cut_dangles).run();
  return cut_dangles;
}

}  // namespace quarry::linework
