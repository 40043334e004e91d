#include <array>
#include <limits>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "io/mapped_file.hpp"
#include "io/mesh/content_lines.hpp"
#include "io/mesh/ply_format.hpp"
#include "io/mesh/ply_row.hpp"

namespace quarry {
namespace {

// What a property is to us.
enum class PlyRole { kSkip, kX, kY, kZ, kCorners, kRegion, kFirst, kSecond, kConstraint, kKind };

struct PlyRoleName {
  std::string_view element, property;
  PlyRole role;
  enum class Sort { kNumber, kWhole, kList } sort;
};

constexpr std::array kRoles = {
    PlyRoleName{"vertex", "x", PlyRole::kX, PlyRoleName::Sort::kNumber},
    PlyRoleName{"vertex", "y", PlyRole::kY, PlyRoleName::Sort::kNumber},
    PlyRoleName{"vertex", "z", PlyRole::kZ, PlyRoleName::Sort::kNumber},
    PlyRoleName{"face", "vertex_indices", PlyRole::kCorners, PlyRoleName::Sort::kList},
    PlyRoleName{"face", "vertex_index", PlyRole::kCorners, PlyRoleName::Sort::kList},
    PlyRoleName{"face", "region", PlyRole::kRegion, PlyRoleName::Sort::kWhole},
    PlyRoleName{"edge", "vertex1", PlyRole::kFirst, PlyRoleName::Sort::kWhole},
    PlyRoleName{"edge", "vertex2", PlyRole::kSecond, PlyRoleName::Sort::kWhole},
    PlyRoleName{"edge", "constraint", PlyRole::kConstraint, PlyRoleName::Sort::kWhole},
    PlyRoleName{"edge", "kind", PlyRole::kKind, PlyRoleName::Sort::kWhole},
};

PlyRole role_of(const PlyElement& element, const PlyProperty& property) {
  for (const PlyRoleName& known : kRoles) {
    if (known.element != element.name || known.property != property.name) continue;
    const bool list = known.sort == PlyRoleName::Sort::kList;
    const bool whole = known.sort != PlyRoleName::Sort::kNumber;
    if (list == property.length_type.has_value() && (!whole || is_whole(property.type))) return known.role;
  }
  return PlyRole::kSkip;
}

class PlyReader {
 public:
  PlyReader(const std::string& path, std::string_view text)
      : path_(path), text_(text), header_(read_ply_header(path, text)) {}

  ReadCells read() {
    check_elements();
    if (header_.byte_order)
      read_binary(PlyBytes(path_, text_, *header_.byte_order));
    else
      read_text();
    return std::move(cells_);
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw Error(ErrorKind::kInput, fmt::format("{}: {}", path_, message));
  }

  void require(std::string_view element, std::string_view properties, std::initializer_list<PlyRole> roles) {
    const PlyElement* found = header_.find(element);
    if (found == nullptr || found->rows == 0) return;
    for (const PlyRole role : roles) {
      std::size_t count = 0;
      for (const PlyProperty& property : found->properties) count += role_of(*found, property) == role;
      if (count != 1) fail(fmt::format("element {} of the header needs {}, once", element, properties));
    }
  }

  void check_elements() {
    if (header_.find("vertex") == nullptr) fail("the header has no element vertex");
    for (const char* strips : {"tristrips", "trifan"})
      if (const PlyElement* found = header_.find(strips); found != nullptr && found->rows > 0)
        fail(fmt::format("the faces are {}, which are not read: save them as element face", strips));
    require("vertex", "numbers x and y", {PlyRole::kX, PlyRole::kY});
    require("face", "a list vertex_indices of whole numbers", {PlyRole::kCorners});
    require("edge", "whole numbers vertex1 and vertex2", {PlyRole::kFirst, PlyRole::kSecond});
    points_ = header_.find("vertex")->rows;
  }

  void read_text() {
    const ContentLines lines(path_, text_, header_.end, '\0');
    std::size_t first = 0;
    for (const PlyElement& element : header_.elements) {
      if (element.properties.empty()) continue;
      if (element.rows > lines.count() - first)
        lines.fail_at(lines.count(),
                      fmt::format("the file ends too early: {} rows of element {} are announced, "
                                  "{} lines are left for them",
                                  element.rows, element.name, lines.count() - first));
      begin_element(element);
      lines.read(first, element.rows, [&](TextCursor& cursor, std::size_t i) {
        PlyTextRow row(cursor);
        read_row(element, row, i);
        if (!cursor.at_line_end()) cursor.fail("the line holds more values than the header announces");
      });
      first += element.rows;
    }
    if (first < lines.count()) lines.fail_at(first, "more lines follow than the header announces");
  }

  void read_binary(const PlyBytes& bytes) {
    std::size_t at = header_.end;
    for (const PlyElement& element : header_.elements) {
      if (element.properties.empty()) continue;
      const PlyLayout layout(bytes, element, at);
      begin_element(element);
      read_parts(layout.parts(), [&](std::size_t part) {
        const std::size_t begin = part * PlyLayout::kRowsInPart;
        const std::size_t end = std::min(element.rows, begin + PlyLayout::kRowsInPart);
        PlyBinaryRows rows(bytes, layout.begin_of(part));
        for (std::size_t i = begin; i < end; ++i) read_row(element, rows, i);
      });
      at = layout.end();
    }
    if (text_.find_first_not_of(" \t\r\n", at) != std::string_view::npos)
      bytes.fail(at, fmt::format("{} bytes follow after what the header announces", text_.size() - at));
  }

  // The count is known to be that of the body.
  void begin_element(const PlyElement& element) {
    roles_.clear();
    for (const PlyProperty& property : element.properties) roles_.push_back(role_of(element, property));
    if (element.name == "vertex") {
      for (auto* coordinate : {&cells_.x, &cells_.y, &cells_.z}) coordinate->resize(points_);
    } else if (element.name == "face") {
      cells_.faces.resize(element.rows);
      cells_.regions.assign(element.rows, 0);
    } else if (element.name == "edge") {
      cells_.edges.resize(element.rows);
      cells_.constraints.assign(element.rows, -1);
      for (const PlyRole role : roles_)
        if (role == PlyRole::kKind) cells_.kinds.assign(element.rows, kInteriorConstraint);
    }
  }

  template <class Row>
  void read_row(const PlyElement& element, Row& row, std::size_t i) {
    for (std::size_t k = 0; k < roles_.size(); ++k) {
      const PlyProperty& property = element.properties[k];
      switch (roles_[k]) {
        case PlyRole::kSkip:
          row.skip(property);
          break;
        case PlyRole::kX:
          cells_.x[i] = row.coordinate(property);
          break;
        case PlyRole::kY:
          cells_.y[i] = row.coordinate(property);
          break;
        case PlyRole::kZ:
          cells_.z[i] = row.coordinate(property);
          break;
        case PlyRole::kCorners:
          cells_.faces[i] = row.face(property, points_);
          break;
        case PlyRole::kRegion:
          cells_.regions[i] = read_tag(row, property);
          break;
        case PlyRole::kFirst:
          cells_.edges[i].first = read_end(row, property);
          break;
        case PlyRole::kSecond:
          cells_.edges[i].second = read_end(row, property);
          break;
        case PlyRole::kConstraint:
          cells_.constraints[i] = read_tag(row, property);
          break;
        case PlyRole::kKind:
          cells_.kinds[i] = read_tag(row, property);
          break;
      }
    }
  }

  template <class Row>
  std::int32_t read_tag(Row& row, const PlyProperty& property) const {
    const std::int64_t value = row.whole(property);
    if (value < std::numeric_limits<std::int32_t>::min() || value > std::numeric_limits<std::int32_t>::max())
      row.fail(fmt::format("{} is {}, which has no place in 32 bits", property.name, value));
    return static_cast<std::int32_t>(value);
  }

  template <class Row>
  VertexId read_end(Row& row, const PlyProperty& property) const {
    const std::int64_t number = row.whole(property);
    if (number < 0 || static_cast<std::size_t>(number) >= points_) row.fail(missing_point(number, points_));
    return VertexId(static_cast<std::size_t>(number));
  }

  const std::string& path_;
  std::string_view text_;
  PlyHeader header_;
  ReadCells cells_;
  std::vector<PlyRole> roles_;  // of the properties of the element that is read
  std::size_t points_ = 0;
};

}  // namespace

ReadCells read_ply(const std::string& path) {
  const MappedFile file(path);
  return PlyReader(path, file.text()).read();
}

}  // namespace quarry
