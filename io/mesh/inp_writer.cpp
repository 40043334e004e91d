#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "io/mesh/group_name.hpp"
#include "io/mesh/grouped_entities.hpp"
#include "io/mesh/inp_format.hpp"
#include "io/mesh/line_group_names.hpp"
#include "io/mesh/text_output.hpp"

namespace quarry {
namespace {

class InpWriter {
 public:
  InpWriter(const std::string& path, const Mesh& mesh, const MeshWriteOptions& options)
      : file_(path),
        mesh_(mesh),
        options_(options),
        numbering_(mesh),
        grouped_(group_entities(mesh, numbering_)),
        element_of_(mesh.face_slots()) {
    for (std::size_t i = 0; i < grouped_.faces.size(); ++i)
      element_of_[grouped_.faces[i]] = static_cast<std::uint32_t>(i + 1);
  }

  void write() {
    for (const FieldText& field : options_.fields)
      file_.write(fmt::format("** {}: {}\n", field.name, field.text));
    write_nodes();
    for (const FaceGroup& group : grouped_.face_groups) write_faces(group);
    std::size_t next = grouped_.faces.size() + 1;
    for (const EdgeGroup& group : grouped_.edge_groups) next = write_edges(group, next);
    write_line_groups();
    file_.commit();
  }

 private:
  void write_nodes() {
    file_.write("*NODE\n");
    write_lines(file_, numbering_.vertex_count(), [&](TextLine line, std::size_t i) {
      const Vec3 p = mesh_.point3(numbering_.vertex(i));
      line << i + 1 << ", " << p.x << ", " << p.y;
      if (!mesh_.planar()) line << ", " << p.z;
      line << "\n";
    });
  }

  void write_faces(const FaceGroup& group) {
    file_.write(fmt::format("*ELEMENT, TYPE={}{}, ELSET={}\n", mesh_.planar() ? "CPS" : "S", group.corners,
                            word_of(region_name(group.region, options_.names))));
    write_lines(file_, group.end - group.begin, [&](TextLine line, std::size_t i) {
      const FaceId f = grouped_.faces[group.begin + i];
      line << element_of_[f];
      for (int k = 0; k < group.corners; ++k) line << ", " << numbering_.number(mesh_.corner(f, k)) + 1;
      line << "\n";
    });
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
    const std::string name =
        outer ? std::string(kOuterBoundaryName) : word_of(line_name(group.constraint, options_.names));
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
    const LineGroupNames groups(mesh_, options_.line_groups);
    std::vector<std::vector<SideId>> sides(groups.all().size());
    for (const EdgeId e : grouped_.edges)
      if (const SideId side = side_of(e); side.valid())
        for (const std::size_t group : groups.of(e)) sides[group].push_back(side);
    for (std::size_t i = 0; i < sides.size(); ++i) {
      std::ranges::sort(sides[i]);
      sides[i].erase(std::ranges::unique(sides[i]).begin(), sides[i].end());
      write_surface(word_of(groups.all()[i]), sides[i]);
    }
  }

  AtomicFile file_;
  const Mesh& mesh_;
  const MeshWriteOptions& options_;
  LiveNumbering numbering_;
  GroupedEntities grouped_;
  IdVector<FaceId, std::uint32_t> element_of_;
};

}  // namespace

void write_inp(const std::string& path, const Mesh& mesh, const MeshWriteOptions& options) {
  InpWriter(path, mesh, options).write();
}

}  // namespace quarry
