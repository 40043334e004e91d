#include "pipeline/report/line_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/geometry/grid.hpp"
#include "engine/geometry/segment.hpp"
#include "engine/parallel/parallel.hpp"

namespace quarry {
namespace {

// Segments that are asked for their distance again and again: a grid where there are many.
class NearestSegment {
 public:
  explicit NearestSegment(std::vector<Segment> segments) : segments_(std::move(segments)) {
    for (const Segment& segment : segments_) mean_length_ += quarry::distance(segment.from, segment.to);
    mean_length_ /= static_cast<double>(segments_.size());
    if (segments_.size() > kFew && mean_length_ > 0) grid_.emplace(segments_, mean_length_);
  }
  // The grid keeps a view of the segments.
  NearestSegment(const NearestSegment&) = delete;
  NearestSegment& operator=(const NearestSegment&) = delete;

  [[nodiscard]] const std::vector<Segment>& segments() const { return segments_; }

  [[nodiscard]] double distance(Vec2 p) {
    if (!grid_) {
      double best = std::numeric_limits<double>::infinity();
      for (const Segment& segment : segments_)
        best = std::min(best, squared_distance(p, segment.from, segment.to));
      return std::sqrt(best);
    }
    // A box of half width r holds the nearest segment as soon as one in it is nearer than r.
    for (double r = 0.25 * mean_length_;; r *= 2) {
      grid_->find(Box2{p, p}.grown(r), ids_);
      double best = std::numeric_limits<double>::infinity();
      for (const std::uint32_t id : ids_)
        best = std::min(best, squared_distance(p, segments_[id].from, segments_[id].to));
      if (best <= r * r || ids_.size() == segments_.size()) return std::sqrt(best);
    }
  }

 private:
  static constexpr std::size_t kFew = 16;
  std::vector<Segment> segments_;
  double mean_length_ = 0;
  std::optional<SegmentGrid> grid_;
  std::vector<std::uint32_t> ids_;
};

// The edges of each line, in compressed rows.
struct EdgesOfLines {
  std::vector<std::uint32_t> begin;
  std::vector<EdgeId> edges;
};

EdgesOfLines edges_of_lines(const Mesh& mesh, std::size_t line_count) {
  const auto constraint = mesh.find_tag<EdgeId, std::int32_t>("constraint");
  EdgesOfLines rows;
  rows.begin.assign(line_count + 1, 0);
  if (!constraint.valid()) return rows;
  const auto bears_number = [&](EdgeId e) {
    return constraint[e] >= 0 && static_cast<std::size_t>(constraint[e]) < line_count;
  };
  for (const EdgeId e : mesh.edges())
    if (bears_number(e)) ++rows.begin[static_cast<std::size_t>(constraint[e]) + 1];
  for (std::size_t i = 0; i < line_count; ++i) rows.begin[i + 1] += rows.begin[i];
  rows.edges.resize(rows.begin.back());
  std::vector<std::uint32_t> next(rows.begin.begin(), rows.begin.end() - 1);
  for (const EdgeId e : mesh.edges())
    if (bears_number(e)) rows.edges[next[static_cast<std::size_t>(constraint[e])]++] = e;
  return rows;
}

std::vector<Segment> segments_of(const InputLine& line) {
  std::vector<Segment> segments;
  for (std::size_t i = 0; i + 1 < line.points.size(); ++i)
    segments.push_back({line.points[i], line.points[i + 1]});
  return segments;
}

double farthest(const InputLine& line, std::vector<Segment> edges, bool clipped) {
  NearestSegment to_line(segments_of(line));
  double largest = 0;
  for (const auto& [a, b] : edges)
    for (const Vec2 p : {a, midpoint(a, b), b}) largest = std::max(largest, to_line.distance(p));
  if (clipped) return largest;
  NearestSegment to_edges(std::move(edges));
  for (const Vec2 p : line.points) largest = std::max(largest, to_edges.distance(p));
  return largest;
}

}  // namespace

IdVector<LineId, double> measure_line_distances(const Mesh& mesh, const LineSet& lines,
                                                const IdVector<LineId, LedgerEntry>& ledger) {
  const std::size_t count = lines.lines.size();
  const EdgesOfLines rows = edges_of_lines(mesh, count);
  IdVector<LineId, double> distances(count, std::numeric_limits<double>::quiet_NaN());
  parallel::for_each(
      count,
      [&](std::size_t i) {
        const LineId id(i);
        if (rows.begin[i] == rows.begin[i + 1] || lines.lines[id].points.size() < 2) return;
        std::vector<Segment> edges;
        for (std::uint32_t k = rows.begin[i]; k < rows.begin[i + 1]; ++k) {
          const auto [a, b] = mesh.edge_ends(rows.edges[k]);
          edges.push_back({mesh.point(a), mesh.point(b)});
        }
        const bool clipped = i < ledger.size() && ledger[id].clipped_length > 0;
        distances[id] = farthest(lines.lines[id], std::move(edges), clipped);
      },
      1);
  return distances;
}

}  // namespace quarry
