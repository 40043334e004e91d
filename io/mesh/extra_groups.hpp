// Groups of lines and regions beside the lines and regions themselves, in formats whose groups have names:
// "set_joints", "material_calcite", "file_faults", "name_Main fault"; "left"; of regions "material_clay", or
// as the input calls them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/mesh/given_names.hpp"
#include "io/mesh/mesh_file.hpp"

namespace quarry {

// What the group of a name of a grouping is called.
[[nodiscard]] std::string extra_group_name(const Grouping& grouping, const std::string& name);

// Of the edges of a mesh (EdgeId), or of its faces (FaceId).
template <class Entity>
class ExtraGroups {
 public:
  // names: of the groups that the file has by then; these are added.
  ExtraGroups(const Mesh& mesh, const std::vector<Grouping>& groupings, GivenNames& names) {
    for (const Grouping& grouping : groupings) {
      const auto tag = mesh.find_tag<Entity, std::int32_t>(grouping.tag);
      if (!tag.valid()) continue;
      // A name may be one of lines alone, or of regions alone.
      std::vector<std::uint8_t> used(grouping.names.size(), 0);
      for (const std::int32_t index : tag.values())
        if (index >= 0) used[static_cast<std::size_t>(index)] = 1;
      TagOfNames& added = tags_.emplace_back(tag, std::vector<std::size_t>());
      for (std::size_t i = 0; i < used.size(); ++i) {
        added.group_of_name.push_back(names_.size());
        if (used[i] != 0) names_.push_back(names.add(extra_group_name(grouping, grouping.names[i])));
      }
    }
  }

  // One for each name of each grouping that some of these entities have, in order.
  [[nodiscard]] const std::vector<std::string>& all() const { return names_; }
  // Those of an edge or face, ascending: indices into all().
  [[nodiscard]] std::vector<std::size_t> of(Entity entity) const {
    std::vector<std::size_t> groups;
    for (const auto& [tag, group_of_name] : tags_)
      if (const std::int32_t index = tag[entity]; index >= 0)
        groups.push_back(group_of_name[static_cast<std::size_t>(index)]);
    return groups;
  }

 private:
  struct TagOfNames {
    Tag<Entity, std::int32_t> tag;
    std::vector<std::size_t> group_of_name;  // the place of each name in names_
  };
  std::vector<TagOfNames> tags_;
  std::vector<std::string> names_;
};

// Whether a group of lines is one of those, by its name; only a file that also has the lines themselves as
// groups says so for certain.
[[nodiscard]] bool is_extra_line_group(std::string_view name);

}  // namespace quarry
