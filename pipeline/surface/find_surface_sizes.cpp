#include "pipeline/surface/find_surface_sizes.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "engine/mesh/constraint.hpp"
#include "surface/size/curvature_size.hpp"
#include "surface/size/detail_size.hpp"

namespace quarry {
namespace {

// How fast sizes grow away from details: by this share of the distance.
constexpr double kGrowth = 0.3;
// How much larger elements become elsewhere, at most, where details need more of a wanted number; and how
// many more than their area asks for there may be, if the size is given.
constexpr double kMostStretch = 1.25;
constexpr double kMostForDetails = 1.25;
constexpr double kFitTolerance = 1e-3;
// The least value from low to high with which no more squares have room than are wanted; else high.
template <class Set>
void fit(const SurfaceSizes& sizes, double wanted, double low, double high, const Set& set) {
  set(low);
  if (sizes.squares() <= wanted) return;
  while (high - low > kFitTolerance * low) {
    const double middle = 0.5 * (low + high);
    set(middle);
    (sizes.squares() > wanted ? low : high) = middle;
  }
  set(high);
}

}  // namespace

SurfaceSizes find_surface_sizes(const Mesh& mesh, const SurfaceOptions& options, const SizeDemands& demands,
                                const Progress& progress) {
  const double edge = demands.edge;
  DetailOptions details;
  details.edge = edge;
  const ConstraintTags tags = ConstraintTags::of(mesh);
  std::vector<double> most = detail_sizes(mesh, tags, details, progress);
  if (options.curvature) {
    // A triangle that is cut into quads is as much longer as its edge is than the size.
    const double longer = edge / demands.size;
    const std::vector<double> curved =
        curvature_sizes(mesh, tags, {.error = longer * longer * *options.curvature, .edge = edge});
    for (std::size_t i = 0; i < most.size(); ++i) most[i] = std::min(most[i], curved[i]);
  }
  SurfaceSizes sizes(mesh, std::move(most), kGrowth, edge, demands.tight);
  // An error that is asked for with a size is kept to, whatever number of elements comes of it.
  if (sizes.uniform() || (options.curvature && !options.count)) return sizes;
  const double wanted = demands.area / (edge * edge) * (options.count ? 1 : kMostForDetails);
  if (options.count)
    fit(sizes, wanted, edge, kMostStretch * edge, [&](double longer) { sizes.set_edge(longer); });
  fit(sizes, wanted, 1, demands.most_lenient, [&](double factor) { sizes.set_leniency(factor); });
  return sizes;
}

}  // namespace quarry
