#include "io/mesh/vtu_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "io/mapped_file.hpp"
#include "io/mesh/read_cells.hpp"
#include "io/mesh/vtu_data.hpp"

namespace quarry {
namespace {

class VtuReader {
 public:
  VtuReader(const std::string& path, const XmlElement& root) : path_(path), data_(path, root) {}

  ReadCells read(const XmlElement& root) {
    const XmlElement* grid = root.child("UnstructuredGrid");
    if (grid == nullptr) refuse("it holds no UnstructuredGrid");
    read_group_names(grid->child("FieldData"));
    for (const XmlElement& piece : grid->children)
      if (piece.name == "Piece") read_piece(piece);
    if (!kinds_known_) cells_.kinds.clear();
    drop_unused();
    return std::move(cells_);
  }

 private:
  struct CellData {
    std::vector<std::int64_t> region, constraint, kind;
    std::vector<std::vector<std::int64_t>> groups;  // as in cells_.groups
    std::vector<double> aperture;
  };

  [[noreturn]] void refuse(const std::string& message) const {
    throw Error(ErrorKind::kInput, fmt::format("{}: {}", path_, message));
  }

  static const XmlElement* find_array(const XmlElement* parent, std::string_view name) {
    if (parent == nullptr) return nullptr;
    for (const XmlElement& array : parent->children)
      if (array.name == "DataArray" && (name.empty() || array.attribute("Name") == name)) return &array;
    return nullptr;
  }

  const XmlElement& need_array(const XmlElement& piece, std::string_view parent,
                               std::string_view name) const {
    const XmlElement* array = find_array(piece.child(parent), name);
    if (array == nullptr) refuse(fmt::format("the array {} {} is missing", parent, name));
    return *array;
  }

  // The texts "<name>_names" are what the whole numbers <name> of cells mean.
  void read_group_names(const XmlElement* fields) {
    if (fields == nullptr) return;
    constexpr std::string_view kEnd = "_names";
    for (const XmlElement& array : fields->children) {
      const std::string_view name = array.attribute("Name");
      if (array.name != "DataArray" || array.attribute("type") != "String" || !name.ends_with(kEnd)) continue;
      const std::string_view tag = name.substr(0, name.size() - kEnd.size());
      constexpr std::array<std::string_view, 5> kOurs = {"region", "constraint", "kind", kSideTag,
                                                         kApertureTag};
      if (tag.empty() || std::ranges::find(kOurs, tag) != kOurs.end()) continue;
      cells_.groups.push_back({{std::string(tag), data_.texts(array)}, {}, {}});
    }
  }

  void drop_unused() {
    const auto none = [](const std::vector<std::int32_t>& values) {
      return std::ranges::all_of(values, [](std::int32_t value) { return value < 0; });
    };
    for (ReadGrouping& group : cells_.groups)
      for (std::vector<std::int32_t>* values : {&group.of_faces, &group.of_edges})
        if (none(*values)) values->clear();
    std::erase_if(cells_.groups,
                  [](const ReadGrouping& group) { return group.of_faces.empty() && group.of_edges.empty(); });
    if (std::ranges::all_of(cells_.apertures, [](double value) { return std::isnan(value); }))
      cells_.apertures.clear();
  }

  void read_points(const XmlElement& piece) {
    const XmlElement& array = need_array(piece, "Points", "");
    const std::vector<double> values = data_.doubles(array);
    if (values.size() % 3 != 0) data_.fail(array, "points need three coordinates each");
    for (std::size_t i = 0; i < values.size(); i += 3) {
      cells_.x.push_back(values[i]);
      cells_.y.push_back(values[i + 1]);
      cells_.z.push_back(values[i + 2]);
    }
    const XmlElement* numbers = find_array(piece.child("PointData"), kPointTag);
    if (numbers == nullptr) return;
    const std::vector<std::int64_t> points = data_.integers(*numbers);
    if (points.size() != values.size() / 3)
      data_.fail(*numbers, fmt::format("{} values for {} points", points.size(), values.size() / 3));
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (points[i] < 0) continue;
      cells_.points.emplace_back(first_point_ + i);
      cells_.point_numbers.push_back(static_cast<std::int32_t>(points[i]));
    }
  }

  // One value for each cell; empty if the file has no such array.
  std::vector<std::int64_t> read_cell_data(const XmlElement& piece, std::string_view name,
                                           std::size_t count) const {
    const XmlElement* array = find_array(piece.child("CellData"), name);
    if (array == nullptr) return {};
    std::vector<std::int64_t> values = data_.integers(*array);
    if (values.size() != count)
      data_.fail(*array, fmt::format("{} values for {} cells", values.size(), count));
    return values;
  }

  // The groups of cells, under our name or one that others give them: meshio, Gmsh, OpenGeoSys.
  std::vector<std::int64_t> read_groups(const XmlElement& piece, std::string_view name,
                                        std::size_t count) const {
    for (const std::string_view each : {name, std::string_view("gmsh:physical"),
                                        std::string_view("CellEntityIds"), std::string_view("MaterialIDs")})
      if (std::vector<std::int64_t> groups = read_cell_data(piece, each, count); !groups.empty())
        return groups;
    return {};
  }

  std::vector<std::int64_t> read_group_numbers(const XmlElement& piece, const Grouping& grouping,
                                               std::size_t count) const {
    std::vector<std::int64_t> numbers = read_cell_data(piece, grouping.tag, count);
    for (const std::int64_t number : numbers)
      if (number >= std::ssize(grouping.names))
        refuse(fmt::format("a cell has {} {}, but there are {} names", grouping.tag, number,
                           grouping.names.size()));
    return numbers;
  }

  void read_piece(const XmlElement& piece) {
    first_point_ = cells_.x.size();
    read_points(piece);
    points_ = cells_.x.size() - first_point_;
    const std::vector<std::int64_t> corners = data_.integers(need_array(piece, "Cells", "connectivity"));
    const XmlElement& offset_array = need_array(piece, "Cells", "offsets");
    const std::vector<std::int64_t> ends = data_.integers(offset_array);
    const std::vector<std::int64_t> types = data_.integers(need_array(piece, "Cells", "types"));
    if (ends.size() != types.size()) data_.fail(offset_array, "its length differs from that of types");
    CellData values;
    values.region = read_groups(piece, "region", types.size());
    values.constraint = read_groups(piece, "constraint", types.size());
    values.kind = read_cell_data(piece, "kind", types.size());
    kinds_known_ = kinds_known_ && (types.empty() || !values.kind.empty());
    for (const ReadGrouping& group : cells_.groups)
      values.groups.push_back(read_group_numbers(piece, group.grouping, types.size()));
    if (const XmlElement* aperture = find_array(piece.child("CellData"), kApertureTag)) {
      values.aperture = data_.doubles(*aperture);
      if (values.aperture.size() != types.size())
        data_.fail(*aperture, fmt::format("{} values for {} cells", values.aperture.size(), types.size()));
    }
    std::int64_t begin = 0;
    for (std::size_t i = 0; i < types.size(); ++i) {
      if (ends[i] < begin || ends[i] > static_cast<std::int64_t>(corners.size()))
        data_.fail(offset_array, fmt::format("cell {} ends outside the list of corners", i));
      add_cell(i, types[i],
               std::span(corners).subspan(static_cast<std::size_t>(begin),
                                          static_cast<std::size_t>(ends[i] - begin)),
               values);
      begin = ends[i];
    }
  }

  [[nodiscard]] VertexId corner(std::size_t cell, std::int64_t number) const {
    if (number < 0 || number >= static_cast<std::int64_t>(points_))
      refuse(fmt::format("cell {} names point {}, which does not exist", cell, number));
    return VertexId(first_point_ + static_cast<std::size_t>(number));
  }

  void add_cell(std::size_t cell, std::int64_t type, std::span<const std::int64_t> corners,
                const CellData& values) {
    constexpr std::int64_t kVertex = 1, kPolyVertex = 2, kLine = 3, kPolyLine = 4, kTriangle = 5,
                           kPolygon = 7, kPixel = 8, kQuad = 9;
    if (type == kVertex || type == kPolyVertex) return;
    // Of elements of second order the corners, which come first.
    constexpr std::array<std::array<std::int64_t, 4>, 4> kSecondOrder = {
        {{21, 3, kLine, 2}, {22, 6, kTriangle, 3}, {23, 8, kQuad, 4}, {28, 9, kQuad, 4}}};
    for (const auto& [second, nodes, first, count] : kSecondOrder)
      if (type == second && std::ssize(corners) == nodes) {
        type = first;
        corners = corners.first(static_cast<std::size_t>(count));
        break;
      }
    const std::size_t count = corners.size();
    if ((type == kLine && count == 2) || (type == kPolyLine && count >= 2))
      return add_lines(cell, corners, values);
    const bool triangle = count == 3 && (type == kTriangle || type == kPolygon);
    const bool quad = count == 4 && (type == kQuad || type == kPolygon || type == kPixel);
    if (!triangle && !quad)
      refuse(fmt::format(
          "cell {} is of VTK type {} with {} corners; only lines, triangles and quads are supported", cell,
          type, count));
    FaceCorners face;
    for (std::size_t k = 0; k < count; ++k) face[k] = corner(cell, corners[k]);
    if (type == kPixel) std::swap(face[2], face[3]);
    cells_.faces.push_back(face);
    cells_.regions.push_back(value_of(values.region, cell, 0));
    for (std::size_t i = 0; i < values.groups.size(); ++i)
      cells_.groups[i].of_faces.push_back(value_of(values.groups[i], cell, -1));
  }

  void add_lines(std::size_t cell, std::span<const std::int64_t> corners, const CellData& values) {
    for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
      cells_.edges.emplace_back(corner(cell, corners[k]), corner(cell, corners[k + 1]));
      cells_.constraints.push_back(value_of(values.constraint, cell, -1));
      cells_.kinds.push_back(value_of(values.kind, cell, 0));
      for (std::size_t i = 0; i < values.groups.size(); ++i)
        cells_.groups[i].of_edges.push_back(value_of(values.groups[i], cell, -1));
      cells_.apertures.push_back(values.aperture.empty() ? std::nan("") : values.aperture[cell]);
    }
  }

  static std::int32_t value_of(const std::vector<std::int64_t>& values, std::size_t cell,
                               std::int32_t missing) {
    return values.empty() ? missing : static_cast<std::int32_t>(values[cell]);
  }

  const std::string& path_;
  VtuData data_;
  ReadCells cells_;
  std::size_t first_point_ = 0;  // of the piece that is read
  std::size_t points_ = 0;       // in the piece that is read
  bool kinds_known_ = true;
};

}  // namespace

ReadCells read_vtu(const std::string& path) {
  const MappedFile file(path);
  const XmlElement root = parse_xml(path, file.text(), "AppendedData");
  if (root.name != "VTKFile") throw Error(ErrorKind::kInput, fmt::format("{}: it is no VTK XML file", path));
  return VtuReader(path, root).read(root);
}

}  // namespace quarry
