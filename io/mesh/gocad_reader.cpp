#include <algorithm>

#include <cctype>
#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "io/mapped_file.hpp"
#include "io/mesh/gocad_format.hpp"
#include "io/mesh/group_name.hpp"
#include "io/mesh/number_index.hpp"
#include "io/text_cursor.hpp"

namespace quarry {
namespace {

class GocadReader {
 public:
  GocadReader(const std::string& path, std::string_view text) : path_(path), cursor_(path, text) {}

  ReadCells read() {
    while (!cursor_.at_end()) {
      if (const std::string_view word = cursor_.word(); word != "GOCAD")
        cursor_.fail(
            fmt::format("GOCAD and the sort of an object are expected, not \"{}\"", word.substr(0, 40)));
      if (cursor_.word_in_line("the sort of an object") == "TSurf")
        read_surface();
      else
        pass_object();
    }
    if (surfaces_ == 0) throw Error(ErrorKind::kInput, fmt::format("{}: no TSurf is in it", path_));
    groups_.settle(cells_.regions, cells_.names.regions);
    return std::move(cells_);
  }

 private:
  void pass_object() {
    cursor_.line();
    while (next_line()) cursor_.line();
    cursor_.line();
  }

  void read_surface() {
    cursor_.line();
    name_ = {};
    depth_ = false;
    point_of_ = {};
    const std::size_t first = cells_.z.size();
    while (next_line()) read_line();
    cursor_.line();
    ++surfaces_;
    cells_.regions.resize(
        cells_.faces.size(),
        name_.empty() ? groups_.number_of_nameless(fmt::format("\n{}", surfaces_)) : groups_.number(name_));
    // Subtracting from 0 makes no negative zero.
    if (depth_)
      for (std::size_t i = first; i < cells_.z.size(); ++i) cells_.z[i] = 0 - cells_.z[i];
  }

  // Takes the first word of the next line of an object that is no comment; false if it ends the object. The
  // end of the file may not come before that.
  bool next_line() {
    for (;; cursor_.line()) {
      if (cursor_.at_end()) cursor_.fail("the file ends too early: END is missing");
      key_ = cursor_.word();
      if (!key_.starts_with('#')) return key_ != "END";
    }
  }

  void read_line() {
    if (key_ == "VRTX" || key_ == "PVRTX")
      read_point();
    else if (key_ == "ATOM" || key_ == "PATOM")
      read_atom();
    else if (key_ == "TRGL")
      read_triangle();
    else if (key_ == "ZPOSITIVE")
      read_direction();
    else
      return read_attributes();
    cursor_.line();
  }

  std::int64_t number() { return cursor_.number_in_line<std::int64_t>("the number of a point"); }

  void add_point(std::int64_t number, std::uint32_t index) {
    if (!point_of_.add(number, index)) cursor_.fail(fmt::format("point {} is given twice", number));
  }

  std::uint32_t find_point() {
    const std::int64_t wanted = number();
    const std::uint32_t index = point_of_.find(wanted);
    if (index == NumberIndex::kNone)
      cursor_.fail(fmt::format("point {} does not exist in this surface before this line", wanted));
    return index;
  }

  void read_point() {
    add_point(number(), static_cast<std::uint32_t>(cells_.x.size()));
    cells_.x.push_back(cursor_.coordinate());
    cells_.y.push_back(cursor_.coordinate());
    cells_.z.push_back(cursor_.coordinate());
  }

  // Another number for a point.
  void read_atom() {
    const std::int64_t name = number();
    add_point(name, find_point());
  }

  void read_triangle() {
    FaceCorners corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = VertexId(find_point());
    cells_.faces.push_back(corners);
  }

  void read_direction() {
    const std::string_view direction = cursor_.word_in_line("Elevation or Depth");
    depth_ = direction == "Depth";
    if (!depth_ && direction != "Elevation")
      cursor_.fail(fmt::format("Elevation or Depth is expected, not \"{}\"", direction.substr(0, 40)));
  }

  // "HEADER {", lines of attributes, "}", or all of that on one line; "HDR name:..."; the rest of a line that
  // says nothing to us.
  void read_attributes() {
    if (std::isalpha(static_cast<unsigned char>(key_.front())) == 0)
      cursor_.fail(fmt::format("a key is expected, not \"{}\"", key_.substr(0, 40)));
    const bool header = key_ == "HEADER" || key_ == "HDR";
    std::string_view line = cursor_.line();
    const bool block = line.find('{') != std::string_view::npos;
    for (;;) {
      if (header) read_name(line);
      if (!block || line.find('}') != std::string_view::npos) return;
      if (cursor_.at_end()) cursor_.fail("the file ends too early: } is missing");
      line = cursor_.line();
    }
  }

  void read_name(std::string_view attribute) {
    constexpr std::string_view kBlanks = " \t\r{";
    constexpr std::string_view kKey = "name:";
    attribute.remove_prefix(std::min(attribute.find_first_not_of(kBlanks), attribute.size()));
    if (!attribute.starts_with(kKey)) return;
    attribute.remove_prefix(std::min(attribute.find_first_not_of(kBlanks, kKey.size()), attribute.size()));
    attribute = attribute.substr(0, attribute.find('}'));
    name_ = attribute.substr(0, attribute.find_last_not_of(kBlanks) + 1);
  }

  const std::string& path_;
  TextCursor cursor_;
  ReadCells cells_;
  GroupNumbers groups_ = region_numbers();
  std::size_t surfaces_ = 0;
  // Of the surface that is read.
  std::string_view key_;
  std::string_view name_;
  bool depth_ = false;
  NumberIndex point_of_;
};

}  // namespace

ReadCells read_gocad(const std::string& path) {
  const MappedFile file(path);
  return GocadReader(path, file.text()).read();
}

}  // namespace quarry
