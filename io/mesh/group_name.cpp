#include "io/mesh/group_name.hpp"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

namespace quarry {
namespace {

constexpr std::string_view kRegionPrefix = "region_";
constexpr std::string_view kLinePrefix = "line_";
constexpr std::string_view kUnnumbered = "unnumbered";

}  // namespace

std::string region_name(std::int32_t region) { return fmt::format("{}{}", kRegionPrefix, region); }

std::string line_name(std::int32_t constraint) {
  return constraint < 0 ? fmt::format("{}{}", kLinePrefix, kUnnumbered)
                        : fmt::format("{}{}", kLinePrefix, constraint);
}

GroupNumbers region_numbers() { return GroupNumbers(kRegionPrefix); }
GroupNumbers line_numbers() { return GroupNumbers(kLinePrefix); }

std::int32_t GroupNumbers::number(std::string_view name) {
  if (name.starts_with(prefix_)) {
    const std::string_view digits = name.substr(prefix_.size());
    if (digits == kUnnumbered) return -1;
    std::int32_t value = 0;
    const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (result.ec == std::errc() && result.ptr == digits.data() + digits.size()) return value;
  }
  if (name == kOuterBoundaryName) return -1;
  const auto found = std::find(others_.begin(), others_.end(), name);
  if (found != others_.end()) return static_cast<std::int32_t>(found - others_.begin());
  others_.emplace_back(name);
  return static_cast<std::int32_t>(others_.size() - 1);
}

}  // namespace quarry
