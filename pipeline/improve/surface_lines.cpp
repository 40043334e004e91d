#include "pipeline/improve/surface_lines.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "surface/repair/surface_edges.hpp"

namespace quarry {
namespace {

using NumberedEdge = std::pair<SheetJoin, std::int32_t>;

// Which edges are sides of faces.
class Sides {
 public:
  explicit Sides(const FaceSurface& surface)
      : surface_(surface), edges_(surface.triangles.surface), count_(edges_.count()) {}

  [[nodiscard]] bool has(const SheetJoin& ends) const {
    if (std::binary_search(surface_.within.begin(), surface_.within.end(), ends)) return false;
    // SurfaceEdges are ascending by their ends.
    std::size_t low = 0, high = count_;
    while (low < high) {
      const std::size_t middle = (low + high) / 2;
      if (ends_of(middle) < ends)
        low = middle + 1;
      else
        high = middle;
    }
    return low < count_ && ends_of(low) == ends;
  }

 private:
  [[nodiscard]] SheetJoin ends_of(std::size_t edge) const {
    const auto [a, b] = SurfaceEdges::ends(surface_.triangles.surface, edges_.sides(edge)[0]);
    return join_of(a, b);
  }

  const FaceSurface& surface_;
  SurfaceEdges edges_;
  std::size_t count_;
};

}  // namespace

std::map<std::int32_t, double> SurfaceLines::lengths(const TriangleSurface& surface) const {
  std::map<std::int32_t, double> lengths;
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::int32_t number) {
    if (number >= 0) lengths[number] += length(surface.points[b] - surface.points[a]);
  };
  for (const LineEdge& edge : edges)
    for (const std::int32_t number : numbers[static_cast<std::size_t>(edge.line)])
      add(edge.ends[0], edge.ends[1], number);
  for (const EdgeApart& edge : apart) add(edge.a, edge.b, edge.number);
  return lengths;
}

std::vector<std::int32_t> SurfaceLines::numbers_of(const FeatureCurve& curve, bool rim) const {
  if (curve.line < 0) return rim ? std::vector<std::int32_t>{-1} : std::vector<std::int32_t>();
  std::vector<std::int32_t> found = numbers[static_cast<std::size_t>(curve.line)];
  // A rim is one without an unnumbered edge on it as well.
  if (rim && found.size() > 1 && found.front() == -1) found.erase(found.begin());
  return found;
}

SurfaceLines find_surface_lines(const ReadCells& cells, const FaceSurface& surface) {
  SurfaceLines lines;
  std::vector<std::uint8_t> used(cells.x.size(), 0);
  for (const SurfaceTriangle& t : surface.triangles.surface.triangles)
    for (const std::uint32_t p : t) used[p] = 1;
  std::vector<NumberedEdge> tagged;
  for (std::size_t i = 0; i < cells.edges.size(); ++i) {
    const std::uint32_t a = cells.edges[i].first.value(), b = cells.edges[i].second.value();
    if (a == b) continue;  // of one place: welding left nothing of it
    if (a < used.size() && b < used.size() && used[a] != 0 && used[b] != 0)
      tagged.emplace_back(join_of(a, b), cells.constraints[i]);
    else
      ++lines.lost;
  }
  lines.tagged = tagged.size();
  std::sort(tagged.begin(), tagged.end());
  const Sides sides(surface);
  std::map<std::vector<std::int32_t>, std::int32_t> places;
  for (std::size_t i = 0; i < tagged.size();) {
    const SheetJoin ends = tagged[i].first;
    std::vector<std::int32_t> numbers;
    for (; i < tagged.size() && tagged[i].first == ends; ++i)
      if (numbers.empty() || numbers.back() != tagged[i].second) numbers.push_back(tagged[i].second);
    if (sides.has(ends)) {
      const auto place = places.try_emplace(numbers, static_cast<std::int32_t>(places.size())).first;
      lines.edges.push_back({ends, place->second});
    } else {
      for (const std::int32_t number : numbers) lines.apart.push_back({ends[0], ends[1], number});
      lines.fixed.insert(lines.fixed.end(), ends.begin(), ends.end());
    }
  }
  lines.numbers.resize(places.size());
  for (const auto& [numbers, place] : places) lines.numbers[static_cast<std::size_t>(place)] = numbers;
  for (const VertexId v : cells.points)
    if (v.value() < used.size() && used[v.value()] != 0) lines.fixed.push_back(v.value());
  return lines;
}

}  // namespace quarry
