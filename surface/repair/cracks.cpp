#include "surface/repair/cracks.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "surface/repair/surface_edges.hpp"
#include "surface/repair/weld.hpp"

namespace quarry {
namespace {

// Of the median edge of rims: triangles of a size that is wanted are larger by far.
constexpr double kNear = 0.01;

}  // namespace

Cracks find_cracks(const TriangleSurface& surface) {
  const SurfaceEdges edges(surface);
  std::vector<std::uint32_t> numbers;
  std::vector<double> lengths;
  for (std::size_t e = 0; e < edges.count(); ++e) {
    if (edges.sides(e).size() != 1) continue;
    const auto [a, b] = SurfaceEdges::ends(surface, edges.sides(e)[0]);
    numbers.insert(numbers.end(), {a, b});
    lengths.push_back(length(surface.points[b] - surface.points[a]));
  }
  Cracks cracks;
  if (lengths.empty()) return cracks;
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  const auto median = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), median, lengths.end());
  cracks.rim_points = numbers.size();
  cracks.distance = kNear * *median;
  std::vector<Vec3> points;
  for (const std::uint32_t p : numbers) points.push_back(surface.points[p]);
  const std::vector<std::uint32_t> first = weld_points(points, cracks.distance);
  std::vector<std::uint8_t> near(points.size(), 0);
  for (std::uint32_t i = 0; i < first.size(); ++i)
    if (first[i] != i) near[i] = near[first[i]] = 1;
  cracks.near_others = static_cast<std::size_t>(std::count(near.begin(), near.end(), 1));
  return cracks;
}

}  // namespace quarry
