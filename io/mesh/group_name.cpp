#include "io/mesh/group_name.hpp"

#include <charconv>
#include <optional>
#include <set>

#include <cctype>
#include <fmt/format.h>

namespace quarry {
namespace {

constexpr std::string_view kRegionPrefix = "region_";
constexpr std::string_view kLinePrefix = "line_";
constexpr std::string_view kPointPrefix = "point_";
constexpr std::string_view kUnnumbered = "unnumbered";
constexpr std::string_view kLeftSuffix = "_left", kRightSuffix = "_right";
// Stand-ins count down from here.
constexpr std::int32_t kFirstStandIn = -2;

// What follows the prefix of one of our names: the number in it, also of one side of a line.
std::optional<std::int32_t> number_in(std::string_view digits) {
  for (const std::string_view suffix : {kLeftSuffix, kRightSuffix})
    if (digits.ends_with(suffix)) digits.remove_suffix(suffix.size());
  if (digits == kUnnumbered) return -1;
  std::int32_t value = 0;
  const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (result.ec != std::errc() || result.ptr != digits.data() + digits.size() || value < 0)
    return std::nullopt;
  return value;
}

std::string name_of(std::string_view prefix, std::int32_t number,
                    const std::map<std::int32_t, std::string>& names) {
  if (const auto given = names.find(number); given != names.end()) return given->second;
  return number < 0 ? fmt::format("{}{}", prefix, kUnnumbered) : fmt::format("{}{}", prefix, number);
}

}  // namespace

std::string region_name(std::int32_t region, const GroupNames& names) {
  return name_of(kRegionPrefix, region, names.regions);
}

std::string line_name(std::int32_t constraint, const GroupNames& names) {
  return name_of(kLinePrefix, constraint, names.lines);
}

std::string point_name(std::int32_t point, const GroupNames& names) {
  return name_of(kPointPrefix, point, names.points);
}

std::string line_side_name(std::int32_t constraint, std::int32_t side, const GroupNames& names) {
  std::string name = line_name(constraint, names);
  if (side == kLeftSide) name += kLeftSuffix;
  if (side == kRightSide) name += kRightSuffix;
  return name;
}

bool is_own_name(std::string_view name) {
  if (name == kOuterBoundaryName) return true;
  const auto is_of = [&](std::string_view prefix) {
    return name.starts_with(prefix) && number_in(name.substr(prefix.size())).has_value();
  };
  return is_of(kRegionPrefix) || is_of(kLinePrefix) || is_of(kPointPrefix);
}

std::string word_of(std::string name) {
  for (char& c : name)
    if (std::isspace(static_cast<unsigned char>(c)) != 0 || c == ',' || c == '"') c = '_';
  return name;
}

GroupNumbers region_numbers() { return GroupNumbers(kRegionPrefix); }
GroupNumbers line_numbers() { return GroupNumbers(kLinePrefix); }
GroupNumbers point_numbers() { return GroupNumbers(kPointPrefix); }

std::int32_t GroupNumbers::find(std::string_view name, bool named) {
  if (named && name.starts_with(prefix_)) {
    if (const auto number = number_in(name.substr(prefix_.size()))) return *number;
  }
  if (named && name == kOuterBoundaryName) return -1;
  if (const auto known = stand_ins_.find(name); known != stand_ins_.end()) return known->second;
  const std::int32_t stand_in = kFirstStandIn - static_cast<std::int32_t>(others_.size());
  others_.push_back({std::string(name), named});
  stand_ins_.emplace(name, stand_in);
  return stand_in;
}

void GroupNumbers::settle(std::vector<std::int32_t>& numbers,
                          std::map<std::int32_t, std::string>& names) const {
  std::vector<bool> seen(others_.size(), false);
  std::set<std::int32_t> taken;
  for (const std::int32_t number : numbers) {
    if (number <= kFirstStandIn)
      seen[static_cast<std::size_t>(kFirstStandIn - number)] = true;
    else
      taken.insert(number);
  }
  std::vector<std::int32_t> number_of(others_.size(), -1);
  std::int32_t next = 0;
  for (std::size_t i = 0; i < others_.size(); ++i) {
    if (!seen[i]) continue;
    while (taken.contains(next)) ++next;
    number_of[i] = next++;
    if (others_[i].named) names.emplace(number_of[i], others_[i].name);
  }
  for (std::int32_t& number : numbers)
    if (number <= kFirstStandIn) number = number_of[static_cast<std::size_t>(kFirstStandIn - number)];
}

}  // namespace quarry
