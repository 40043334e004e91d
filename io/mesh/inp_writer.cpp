#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "io/mesh/cell_nodes.hpp"
#include "io/mesh/extra_groups.hpp"
#include "io/mesh/given_names.hpp"
#include "io/mesh/group_name.hpp"
#include "io/mesh/grouped_entities.hpp"
#include "io/mesh/inp_format.hpp"
#include "io/mesh/marked_points.hpp"
#include "io/text_output.hpp"

namespace quarry {
namespace {

// By the number of nodes.
std::string inp_face_type(int nodes, bool planar) {
  if (planar) return fmt::format("CPS{}", nodes);
  if (nodes == 6) return "STRI65";
  return nodes == 8 ? "S8R" : fmt::format("S{}", nodes);
}

class InpWriter {
 public:
  InpWriter(const std::string& path, const Mesh& mesh, const MeshWriteOptions& options)
      : file_(path),
        mesh_(mesh),
        options_(options),
        numbering_(mesh),
        nodes_(mesh, numbering_, options.order),
        grouped_(group_entities(mesh, numbering_)),
        names_(options.names, NameForm::kWord),
        element_of_(mesh.face_slots()) {
    for (std::size_t i = 0; i < grouped_.faces.size(); ++i)
      element_of_[grouped_.faces[i]] = static_cast<std::uint32_t>(i + 1);
  }

  void write() {
    for (const FieldText& field : options_.fields)
      file_.write(fmt::format("** {}: {}\n", field.name, field.text));
    write_nodes();
    for (const FaceGroup& group : grouped_.face_groups) write_faces(group);
    write_element_groups();
    std::size_t next = grouped_.faces.size() + 1;
    for (const EdgeGroup& group : grouped_.edge_groups) next = write_edges(group, next);
    write_node_sets();
    for (const MarkedPoint& point : marked_points(mesh_, numbering_))
      file_.write(
          fmt::format("*NSET, NSET={}\n{},\n", point_name(point.point, names_.numbered()), point.vertex + 1));
    write_line_groups();
    file_.commit();
  }

 private:
  void write_nodes() {
    file_.write("*NODE\n");
    write_lines(file_, nodes_.count(), [&](TextLine line, std::size_t i) {
      const Vec3 p = nodes_.point(i);
      line << i + 1 << ", " << p.x << ", " << p.y;
      if (!mesh_.planar()) line << ", " << p.z;
      line << "\n";
    });
  }

  void write_faces(const FaceGroup& group) {
    const int nodes = nodes_.face_count(grouped_.faces[group.begin]);
    file_.write(fmt::format("*ELEMENT, TYPE={}, ELSET={}\n", inp_face_type(nodes, mesh_.planar()),
                            region_name(group.region, names_.numbered())));
    write_lines(file_, group.end - group.begin, [&](TextLine line, std::size_t i) {
      const FaceId f = grouped_.faces[group.begin + i];
      line << element_of_[f];
      for (int k = 0; k < nodes; ++k) line << ", " << nodes_.face_node(f, k) + 1;
      line << "\n";
    });
  }

  // All faces of a region are in the same groups.
  void write_element_groups() {
    const ExtraGroups<FaceId> groups(mesh_, options_.groups, names_.of_regions());
    std::vector<std::vector<std::uint32_t>> elements(groups.all().size());
    for (const FaceGroup& group : grouped_.face_groups)
      for (const std::size_t extra : groups.of(grouped_.faces[group.begin]))
        for (std::size_t i = group.begin; i < group.end; ++i)
          elements[extra].push_back(element_of_[grouped_.faces[i]]);
    for (std::size_t i = 0; i < elements.size(); ++i) {
      file_.write(fmt::format("*ELSET, ELSET={}\n", groups.all()[i]));
      write_numbers(elements[i]);
    }
  }

  // The side of a face that an edge is, or none.
  [[nodiscard]] SideId side_of(EdgeId e) const {
    const auto [a, b] = mesh_.edge_ends(e);
    const SideId s = mesh_.find_side(a, b);
    return s.valid() ? s : mesh_.find_side(b, a);
  }

  // first: the number of the next element. Returns it after those that were written.
  std::size_t write_edges(const EdgeGroup& group, std::size_t first) {
    const bool outer = group.constraint < 0 && group.kind == kOuterBoundary;
    const std::string name = outer ? std::string(kOuterBoundaryName)
                                   : line_side_name(group.constraint, group.side, names_.numbered());
    std::vector<SideId> sides;
    std::vector<EdgeId> apart;
    for (std::size_t i = group.begin; i < group.end; ++i) {
      const SideId side = side_of(grouped_.edges[i]);
      if (side.valid())
        sides.push_back(side);
      else
        apart.push_back(grouped_.edges[i]);
    }
    write_surface(name, sides);
    if (!apart.empty())
      file_.write(fmt::format("*ELEMENT, TYPE={}, ELSET={}\n", mesh_.planar() ? "T2D2" : "T3D2", name));
    write_lines(file_, apart.size(), [&](TextLine line, std::size_t i) {
      const auto [a, b] = mesh_.edge_ends(apart[i]);
      line << first + i << ", " << numbering_.number(a) + 1 << ", " << numbering_.number(b) + 1 << "\n";
    });
    return first + apart.size();
  }

  // The nodes of each line, and of all of the boundary.
  void write_node_sets() {
    std::vector<std::size_t> boundary;
    for (std::size_t i = 0; i < grouped_.edge_groups.size();) {
      const std::int32_t constraint = grouped_.edge_groups[i].constraint, side = grouped_.edge_groups[i].side;
      std::vector<std::size_t> edges;
      for (; i < grouped_.edge_groups.size() && grouped_.edge_groups[i].constraint == constraint &&
             grouped_.edge_groups[i].side == side;
           ++i) {
        const EdgeGroup& group = grouped_.edge_groups[i];
        for (std::size_t k = group.begin; k < group.end; ++k) {
          edges.push_back(grouped_.edge_places[k]);
          if (group.kind == kOuterBoundary) boundary.push_back(grouped_.edge_places[k]);
        }
      }
      if (constraint >= 0) write_node_set(line_side_name(constraint, side, names_.numbered()), edges);
    }
    if (!boundary.empty()) write_node_set(std::string(kOuterBoundaryName), boundary);
  }

  void write_node_set(const std::string& name, const std::vector<std::size_t>& edges) {
    std::vector<std::uint32_t> nodes;
    for (const std::size_t edge : edges)
      for (int k = 0; k < nodes_.edge_count(); ++k) nodes.push_back(nodes_.edge_node(edge, k) + 1);
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    file_.write(fmt::format("*NSET, NSET={}\n", name));
    write_numbers(nodes);
  }

  void write_numbers(const std::vector<std::uint32_t>& numbers) {
    constexpr std::size_t kInLine = 16;
    write_lines(file_, (numbers.size() + kInLine - 1) / kInLine, [&](TextLine line, std::size_t i) {
      const std::size_t end = std::min(numbers.size(), (i + 1) * kInLine);
      for (std::size_t k = i * kInLine; k < end; ++k) line << numbers[k] << (k + 1 < end ? ", " : ",\n");
    });
  }

  void write_surface(const std::string& name, const std::vector<SideId>& sides) {
    if (sides.empty()) return;
    file_.write(fmt::format("*SURFACE, TYPE=ELEMENT, NAME={}\n", name));
    write_lines(file_, sides.size(), [&](TextLine line, std::size_t i) {
      line << element_of_[sides[i].face()] << (mesh_.planar() ? ", S" : ", E") << sides[i].index() + 1
           << "\n";
    });
  }

  // A piece of several lines of a group is in it once.
  void write_line_groups() {
    const ExtraGroups<EdgeId> groups(mesh_, options_.groups, names_.of_lines());
    std::vector<std::vector<SideId>> sides(groups.all().size());
    for (const EdgeId e : grouped_.edges)
      if (const SideId side = side_of(e); side.valid())
        for (const std::size_t group : groups.of(e)) sides[group].push_back(side);
    for (std::size_t i = 0; i < sides.size(); ++i) {
      std::ranges::sort(sides[i]);
      sides[i].erase(std::ranges::unique(sides[i]).begin(), sides[i].end());
      write_surface(groups.all()[i], sides[i]);
    }
  }

  AtomicFile file_;
  const Mesh& mesh_;
  const MeshWriteOptions& options_;
  LiveNumbering numbering_;
  CellNodes nodes_;
  GroupedEntities grouped_;
  FileNames names_;
  IdVector<FaceId, std::uint32_t> element_of_;
};

}  // namespace

void write_inp(const std::string& path, const Mesh& mesh, const MeshWriteOptions& options) {
  InpWriter(path, mesh, options).write();
}

}  // namespace quarry
