// Names that users and other programs give to groups, as one file can have them: beside those that quarry
// gives itself, and beside one another.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>

#include "io/mesh/mesh_file.hpp"

namespace quarry {

// What a format takes for a name: a text in double quotes; or a word (word_of), in which capitals are as good
// as small letters.
enum class NameForm { kQuoted, kWord };

class GivenNames {
 public:
  explicit GivenNames(NameForm form) : form_(form) {}

  // The name of one more group, in the form. One that another group has already, or that quarry gives itself
  // ("region_1", "line_2_left", "outer_boundary"), gets the first of the endings _2, _3, ... that helps.
  [[nodiscard]] std::string add(std::string name);

 private:
  NameForm form_;
  std::set<std::string> taken_;
};

// Of the groups of a mesh in one file. Where names are words those of lines are no names of regions or
// points: formats of words have sets that hold any of them.
class FileNames {
 public:
  FileNames(const GroupNames& given, NameForm form);

  // Of regions, lines and points.
  [[nodiscard]] const GroupNames& numbered() const { return numbered_; }
  // For further groups of regions, and of lines.
  [[nodiscard]] GivenNames& of_regions() { return regions_; }
  [[nodiscard]] GivenNames& of_lines() { return lines_; }

 private:
  GroupNames numbered_;
  GivenNames lines_, regions_;
};

}  // namespace quarry
