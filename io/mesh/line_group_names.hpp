// Groups of lines in formats whose groups have names: "set_joints", "material_calcite", "file_faults",
// "name_Main fault".
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/mesh/mesh_file.hpp"

namespace quarry {

class LineGroupNames {
 public:
  LineGroupNames(const Mesh& mesh, const std::vector<LineGrouping>& groups);

  // One for each name of each grouping, in order; without double quotes.
  [[nodiscard]] const std::vector<std::string>& all() const { return names_; }
  // Those of an edge, ascending: indices into all().
  [[nodiscard]] std::vector<std::size_t> of(EdgeId e) const;

 private:
  struct Grouping {
    Tag<EdgeId, std::int32_t> tag;
    std::size_t first;  // of its names in names_
  };
  std::vector<Grouping> groupings_;
  std::vector<std::string> names_;
};

// Whether a group is one of those, by its name; only a file that also has the lines themselves as groups says
// so for certain.
[[nodiscard]] bool is_line_group_name(std::string_view name);

}  // namespace quarry
