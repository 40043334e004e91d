#include "surface/repair/surface_edges.hpp"

#include <algorithm>
#include <numeric>

#include "engine/parallel/parallel.hpp"
#include "engine/parallel/sort.hpp"

namespace quarry {

SurfaceEdges::SurfaceEdges(const TriangleSurface& surface) {
  const std::size_t count = 3 * surface.triangles.size();
  std::vector<std::uint64_t> keys(count);
  sides_.resize(count);
  std::iota(sides_.begin(), sides_.end(), 0U);
  parallel::for_each(count, [&](std::size_t i) {
    const auto [a, b] = ends(surface, static_cast<std::uint32_t>(i));
    keys[i] = (std::uint64_t{std::min(a, b)} << 32) | std::max(a, b);
  });
  parallel::stable_sort_by_key(keys, sides_);
  begin_ = parallel::filter_indices(count, [&](std::size_t i) { return i == 0 || keys[i] != keys[i - 1]; });
  begin_.push_back(static_cast<std::uint32_t>(count));
  edge_of_.resize(count);
  parallel::for_each(begin_.size() - 1, [&](std::size_t edge) {
    for (const std::uint32_t side : sides(edge)) edge_of_[side] = static_cast<std::uint32_t>(edge);
  });
}

}  // namespace quarry
