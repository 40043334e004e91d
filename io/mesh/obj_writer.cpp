#include <fmt/format.h>

#include "io/mesh/given_names.hpp"
#include "io/mesh/group_name.hpp"
#include "io/mesh/grouped_entities.hpp"
#include "io/mesh/obj_format.hpp"
#include "io/text_output.hpp"

namespace quarry {
namespace {

std::string group_line(const EdgeGroup& group, const GroupNames& names) {
  if (group.kind != kOuterBoundary) return fmt::format("g {}\n", line_name(group.constraint, names));
  if (group.constraint < 0) return fmt::format("g {}\n", kOuterBoundaryName);
  return fmt::format("g {} {}\n", line_name(group.constraint, names), kOuterBoundaryName);
}

}  // namespace

void write_obj(const std::string& path, const Mesh& mesh, const MeshWriteOptions& options) {
  AtomicFile file(path);
  for (const FieldText& field : options.fields) file.write(fmt::format("# {}: {}\n", field.name, field.text));
  const LiveNumbering numbering(mesh);
  write_lines(file, numbering.vertex_count(), [&](TextLine line, std::size_t i) {
    const Vec3 p = mesh.point3(numbering.vertex(i));
    line << "v " << p.x << " " << p.y << " " << p.z << "\n";
  });
  const GroupNames names = FileNames(options.names, NameForm::kWord).numbered();
  const GroupedEntities grouped = group_entities(mesh, numbering);
  for (const FaceGroup& group : grouped.face_groups) {
    file.write(fmt::format("g {}\n", region_name(group.region, names)));
    write_lines(file, group.end - group.begin, [&](TextLine line, std::size_t i) {
      const FaceId f = grouped.faces[group.begin + i];
      line << "f";
      for (int k = 0; k < group.corners; ++k) line << " " << numbering.number(mesh.corner(f, k)) + 1;
      line << "\n";
    });
  }
  for (const EdgeGroup& group : grouped.edge_groups) {
    file.write(group_line(group, names));
    write_lines(file, group.end - group.begin, [&](TextLine line, std::size_t i) {
      const auto [a, b] = mesh.edge_ends(grouped.edges[group.begin + i]);
      line << "l " << numbering.number(a) + 1 << " " << numbering.number(b) + 1 << "\n";
    });
  }
  file.commit();
}

}  // namespace quarry
