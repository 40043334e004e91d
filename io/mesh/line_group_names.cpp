#include "io/mesh/line_group_names.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "io/lower_case.hpp"

namespace quarry {
namespace {

constexpr std::array<std::string_view, 4> kPrefixes = {"name_", "set_", "material_", "file_"};

}  // namespace

LineGroupNames::LineGroupNames(const Mesh& mesh, const std::vector<LineGrouping>& groups) {
  for (const LineGrouping& group : groups) {
    const auto tag = mesh.find_tag<EdgeId, std::int32_t>(group.tag);
    if (!tag.valid()) continue;
    groupings_.push_back({tag, names_.size()});
    for (const std::string& each : group.names) {
      std::string name = fmt::format("{}_{}", group.tag, each);
      std::ranges::replace(name, '"', '\'');
      names_.push_back(std::move(name));
    }
  }
}

std::vector<std::size_t> LineGroupNames::of(EdgeId e) const {
  std::vector<std::size_t> groups;
  for (const Grouping& grouping : groupings_)
    if (const std::int32_t index = grouping.tag[e]; index >= 0)
      groups.push_back(grouping.first + static_cast<std::size_t>(index));
  return groups;
}

bool is_line_group_name(std::string_view name) {
  const std::string lower = lower_case(name.substr(0, 10));
  return std::ranges::any_of(kPrefixes, [&](std::string_view prefix) { return lower.starts_with(prefix); });
}

}  // namespace quarry
