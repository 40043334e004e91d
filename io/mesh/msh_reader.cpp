#include <algorithm>
#include <limits>
#include <map>
#include <span>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "io/mapped_file.hpp"
#include "io/mesh/extra_groups.hpp"
#include "io/mesh/group_name.hpp"
#include "io/mesh/msh_format.hpp"
#include "io/mesh/msh_repeats.hpp"
#include "io/mesh/number_index.hpp"
#include "io/mesh/read_cells.hpp"
#include "io/text_cursor.hpp"

namespace quarry {
namespace {

// Corners of an element type, which are the first of its nodes; none where it is not one of ours.
struct MshType {
  int corners = 0, nodes = 0;
};

constexpr MshType msh_type(int type) {
  switch (type) {
    case 1:
      return {2, 2};  // line
    case 2:
      return {3, 3};  // triangle
    case 3:
      return {4, 4};  // quad
    case 8:
      return {2, 3};  // those of second order
    case 9:
      return {3, 6};
    case 10:
      return {4, 9};
    case 16:
      return {4, 8};
    case 15:
      return {1, 1};  // point
    default:
      return {};
  }
}

constexpr int dimension_of(int type) { return std::min(msh_type(type).corners - 1, 2); }

// An entity or physical group: its dimension and its tag.
using GroupKey = std::pair<int, std::int64_t>;

class MshReader {
 public:
  MshReader(const std::string& path, std::string_view text) : path_(path), cursor_(path, text) {}

  ReadCells read() {
    while (!cursor_.at_end()) {
      const std::string_view section = cursor_.word();
      cursor_.line();
      if (section == "$MeshFormat")
        read_format();
      else if (section == "$PhysicalNames")
        read_names();
      else if (section == "$Entities")
        read_entities();
      else if (section == "$Nodes")
        new_format_ ? read_nodes() : read_old_nodes();
      else if (section == "$Elements")
        new_format_ ? read_elements() : read_old_elements();
      seen_elements_ = seen_elements_ || section == "$Elements";
      skip_section(section);
    }
    if (!seen_format_)
      throw Error(ErrorKind::kInput, fmt::format("{}: no $MeshFormat: this is no Gmsh mesh", path_));
    if (!seen_elements_) cursor_.fail("no $Elements: the file ends too early, or holds geometry alone");
    regions_.settle(cells_.regions, cells_.names.regions);
    lines_.settle(cells_.constraints, cells_.names.lines);
    points_.settle(cells_.point_numbers, cells_.names.points);
    return std::move(cells_);
  }

 private:
  // Sections that are not read, and what is left of those that are.
  void skip_section(std::string_view section) {
    if (section.size() < 2 || section[0] != '$') cursor_.fail("a section that starts with $ is expected");
    const std::string end = fmt::format("$End{}", section.substr(1));
    while (true) {
      if (cursor_.at_end()) cursor_.fail(fmt::format("{} is missing", end));
      std::string_view line = cursor_.line();
      while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
      if (line == end) return;
    }
  }

  void read_format() {
    const std::string_view version = cursor_.word();
    new_format_ = version == "4.1";
    if (!new_format_ && version != "2.2" && version != "2.1" && version != "2")
      cursor_.fail(fmt::format("Gmsh format {} is not known; save as 4.1 or 2.2", version));
    binary_ = cursor_.number<int>("0 for ASCII or 1 for binary") != 0;
    if (cursor_.number<int>("a data size") != 8)
      cursor_.fail("the data size is not 8: save it again with gmsh");
    cursor_.line();
    if (binary_ && cursor_.raw<std::int32_t>() != 1)
      cursor_.fail(
          "the bytes are in the order of another sort of machine; save it as ASCII (gmsh -save -bin 0)");
    seen_format_ = true;
  }

  // Numbers as text, or as the format has them in its binary form: tags of entities, types and dimensions in
  // four bytes, counts and tags of nodes and elements in eight (four in the old format).
  std::int64_t integer(const char* what) {
    return binary_ ? cursor_.raw<std::int32_t>() : cursor_.number<std::int64_t>(what);
  }
  std::int64_t size(const char* what) {
    if (!binary_) return cursor_.number<std::int64_t>(what);
    const auto value = cursor_.raw<std::uint64_t>();
    if (value > std::numeric_limits<std::int64_t>::max() / 2)
      cursor_.fail(fmt::format("{} is {}", what, value));
    return static_cast<std::int64_t>(value);
  }
  double coordinate() { return binary_ ? cursor_.raw<double>() : cursor_.number<double>("a coordinate"); }

  void read_names() {
    for (auto left = cursor_.number<std::int64_t>("the number of names"); left > 0; --left) {
      const int dimension = cursor_.number<int>("a dimension");
      const auto tag = cursor_.number<std::int64_t>("a tag");
      names_[{dimension, tag}] = std::string(cursor_.quoted());
    }
  }

  void read_entities() {
    std::int64_t counts[4];
    for (std::int64_t& count : counts) count = size("a number of entities");
    for (int dimension = 0; dimension < 4; ++dimension)
      for (std::int64_t i = 0; i < counts[dimension]; ++i) {
        const std::int64_t tag = integer("a tag");
        for (int k = 0; k < (dimension == 0 ? 3 : 6); ++k) coordinate();
        std::vector<std::int64_t>& groups = groups_of_entity_[{dimension, tag}];
        for (auto left = size("a number of groups"); left > 0; --left) groups.push_back(integer("a tag"));
        if (dimension == 0) continue;
        for (auto left = size("a number of entities"); left > 0; --left) integer("a tag");
      }
  }

  void add_point(std::int64_t tag) {
    if (!point_of_tag_.add(tag, static_cast<std::uint32_t>(cells_.x.size())))
      cursor_.fail(fmt::format("node {} is given twice", tag));
    cells_.x.push_back(coordinate());
    cells_.y.push_back(coordinate());
    cells_.z.push_back(coordinate());
  }

  // The number of blocks; three totals follow it.
  std::int64_t read_block_count() {
    const std::int64_t blocks = size("the number of blocks");
    for (int k = 0; k < 3; ++k) size("a total");
    return blocks;
  }

  void read_nodes() {
    std::vector<std::int64_t> tags;
    for (auto blocks = read_block_count(); blocks > 0; --blocks) {
      const std::int64_t dimension = integer("a dimension");
      integer("a tag");
      const bool parametric = integer("0 or 1") != 0;
      tags.clear();
      for (auto left = size("a number of nodes"); left > 0; --left) tags.push_back(size("a node tag"));
      for (const std::int64_t tag : tags) {
        add_point(tag);
        for (int k = 0; parametric && k < dimension; ++k) coordinate();
      }
    }
  }

  // The count is text in either form.
  std::int64_t read_old_count(const char* what) {
    const auto count = cursor_.number<std::int64_t>(what);
    cursor_.line();
    return count;
  }

  void read_old_nodes() {
    for (auto left = read_old_count("the number of nodes"); left > 0; --left)
      add_point(integer("a node tag"));
  }

  VertexId corner(std::int64_t tag) const {
    const std::uint32_t point = point_of_tag_.find(tag);
    if (point == NumberIndex::kNone) cursor_.fail(fmt::format("node {} does not exist", tag));
    return VertexId(point);
  }

  // numbers: of its groups; a face is in the first of them, and a point needs none.
  void read_cell(int type, std::span<const std::int32_t> numbers) {
    FaceCorners corners;
    const auto [count, nodes] = msh_type(type);
    for (int k = 0; k < nodes; ++k) {
      const VertexId node = corner(new_format_ ? size("a node tag") : integer("a node tag"));
      if (k < count) corners[static_cast<std::size_t>(k)] = node;
    }
    if (count == 1) {
      cells_.points.insert(cells_.points.end(), numbers.size(), corners[0]);
      cells_.point_numbers.insert(cells_.point_numbers.end(), numbers.begin(), numbers.end());
    } else if (count >= 3) {
      cells_.faces.push_back(corners);
      cells_.regions.push_back(numbers.front());
    } else {
      for (const std::int32_t number : numbers) {
        cells_.edges.emplace_back(corners[0], corners[1]);
        cells_.constraints.push_back(number);
      }
    }
  }

  void check_type(int type) const {
    if (msh_type(type).nodes == 0)
      cursor_.fail(fmt::format(
          "element type {} is not supported; only points, lines, triangles and quads of first and "
          "second order are",
          type));
  }

  [[nodiscard]] std::string_view name_of(int dimension, std::int64_t tag) const {
    const auto name = names_.find({dimension, tag});
    return name == names_.end() ? std::string_view() : std::string_view(name->second);
  }

  // The region or line number that a group stands for.
  std::int32_t number_of_group(int dimension, std::int64_t tag) {
    GroupNumbers& numbers = dimension == 0 ? points_ : dimension == 1 ? lines_ : regions_;
    if (const auto name = names_.find({dimension, tag}); name != names_.end())
      return numbers.number(name->second);
    if (tag >= 0 && tag <= std::numeric_limits<std::int32_t>::max()) return static_cast<std::int32_t>(tag);
    return numbers.number_of_nameless(fmt::format("#{}", tag));
  }

  // Those of the groups of an entity; the outer boundary is no line of its own where there are others.
  std::vector<std::int32_t> numbers_of_entity(int dimension, std::int64_t tag) {
    const auto entity = groups_of_entity_.find({dimension, tag});
    std::vector<std::int32_t> numbers;
    if (entity != groups_of_entity_.end()) {
      const auto is_line = [&](std::int64_t group) { return name_of(dimension, group).starts_with("line_"); };
      const bool lines = dimension == 1 && std::ranges::any_of(entity->second, is_line);
      for (const std::int64_t group : entity->second)
        if (!lines || !is_extra_line_group(name_of(dimension, group)))
          numbers.push_back(number_of_group(dimension, group));
    }
    if (std::any_of(numbers.begin(), numbers.end(), [](std::int32_t n) { return n != -1; }))
      std::erase(numbers, -1);
    if (numbers.empty() && dimension != 0)
      numbers.push_back(dimension == 2 ? regions_.number_of_nameless(fmt::format("surface {}", tag)) : -1);
    return numbers;
  }

  void read_elements() {
    for (auto blocks = read_block_count(); blocks > 0; --blocks) {
      const auto dimension = static_cast<int>(integer("a dimension"));
      const std::int64_t entity = integer("a tag");
      const auto type = static_cast<int>(integer("an element type"));
      check_type(type);
      if (dimension_of(type) != dimension)
        cursor_.fail(fmt::format("elements of type {} in an entity of dimension {}", type, dimension));
      const std::vector<std::int32_t> numbers = numbers_of_entity(dimension, entity);
      for (auto left = size("a number of elements"); left > 0; --left) {
        size("an element tag");
        read_cell(type, numbers);
      }
    }
  }

  // One element; its tags begin with that of its group.
  void read_old_element(int type, std::int64_t tags) {
    std::int64_t group = 0;
    for (std::int64_t k = 0; k < tags; ++k) {
      const std::int64_t tag = integer("a tag");
      if (k == 0) group = tag;
    }
    const int dimension = dimension_of(type);
    if (dimension == 0 && group == 0) return read_cell(type, {});
    if (dimension == 1) line_groups_.push_back(group);
    const std::int32_t number = dimension == 1 ? -1 : number_of_group(dimension, group);
    read_cell(type, {&number, 1});
  }

  [[nodiscard]] LineGroup kind_of(std::int64_t group) const {
    const std::string_view name = name_of(1, group);
    if (group == 0 || name == kOuterBoundaryName) return LineGroup::kNone;
    if (name.starts_with("line_")) return LineGroup::kLine;
    return is_extra_line_group(name) ? LineGroup::kExtra : LineGroup::kOther;
  }

  // Elements of several groups, which an old file has once for each, become one as in a new file. Lines get
  // their numbers here: groups that are left out take none.
  void join_repeats() {
    std::vector<LineGroup> kinds;
    for (const std::int64_t group : line_groups_) kinds.push_back(kind_of(group));
    const std::vector<std::uint8_t> needless = find_needless_edges(cells_.edges, kinds);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < needless.size(); ++i) {
      if (needless[i] != 0) continue;
      cells_.edges[kept] = cells_.edges[i];
      cells_.constraints[kept++] = line_groups_[i] == 0 ? -1 : number_of_group(1, line_groups_[i]);
    }
    cells_.edges.resize(kept);
    cells_.constraints.resize(kept);
    const std::vector<std::uint8_t> repeated = find_repeated_faces(cells_.faces, cells_.regions);
    kept = 0;
    for (std::size_t f = 0; f < repeated.size(); ++f) {
      if (repeated[f] != 0) continue;
      cells_.faces[kept] = cells_.faces[f];
      cells_.regions[kept++] = cells_.regions[f];
    }
    cells_.faces.resize(kept);
    cells_.regions.resize(kept);
  }

  void read_old_elements() {
    for (auto left = read_old_count("the number of elements"); left > 0;) {
      if (!binary_) integer("an element tag");
      const auto type = static_cast<int>(integer("an element type"));
      check_type(type);
      // In the binary form elements of a sort come together.
      const std::int64_t together = binary_ ? integer("a number of elements") : 1;
      const std::int64_t tags = integer("a number of tags");
      if (together < 1 || together > left) cursor_.fail(fmt::format("{} elements in a block", together));
      for (std::int64_t i = 0; i < together; ++i) {
        if (binary_) integer("an element tag");
        read_old_element(type, tags);
      }
      left -= together;
    }
    join_repeats();
  }

  std::string path_;
  TextCursor cursor_;
  ReadCells cells_;
  bool seen_format_ = false;
  bool seen_elements_ = false;
  bool new_format_ = false;
  bool binary_ = false;
  std::map<GroupKey, std::string> names_;
  std::map<GroupKey, std::vector<std::int64_t>> groups_of_entity_;
  NumberIndex point_of_tag_;
  std::vector<std::int64_t> line_groups_;  // of an old file, by line element
  GroupNumbers regions_ = region_numbers();
  GroupNumbers lines_ = line_numbers();
  GroupNumbers points_ = point_numbers();
};

}  // namespace

ReadCells read_msh(const std::string& path) {
  const MappedFile file(path);
  return MshReader(path, file.text()).read();
}

}  // namespace quarry
