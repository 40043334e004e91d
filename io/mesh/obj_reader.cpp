#include <fmt/format.h>

#include "io/mapped_file.hpp"
#include "io/mesh/group_name.hpp"
#include "io/mesh/obj_format.hpp"
#include "io/mesh/read_cells.hpp"
#include "io/text_cursor.hpp"

namespace quarry {
namespace {

class ObjReader {
 public:
  ObjReader(const std::string& path, std::string_view text) : cursor_(path, text) {}

  ReadCells read() {
    while (!cursor_.at_end()) {
      const std::string_view key = cursor_.word();
      if (key == "v") read_point();
      if (key == "f") read_face();
      if (key == "l") read_polyline();
      if (key == "g" || key == "o") read_group();
      cursor_.line();
    }
    regions_.settle(cells_.regions, cells_.names.regions);
    lines_.settle(cells_.constraints, cells_.names.lines);
    return std::move(cells_);
  }

 private:
  void read_point() {
    cells_.x.push_back(cursor_.number<double>("a coordinate"));
    cells_.y.push_back(cursor_.number<double>("a coordinate"));
    cells_.z.push_back(cursor_.at_line_end() ? 0.0 : cursor_.number<double>("a coordinate"));
  }

  // "7", "7/1", "7//3" or "-1/2/3": the point alone matters.
  VertexId read_corner() {
    const std::string_view word = cursor_.word();
    const auto number = cursor_.parse<std::int64_t>(word.substr(0, word.find('/')), "the number of a point");
    const auto count = static_cast<std::int64_t>(cells_.x.size());
    const std::int64_t index = number < 0 ? count + number : number - 1;
    if (index < 0 || index >= count)
      cursor_.fail(fmt::format("point {} does not exist; {} points come before this line", number, count));
    return VertexId(static_cast<std::size_t>(index));
  }

  void read_face() {
    FaceCorners corners;
    std::size_t count = 0;
    for (; !cursor_.at_line_end(); ++count) {
      if (count == 4) cursor_.fail("a face has more than 4 corners; cut it into triangles and quads");
      corners[count] = read_corner();
    }
    if (count < 3) cursor_.fail(fmt::format("a face has {} corners; 3 or 4 are needed", count));
    cells_.faces.push_back(corners);
    cells_.regions.push_back(region_);
  }

  void read_polyline() {
    VertexId previous = read_corner();
    while (!cursor_.at_line_end()) {
      const VertexId here = read_corner();
      cells_.edges.emplace_back(previous, here);
      cells_.constraints.push_back(line_);
      previous = here;
    }
  }

  // Whether a group holds faces or lines shows only later: it gets a number of each sort when its name says
  // so.
  void read_group() {
    if (cursor_.at_line_end()) return;
    const std::string_view name = cursor_.word();
    if (name.starts_with("line_") || name == kOuterBoundaryName)
      line_ = lines_.number(name);
    else
      region_ = regions_.number(name);
  }

  TextCursor cursor_;
  ReadCells cells_;
  GroupNumbers regions_ = region_numbers();
  GroupNumbers lines_ = line_numbers();
  std::int32_t region_ = 0;
  std::int32_t line_ = -1;
};

}  // namespace

ReadCells read_obj(const std::string& path) {
  const MappedFile file(path);
  return ObjReader(path, file.text()).read();
}

}  // namespace quarry
