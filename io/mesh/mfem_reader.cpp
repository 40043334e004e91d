#include <algorithm>

#include <fmt/format.h>

#include "io/mapped_file.hpp"
#include "io/mesh/content_lines.hpp"
#include "io/mesh/counted_face.hpp"
#include "io/mesh/mfem_format.hpp"

namespace quarry {
namespace {

class MfemReader {
 public:
  MfemReader(const std::string& path, std::string_view text) : lines_(path, text, 0, '#') {}

  ReadCells read() {
    read_heading();
    Section elements, boundary;
    while (next_ < lines_.count()) {
      const std::string keyword = word_of_line("a section");
      if (keyword == "dimension") {
        if (const std::size_t dimension = count_of_line("the dimension"); dimension != 2)
          lines_.fail_at(next_ - 1,
                         fmt::format("a mesh of dimension {}; those of dimension 2 are read", dimension));
      } else if (keyword == "elements") {
        elements = take_section("elements");
      } else if (keyword == "boundary") {
        boundary = take_section("boundary elements");
      } else if (keyword == "vertices") {
        read_vertices();
      } else if (keyword == "mfem_mesh_end") {
        break;
      } else {
        lines_.fail_at(next_ - 1,
                       fmt::format("dimension, elements, boundary or vertices is expected, not \"{}\"",
                                   keyword.substr(0, 40)));
      }
    }
    read_elements(elements);
    read_boundary(boundary);
    return std::move(cells_);
  }

 private:
  struct Section {
    std::size_t first = 0, count = 0;
  };

  void read_heading() {
    constexpr std::string_view kName = "MFEM mesh v1.";
    std::string heading;
    if (lines_.count() > 0)
      lines_.read(0, 1, [&](TextCursor& cursor, std::size_t) { heading = std::string(cursor.line()); });
    while (!heading.empty() && (heading.back() == '\r' || heading.back() == ' ')) heading.pop_back();
    const bool known = heading.starts_with(kName) && heading.size() == kName.size() + 1 &&
                       heading.back() >= '0' && heading.back() <= '3';
    if (!known)
      lines_.fail_at(0, fmt::format("\"MFEM mesh v1.0\" is expected, not \"{}\"", heading.substr(0, 40)));
    next_ = 1;
  }

  std::string word_of_line(const char* what) {
    if (next_ == lines_.count())
      lines_.fail_at(next_, fmt::format("the file ends too early: {} is missing", what));
    std::string word;
    lines_.read(next_++, 1, [&](TextCursor& cursor, std::size_t) { word = std::string(cursor.word()); });
    return word;
  }

  std::size_t count_of_line(const char* what) {
    if (next_ == lines_.count())
      lines_.fail_at(next_, fmt::format("the file ends too early: {} is missing", what));
    std::int64_t count = 0;
    lines_.read(next_++, 1,
                [&](TextCursor& cursor, std::size_t) { count = cursor.number<std::int64_t>(what); });
    if (count < 0) lines_.fail_at(next_ - 1, fmt::format("{} is {}", what, count));
    return static_cast<std::size_t>(count);
  }

  // Takes so many of the lines that are left.
  std::size_t claim(std::size_t count, const char* what) {
    if (count > lines_.count() - next_)
      lines_.fail_at(lines_.count(),
                     fmt::format("the file ends too early: {} {} are announced, {} lines follow", count, what,
                                 lines_.count() - next_));
    next_ += count;
    return next_ - count;
  }

  Section take_section(const char* what) {
    Section section;
    section.count = count_of_line("a count");
    section.first = claim(section.count, what);
    return section;
  }

  void read_vertices() {
    const std::size_t count = count_of_line("the number of vertices");
    const std::string sizes = word_of_line("the number of coordinates");
    if (sizes != "2" && sizes != "3")
      lines_.fail_at(next_ - 1, sizes == "nodes" ? "a curved mesh, with nodes; straight ones are read"
                                                 : fmt::format("2 or 3 coordinates are read, not \"{}\"",
                                                               sizes.substr(0, 40)));
    const std::size_t first = claim(count, "vertices");
    for (auto* coordinate : {&cells_.x, &cells_.y, &cells_.z}) coordinate->assign(count, 0);
    lines_.read(first, count, [&](TextCursor& cursor, std::size_t i) {
      cells_.x[i] = cursor.coordinate();
      cells_.y[i] = cursor.coordinate();
      if (sizes == "3") cells_.z[i] = cursor.coordinate();
    });
  }

  [[nodiscard]] VertexId read_point(TextCursor& cursor) const {
    const auto number = cursor.number_in_line<std::int64_t>("the number of a vertex");
    if (number < 0 || static_cast<std::size_t>(number) >= cells_.x.size())
      cursor.fail(missing_point(number, cells_.x.size()));
    return VertexId(static_cast<std::size_t>(number));
  }

  // Attributes and what they stand for: one that is added to none may not leave the range.
  static std::int32_t read_attribute(TextCursor& cursor) {
    const auto attribute = cursor.number_in_line<std::int32_t>("an attribute");
    if (attribute < 1) cursor.fail(fmt::format("an attribute of {}: they count from 1", attribute));
    return attribute;
  }

  void read_elements(Section section) {
    cells_.faces.resize(section.count);
    cells_.regions.resize(section.count);
    lines_.read(section.first, section.count, [&](TextCursor& cursor, std::size_t i) {
      cells_.regions[i] = read_attribute(cursor) - 1;
      const auto type = cursor.number_in_line<int>("the geometry of an element");
      if (type != 2 && type != 3)
        cursor.fail(fmt::format("an element of geometry {}; triangles (2) and squares (3) are read", type));
      for (std::size_t k = 0; k < static_cast<std::size_t>(type) + 1; ++k)
        cells_.faces[i][k] = read_point(cursor);
    });
  }

  void read_boundary(Section section) {
    cells_.edges.resize(section.count);
    cells_.constraints.resize(section.count);
    lines_.read(section.first, section.count, [&](TextCursor& cursor, std::size_t i) {
      cells_.constraints[i] = read_attribute(cursor) - 2;
      const auto type = cursor.number_in_line<int>("the geometry of an element");
      if (type != 1)
        cursor.fail(fmt::format("a boundary element of geometry {}; segments (1) are read", type));
      const VertexId from = read_point(cursor);
      cells_.edges[i] = {from, read_point(cursor)};
    });
  }

  ContentLines lines_;
  ReadCells cells_;
  std::size_t next_ = 0;  // line
};

}  // namespace

ReadCells read_mfem(const std::string& path) {
  const MappedFile file(path);
  return MfemReader(path, file.text()).read();
}

}  // namespace quarry
