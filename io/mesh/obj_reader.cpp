#include <utility>

#include <fmt/format.h>

#include "io/mapped_file.hpp"
#include "io/mesh/group_name.hpp"
#include "io/mesh/obj_format.hpp"
#include "io/mesh/read_cells.hpp"
#include "io/text_cursor.hpp"

namespace quarry {
namespace {

// The groups that what follows in the file belongs to.
struct ObjGroup {
  std::int32_t region = 0;
  std::int32_t line = -1;
};

// A part of the file: first what it holds is counted, then it is read.
struct ObjPart {
  TextPart text;
  std::size_t points = 0;               // in it; then before it
  std::size_t faces = 0;                // the same
  std::vector<std::string_view> names;  // of the groups that begin in it
  std::vector<ObjGroup> groups;         // one before the first of them, and one after each
  std::vector<std::pair<VertexId, VertexId>> edges;
  std::vector<std::int32_t> constraints;
};

bool is_group(std::string_view key) { return key == "g" || key == "o"; }

void count_part(TextCursor cursor, ObjPart& part) {
  for (; !cursor.at_end(); cursor.line()) {
    const std::string_view key = cursor.word();
    if (key == "v")
      ++part.points;
    else if (key == "f")
      ++part.faces;
    else if (is_group(key) && !cursor.at_line_end())
      part.names.push_back(cursor.word());
  }
}

// Reads a part into the cells, in which there is room for it.
class ObjPartReader {
 public:
  ObjPartReader(TextCursor cursor, ObjPart& part, ReadCells& cells)
      : cursor_(std::move(cursor)), part_(part), cells_(cells), points_(part.points), faces_(part.faces) {}

  void read() {
    std::size_t group = 0;
    for (; !cursor_.at_end(); cursor_.line()) {
      const std::string_view key = cursor_.word();
      if (key == "v")
        read_point();
      else if (key == "f")
        read_face(part_.groups[group].region);
      else if (key == "l")
        read_polyline(part_.groups[group].line);
      else if (is_group(key) && !cursor_.at_line_end())
        ++group;
      else
        pass_over(key);
    }
  }

 private:
  void read_point() {
    cells_.x[points_] = cursor_.coordinate();
    cells_.y[points_] = cursor_.coordinate();
    cells_.z[points_] = cursor_.at_line_end() ? 0.0 : cursor_.coordinate();
    ++points_;
  }

  // "7", "7/1", "7//3" or "-1/2/3": the point alone matters.
  VertexId read_corner() {
    const auto number = cursor_.number_in_line<std::int64_t>("the number of a point", '/');
    const auto count = static_cast<std::int64_t>(points_);
    const std::int64_t index = number < 0 ? count + number : number - 1;
    if (index < 0 || index >= count)
      cursor_.fail(fmt::format("point {} does not exist; {} points come before this line", number, count));
    return VertexId(static_cast<std::size_t>(index));
  }

  void read_face(std::int32_t region) {
    FaceCorners corners;
    std::size_t count = 0;
    for (; !cursor_.at_line_end(); ++count) {
      if (count == 4) cursor_.fail("a face has more than 4 corners; cut it into triangles and quads");
      corners[count] = read_corner();
    }
    if (count < 3) cursor_.fail(fmt::format("a face has {} corners; 3 or 4 are needed", count));
    cells_.faces[faces_] = corners;
    cells_.regions[faces_] = region;
    ++faces_;
  }

  void read_polyline(std::int32_t line) {
    VertexId previous = read_corner();
    while (!cursor_.at_line_end()) {
      const VertexId here = read_corner();
      part_.edges.emplace_back(previous, here);
      part_.constraints.push_back(line);
      previous = here;
    }
  }

  // Keys of materials, normals and display carry nothing for us; those of curved surfaces would be missed,
  // and what is no word at all shows that the file is no .obj.
  void pass_over(std::string_view key) const {
    if (key.starts_with('#')) return;
    if (key == "surf" || key == "curv" || key == "curv2")
      cursor_.fail("free-form curves and surfaces are not read; save them as faces");
    for (const char c : key)
      if (!((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_'))
        cursor_.fail(fmt::format("\"{}\" is no key of an .obj file", key.substr(0, 40)));
  }

  TextCursor cursor_;
  ObjPart& part_;
  ReadCells& cells_;
  std::size_t points_;  // before what is read next, in the file
  std::size_t faces_;
};

class ObjReader {
 public:
  ObjReader(const std::string& path, std::string_view text) : path_(path), text_(text) {
    for (const TextPart cut : split_lines(text, 0)) parts_.emplace_back().text = cut;
  }

  ReadCells read() {
    read_parts(parts_.size(), [&](std::size_t k) { count_part(cursor_of(parts_[k]), parts_[k]); });
    number_groups();
    make_room();
    read_parts(parts_.size(),
               [&](std::size_t k) { ObjPartReader(cursor_of(parts_[k]), parts_[k], cells_).read(); });
    for (const ObjPart& part : parts_) {
      cells_.edges.insert(cells_.edges.end(), part.edges.begin(), part.edges.end());
      cells_.constraints.insert(cells_.constraints.end(), part.constraints.begin(), part.constraints.end());
    }
    regions_.settle(cells_.regions, cells_.names.regions);
    lines_.settle(cells_.constraints, cells_.names.lines);
    return std::move(cells_);
  }

 private:
  [[nodiscard]] TextCursor cursor_of(const ObjPart& part) const { return {path_, text_, part.text}; }

  // Whether a group holds faces or lines shows only later: it gets a number of each sort when its name says
  // so.
  void number_groups() {
    ObjGroup group;
    for (ObjPart& part : parts_) {
      part.groups.push_back(group);
      for (const std::string_view name : part.names) {
        if (name.starts_with("line_") || name == kOuterBoundaryName)
          group.line = lines_.number(name);
        else
          group.region = regions_.number(name);
        part.groups.push_back(group);
      }
    }
  }

  void make_room() {
    std::size_t points = 0;
    std::size_t faces = 0;
    for (ObjPart& part : parts_) {
      points += std::exchange(part.points, points);
      faces += std::exchange(part.faces, faces);
    }
    for (auto* coordinate : {&cells_.x, &cells_.y, &cells_.z}) coordinate->resize(points);
    cells_.faces.resize(faces);
    cells_.regions.resize(faces);
  }

  const std::string& path_;
  std::string_view text_;
  std::vector<ObjPart> parts_;
  ReadCells cells_;
  GroupNumbers regions_ = region_numbers();
  GroupNumbers lines_ = line_numbers();
};

}  // namespace

ReadCells read_obj(const std::string& path) {
  const MappedFile file(path);
  return ObjReader(path, file.text()).read();
}

}  // namespace quarry
