#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "io/gocad_text.hpp"
#include "io/mapped_file.hpp"
#include "io/mesh/gocad_format.hpp"
#include "io/mesh/group_name.hpp"
#include "io/mesh/number_index.hpp"

namespace quarry {
namespace {

class GocadReader {
 public:
  GocadReader(const std::string& path, std::string_view text)
      : path_(path), text_(path, text), cursor_(text_.cursor()) {}

  ReadCells read() {
    while (text_.next_object()) {
      if (text_.sort() == "TSurf")
        read_surface();
      else
        text_.pass_object();
    }
    if (surfaces_ == 0) throw Error(ErrorKind::kInput, fmt::format("{}: no TSurf is in it", path_));
    groups_.settle(cells_.regions, cells_.names.regions);
    return std::move(cells_);
  }

 private:
  void read_surface() {
    point_of_ = {};
    const std::size_t first = cells_.z.size();
    while (text_.next_line()) read_line();
    ++surfaces_;
    const std::string_view name = text_.name();
    cells_.regions.resize(
        cells_.faces.size(),
        name.empty() ? groups_.number_of_nameless(fmt::format("\n{}", surfaces_)) : groups_.number(name));
    // Subtracting from 0 makes no negative zero.
    if (text_.depth())
      for (std::size_t i = first; i < cells_.z.size(); ++i) cells_.z[i] = 0 - cells_.z[i];
  }

  void read_line() {
    const std::string_view key = text_.key();
    if (key == "VRTX" || key == "PVRTX")
      read_point();
    else if (key == "ATOM" || key == "PATOM")
      read_atom();
    else if (key == "TRGL")
      read_triangle();
    else
      return text_.read_attributes();
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

  const std::string& path_;
  GocadText text_;
  TextCursor& cursor_;
  ReadCells cells_;
  GroupNumbers groups_ = region_numbers();
  std::size_t surfaces_ = 0;
  NumberIndex point_of_;  // of the surface that is read
};

}  // namespace

ReadCells read_gocad(const std::string& path) {
  const MappedFile file(path);
  return GocadReader(path, file.text()).read();
}

}  // namespace quarry
