#include "pipeline/report/region_summary.hpp"

#include <map>

#include "kernels/quality/face.hpp"

namespace quarry {

namespace {

// All faces of a region are in the same groups.
std::vector<std::pair<std::string, std::string>> groups_of(const Mesh& mesh, FaceId f,
                                                           const std::vector<Grouping>& groups) {
  std::vector<std::pair<std::string, std::string>> result;
  for (const Grouping& group : groups) {
    const auto tag = mesh.find_tag<FaceId, std::int32_t>(group.tag);
    if (tag.valid() && tag[f] >= 0)
      result.emplace_back(group.tag, group.names[static_cast<std::size_t>(tag[f])]);
  }
  return result;
}

}  // namespace

std::vector<RegionSummary> summarize_regions(const Mesh& mesh, const std::vector<Grouping>& groups) {
  const auto region = mesh.find_tag<FaceId, std::int32_t>("region");
  if (!region.valid()) return {};
  std::map<std::int32_t, RegionSummary> by_number;
  RegionSummary* last = nullptr;  // faces of a region come one after the other, by and large
  for (const FaceId f : mesh.faces()) {
    if (!mesh.alive(f)) continue;
    if (last == nullptr || last->region != region[f]) last = &by_number[region[f]];
    RegionSummary& summary = *last;
    if (summary.faces == 0) summary.groups = groups_of(mesh, f, groups);
    summary.region = region[f];
    ++summary.faces;
    summary.area += measure_face(mesh, f, [](auto... corners) { return signed_area(corners...); });
  }
  std::vector<RegionSummary> summaries;
  for (const auto& [number, summary] : by_number) summaries.push_back(summary);
  return summaries;
}

}  // namespace quarry
