// How regions, constraint lines and the outer boundary are named in formats whose groups have names.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "io/mesh/mesh_file.hpp"

namespace quarry {

inline constexpr std::string_view kOuterBoundaryName = "outer_boundary";

// "region_<n>", or the name that a file gave it.
[[nodiscard]] std::string region_name(std::int32_t region, const GroupNames& names);
// "line_<n>", or the name that a file gave it; "line_unnumbered" for -1.
[[nodiscard]] std::string line_name(std::int32_t constraint, const GroupNames& names);
// "point_<n>", or the name that a file gave it.
[[nodiscard]] std::string point_name(std::int32_t point, const GroupNames& names);

// The same for the edges of a line on one side of it, where the mesh is split: "line_<n>_left" or
// "line_<n>_right".
[[nodiscard]] std::string line_side_name(std::int32_t constraint, std::int32_t side, const GroupNames& names);

// Whether a name is one of those above, of any number, or that of the outer boundary: for names that are to
// be told from them.
[[nodiscard]] bool is_own_name(std::string_view name);

// A name without blanks, commas and quotes, for formats in which those end it.
[[nodiscard]] std::string word_of(std::string name);

// The numbers of groups that are read: those that our names say, also of one side of a line; groups of other
// names get the smallest numbers that are free once all are read, in order of appearance.
class GroupNumbers {
 public:
  explicit GroupNumbers(std::string_view prefix) : prefix_(prefix) {}

  // The number of a group, or a negative stand-in below -1 for one that settle() will number.
  [[nodiscard]] std::int32_t number(std::string_view name) { return find(name, true); }
  // The same for a group without a name; key tells it from others.
  [[nodiscard]] std::int32_t number_of_nameless(std::string_view key) { return find(key, false); }

  // Replaces the stand-ins among the numbers, and adds the names of their groups to names.
  void settle(std::vector<std::int32_t>& numbers, std::map<std::int32_t, std::string>& names) const;

 private:
  struct Group {
    std::string name;
    bool named;
  };
  [[nodiscard]] std::int32_t find(std::string_view name, bool named);

  std::string prefix_;
  std::vector<Group> others_;
  std::map<std::string, std::int32_t, std::less<>> stand_ins_;
};

// For groups of faces, of edges, and of single vertices.
[[nodiscard]] GroupNumbers region_numbers();
[[nodiscard]] GroupNumbers line_numbers();
[[nodiscard]] GroupNumbers point_numbers();

}  // namespace quarry
