#include "io/mesh/extra_groups.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "io/lower_case.hpp"

namespace quarry {
namespace {

constexpr std::array<std::string_view, 4> kPrefixes = {"name_", "set_", "material_", "file_"};
constexpr std::array<std::string_view, 4> kBare = {"left", "right", "bottom", "top"};

}  // namespace

std::string extra_group_name(const Grouping& grouping, const std::string& name) {
  const bool bare = grouping.tag == kZoneTag || grouping.tag == kBoxSideTag;
  return bare ? name : fmt::format("{}_{}", grouping.tag, name);
}

bool is_extra_line_group(std::string_view name) {
  const std::string lower = lower_case(name.substr(0, 10));
  return std::ranges::find(kBare, lower) != kBare.end() ||
         std::ranges::any_of(kPrefixes, [&](std::string_view prefix) { return lower.starts_with(prefix); });
}

}  // namespace quarry
