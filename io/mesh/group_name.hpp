// How regions, constraint lines and the outer boundary are named in formats whose groups have names.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace quarry {

inline constexpr std::string_view kOuterBoundaryName = "outer_boundary";

[[nodiscard]] std::string region_name(std::int32_t region);
// "line_<n>", or "line_unnumbered" for -1.
[[nodiscard]] std::string line_name(std::int32_t constraint);

// The numbers of groups that are read: those that our names say; other names count from 0 in order of
// appearance.
class GroupNumbers {
 public:
  explicit GroupNumbers(std::string_view prefix) : prefix_(prefix) {}
  [[nodiscard]] std::int32_t number(std::string_view name);

 private:
  std::string prefix_;
  std::vector<std::string> others_;
};

// For groups of faces, and for groups of edges.
[[nodiscard]] GroupNumbers region_numbers();
[[nodiscard]] GroupNumbers line_numbers();

}  // namespace quarry
