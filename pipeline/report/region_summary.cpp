#include "pipeline/report/region_summary.hpp"

#include <map>

#include "kernels/quality/face.hpp"

namespace quarry {

std::vector<RegionSummary> summarize_regions(const Mesh& mesh) {
  const auto region = mesh.find_tag<FaceId, std::int32_t>("region");
  if (!region.valid()) return {};
  std::map<std::int32_t, RegionSummary> by_number;
  for (const FaceId f : mesh.faces()) {
    if (!mesh.alive(f)) continue;
    RegionSummary& summary = by_number[region[f]];
    summary.region = region[f];
    ++summary.faces;
    summary.area += measure_face(mesh, f, [](auto... corners) { return signed_area(corners...); });
  }
  std::vector<RegionSummary> summaries;
  for (const auto& [number, summary] : by_number) summaries.push_back(summary);
  return summaries;
}

}  // namespace quarry
