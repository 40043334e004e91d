#include <algorithm>
#include <array>
#include <optional>

#include <cctype>
#include <fmt/format.h>

#include "io/lower_case.hpp"
#include "io/mapped_file.hpp"
#include "io/mesh/extra_groups.hpp"
#include "io/mesh/group_name.hpp"
#include "io/mesh/inp_format.hpp"
#include "io/mesh/inp_line.hpp"
#include "io/mesh/inp_sets.hpp"
#include "io/mesh/number_index.hpp"
#include "io/text_cursor.hpp"

namespace quarry {
namespace {

// A set of nodes; numbers of at most two are kept, since only one alone is a point.
struct NodeSet {
  std::string name;
  std::vector<std::int64_t> nodes;
};

// The same side of all elements of a set, or of one element.
struct SurfacePart {
  std::string name;
  std::string set;  // empty: of one element
  std::int64_t element;
  int side;
};

struct LineElement {
  std::pair<VertexId, VertexId> ends;
  std::int64_t number;
  std::int32_t group;  // of the *ELEMENT that it stands in
};

bool starts_with_digit(std::string_view text) {
  return !text.empty() && std::isdigit(static_cast<unsigned char>(text.front())) != 0;
}

class InpReader {
 public:
  InpReader(const std::string& path, std::string_view text) : cursor_(path, text) {}

  ReadCells read() {
    while (!cursor_.at_end()) {
      const std::string_view line = trimmed(cursor_.line());
      if (line.starts_with("**")) continue;
      if (line.starts_with("*"))
        read_keyword(line);
      else
        read_data(line);
    }
    end_element();
    group_faces();
    add_line_elements();
    add_surfaces();
    add_points();
    regions_.settle(cells_.regions, cells_.names.regions);
    lines_.settle(cells_.constraints, cells_.names.lines);
    return std::move(cells_);
  }

 private:
  enum class Mode { kSkip, kNodes, kElements, kSet, kRanges, kNodeSet, kSurface };

  [[noreturn]] void fail(const std::string& message) const { cursor_.fail(message); }

  std::int64_t whole(std::string_view field, const char* what) {
    return cursor_.parse<std::int64_t>(field, what);
  }

  void read_keyword(std::string_view line) {
    end_element();
    std::string text(line);
    while (text.ends_with(',') && !cursor_.at_end()) text += trimmed(cursor_.line());
    const InpKeyword keyword = parse_keyword(text);
    mode_ = Mode::kSkip;
    if (keyword.name == "NODE") {
      begin_nodes(keyword);
    } else if (keyword.name == "ELEMENT") {
      begin_elements(keyword);
    } else if (keyword.name == "ELSET") {
      sets_.open(keyword.value("ELSET"), keyword.has("INTERNAL"));
      mode_ = keyword.has("GENERATE") ? Mode::kRanges : Mode::kSet;
    } else if (keyword.name == "NSET") {
      if (keyword.has("GENERATE") || keyword.has("INTERNAL")) return;
      node_sets_.push_back({keyword.value("NSET"), {}});
      mode_ = Mode::kNodeSet;
    } else if (keyword.name == "SURFACE") {
      const std::string type = upper_case(keyword.value("TYPE"));
      surface_ = keyword.value("NAME");
      if (type.empty() || type == "ELEMENT") mode_ = Mode::kSurface;
    } else if (keyword.name == "PART") {
      ++part_;
    } else if (keyword.name.ends_with("SECTION") && keyword.has("ELSET")) {
      sections_.push_back(keyword.value("ELSET"));
    } else {
      refuse_generators(keyword);
    }
  }

  void refuse_generators(const InpKeyword& keyword) const {
    constexpr std::array kRefused = {"INCLUDE", "NGEN",  "NFILL",  "NCOPY",
                                     "NMAP",    "ELGEN", "ELCOPY", "SYSTEM"};
    if (std::find(kRefused.begin(), kRefused.end(), keyword.name) != kRefused.end())
      fail(fmt::format("*{} is not supported: write nodes and elements out in one file", keyword.name));
  }

  void begin_nodes(const InpKeyword& keyword) {
    if (keyword.has("INPUT") || keyword.has("SYSTEM"))
      fail("*NODE with INPUT or SYSTEM is not supported: write Cartesian coordinates into this file");
    if (part_of_nodes_.value_or(part_) != part_)
      fail("a second *PART with nodes: only meshes of one part are read; export one part");
    part_of_nodes_ = part_;
    mode_ = Mode::kNodes;
  }

  void begin_elements(const InpKeyword& keyword) {
    if (keyword.has("INPUT")) fail("*ELEMENT with INPUT is not supported: write the elements into this file");
    type_ = upper_case(keyword.value("TYPE"));
    set_ = keyword.value("ELSET");
    if (type_.starts_with("C3D"))
      fail(fmt::format("elements of type {} are solids: only lines, triangles and quads are read", type_));
    mode_ = Mode::kElements;
  }

  void read_data(std::string_view line) {
    switch (mode_) {
      case Mode::kNodes:
        return read_node(line);
      case Mode::kElements:
        return read_element(line);
      case Mode::kSet:
        return read_set(line);
      case Mode::kRanges:
        return read_range(line);
      case Mode::kNodeSet:
        return read_node_set(line);
      case Mode::kSurface:
        return read_surface(line);
      case Mode::kSkip:
        return;
    }
  }

  void read_node(std::string_view line) {
    InpFields fields(line);
    const std::int64_t number = whole(fields.next(), "the number of a node");
    std::array<double, 3> p{};
    for (std::size_t k = 0; k < 3 && !fields.at_end(); ++k) p[k] = coordinate(fields.next());
    if (!node_of_.add(number, static_cast<std::uint32_t>(cells_.x.size())))
      fail(fmt::format("node {} is given twice", number));
    cells_.x.push_back(p[0]);
    cells_.y.push_back(p[1]);
    cells_.z.push_back(p[2]);
  }

  double coordinate(std::string_view field) {
    if (field.empty()) return 0;
    if (const std::size_t d = field.find_first_of("dD"); d != std::string_view::npos) {
      // Fortran's exponent of double precision.
      std::string digits(field);
      digits[d] = 'e';
      return cursor_.parse<double>(digits, "a coordinate");
    }
    return cursor_.parse<double>(field, "a coordinate");
  }

  // The numbers of an element may go on after a comma at the end of a line.
  void read_element(std::string_view line) {
    InpFields fields(line);
    while (!fields.at_end())
      element_.push_back(whole(fields.next(), element_.empty() ? "the number of an element" : "a node"));
    if (!line.ends_with(',')) end_element();
  }

  // The corners come first: three of six nodes, four of eight or nine. Solids have as many.
  [[nodiscard]] std::size_t corners_of_second_order(std::size_t nodes) const {
    const bool flat =
        type_.starts_with("M3D") || (type_.find("3D") == std::string::npos && !type_.starts_with("SC"));
    if (flat && nodes == 6) return 3;
    return flat && (nodes == 8 || nodes == 9) ? 4 : nodes;
  }

  void end_element() {
    if (element_.empty()) return;
    const std::int64_t number = element_[0];
    const std::size_t nodes = element_.size() - 1;
    const std::size_t count = corners_of_second_order(nodes);
    const bool line_of_three = count == 3 && (type_.starts_with("T") || type_.starts_with("B") ||
                                              type_.starts_with("PIPE") || type_ == "SAX2");
    if (count == 0 || count > 4 || line_of_three)
      fail(fmt::format(
          "element {} of type {} has {} nodes: only lines of first order, triangles and quads are read",
          number, type_, nodes));
    FaceCorners corners;
    for (std::size_t k = 0; k < count; ++k) corners[k] = node(element_[k + 1]);
    element_.clear();
    if (count == 1) return;
    if (count == 2) {
      line_elements_.push_back({{corners[0], corners[1]}, number, group(lines_, set_, -1)});
      return;
    }
    if (!face_of_.add(number, static_cast<std::uint32_t>(cells_.faces.size())))
      fail(fmt::format("element {} is given twice", number));
    cells_.faces.push_back(corners);
    cells_.regions.push_back(group(regions_, set_, -1));
    named_by_us_.push_back(lower_case(set_).starts_with("region_"));
  }

  VertexId node(std::int64_t number) const {
    const std::uint32_t index = node_of_.find(number);
    if (index == NumberIndex::kNone) fail(fmt::format("node {} does not exist", number));
    return VertexId(index);
  }

  void read_set(std::string_view line) {
    InpFields fields(line);
    while (!fields.at_end()) {
      const std::string_view field = fields.next();
      if (field.empty()) continue;
      if (starts_with_digit(field)) {
        const std::int64_t number = whole(field, "the number of an element");
        sets_.add({number, number, 1});
      } else {
        sets_.add_set(field);
      }
    }
  }

  // Sets within sets have names for numbers: such a set is taken for one of many nodes.
  void read_node_set(std::string_view line) {
    std::vector<std::int64_t>& nodes = node_sets_.back().nodes;
    InpFields fields(line);
    while (!fields.at_end() && nodes.size() < 2) {
      const std::string_view field = fields.next();
      if (field.empty()) continue;
      if (starts_with_digit(field))
        nodes.push_back(whole(field, "the number of a node"));
      else
        nodes.assign(2, -1);
    }
  }

  void read_range(std::string_view line) {
    InpFields fields(line);
    InpSets::Range range{};
    range.first = whole(fields.next(), "the first number");
    range.last = whole(fields.next(), "the last number");
    range.step = fields.at_end() ? 1 : whole(fields.next(), "a step");
    if (range.step < 1 || range.last < range.first || range.first < 0)
      fail(fmt::format("{} to {} in steps of {} is no range", range.first, range.last, range.step));
    // More numbers than any file has elements: a slip that would take hours.
    if ((range.last - range.first) / range.step > std::int64_t{1} << 28)
      fail(fmt::format("{} to {} are more elements than a mesh can have", range.first, range.last));
    sets_.add(range);
  }

  // "SET, S2": S and E name sides of faces; SPOS and SNEG mean the faces themselves.
  void read_surface(std::string_view line) {
    InpFields fields(line);
    const std::string_view elements = fields.next();
    const std::string side = upper_case(fields.next());
    if (side.size() != 2 || (side[0] != 'S' && side[0] != 'E') || side[1] < '1' || side[1] > '4') return;
    if (starts_with_digit(elements))
      surfaces_.push_back({surface_, "", whole(elements, "the number of an element"), side[1] - '1'});
    else
      surfaces_.push_back({surface_, std::string(elements), -1, side[1] - '1'});
  }

  // The number of a set's group; ours are written in lower case and read in any.
  std::int32_t group(GroupNumbers& numbers, const std::string& name, std::int32_t none) {
    if (name.empty()) return none;
    const std::string lower = lower_case(name);
    const bool ours =
        lower.starts_with("region_") || lower.starts_with("line_") || lower == kOuterBoundaryName;
    return numbers.number(ours ? lower : name);
  }

  // Faces that no set holds are one region of their own. What names sets have beside "region_<n>" is told of
  // regions, not of parts of them.
  void group_faces() {
    std::vector<bool> held = named_by_us_;
    const auto take = [&](std::size_t set, bool again) {
      const std::int32_t number = group(regions_, sets_.name(set), -1);
      sets_.for_each(set, [&](std::int64_t element) {
        const std::uint32_t face = face_of_.find(element);
        if (face == NumberIndex::kNone || (held[face] && !again)) return;
        cells_.regions[face] = number;
        held[face] = true;
      });
    };
    for (std::size_t set = 0; set < sets_.size(); ++set)
      if (!sets_.internal(set) && count_faces(set) < cells_.faces.size()) take(set, false);
    for (const std::string& section : sections_)
      if (const std::size_t set = sets_.find(section); set < sets_.size()) take(set, true);
    for (std::int32_t& region : cells_.regions)
      if (region == -1) region = regions_.number_of_nameless("no set");
  }

  [[nodiscard]] std::size_t count_faces(std::size_t set) const {
    std::size_t count = 0;
    sets_.for_each(set, [&](std::int64_t element) {
      if (face_of_.find(element) != NumberIndex::kNone) ++count;
    });
    return count;
  }

  void add_edge(std::pair<VertexId, VertexId> ends, std::int32_t number) {
    cells_.edges.push_back(ends);
    cells_.constraints.push_back(number);
  }

  void add_line_elements() {
    if (line_elements_.empty()) return;
    NumberIndex line_of;
    for (std::uint32_t i = 0; i < line_elements_.size(); ++i) line_of.add(line_elements_[i].number, i);
    std::vector<bool> held(line_elements_.size(), false);
    for (std::size_t set = 0; set < sets_.size(); ++set) {
      if (sets_.internal(set)) continue;
      sets_.for_each(set, [&](std::int64_t element) {
        const std::uint32_t line = line_of.find(element);
        if (line == NumberIndex::kNone) return;
        add_edge(line_elements_[line].ends, group(lines_, sets_.name(set), -1));
        held[line] = true;
      });
    }
    for (std::size_t i = 0; i < line_elements_.size(); ++i)
      if (!held[i]) add_edge(line_elements_[i].ends, line_elements_[i].group);
  }

  void add_surfaces() {
    // Groups of lines tell nothing new where the lines themselves are there.
    const bool lines = std::ranges::any_of(
        surfaces_, [](const SurfacePart& part) { return lower_case(part.name).starts_with("line_"); });
    for (const SurfacePart& part : surfaces_) {
      if (lines && is_extra_line_group(part.name)) continue;
      const std::int32_t number = group(lines_, part.name, -1);
      const auto add_side = [&](std::int64_t element) {
        const std::uint32_t face = face_of_.find(element);
        if (face == NumberIndex::kNone) return;
        const FaceCorners& corners = cells_.faces[face];
        const int count = corners[3].valid() ? 4 : 3;
        if (part.side >= count) return;
        add_edge({corners[static_cast<std::size_t>(part.side)],
                  corners[static_cast<std::size_t>((part.side + 1) % count)]},
                 number);
      };
      if (part.set.empty())
        add_side(part.element);
      else if (const std::size_t set = sets_.find(part.set); set < sets_.size())
        sets_.for_each(set, add_side);
    }
  }

  void add_points() {
    for (const NodeSet& set : node_sets_) {
      // Of parts and programs that are not read there may be others.
      const std::uint32_t vertex =
          set.nodes.size() == 1 ? node_of_.find(set.nodes.front()) : NumberIndex::kNone;
      if (vertex == NumberIndex::kNone) continue;
      const std::string lower = lower_case(set.name);
      cells_.points.emplace_back(vertex);
      cells_.point_numbers.push_back(points_.number(lower.starts_with("point_") ? lower : set.name));
    }
    points_.settle(cells_.point_numbers, cells_.names.points);
  }

  TextCursor cursor_;
  ReadCells cells_;
  Mode mode_ = Mode::kSkip;
  int part_ = 0;
  std::optional<int> part_of_nodes_;
  std::string type_, set_, surface_;   // of the keyword that is read
  std::vector<std::int64_t> element_;  // its number and nodes so far
  NumberIndex node_of_, face_of_;
  std::vector<LineElement> line_elements_;
  std::vector<std::string> sections_;
  std::vector<SurfacePart> surfaces_;
  std::vector<NodeSet> node_sets_;
  InpSets sets_;
  std::vector<bool> named_by_us_;  // one for each face
  GroupNumbers regions_ = region_numbers();
  GroupNumbers lines_ = line_numbers();
  GroupNumbers points_ = point_numbers();
};

}  // namespace

ReadCells read_inp(const std::string& path) {
  const MappedFile file(path);
  return InpReader(path, file.text()).read();
}

}  // namespace quarry
