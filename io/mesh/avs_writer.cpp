#include <fmt/format.h>

#include "io/mesh/avs_format.hpp"
#include "io/mesh/material_numbers.hpp"
#include "io/text_output.hpp"

namespace quarry {

void write_avs(const std::string& path, const Mesh& mesh, const MeshWriteOptions& options) {
  AtomicFile file(path);
  const LiveNumbering numbering(mesh);
  const MaterialNumbers materials(mesh, numbering);
  const MeshFileTags tags(mesh);
  const std::size_t faces = numbering.face_count(), cells = faces + numbering.edges().size();
  for (const FieldText& field : options.fields) file.write(fmt::format("# {}: {}\n", field.name, field.text));
  file.write(fmt::format("{} {} 0 3 0\n", numbering.vertex_count(), cells));
  write_lines(file, numbering.vertex_count(), [&](TextLine line, std::size_t i) {
    const Vec3 p = mesh.point3(numbering.vertex(i));
    line << i + 1 << " " << p.x << " " << p.y << " " << p.z << "\n";
  });
  write_lines(file, cells, [&](TextLine line, std::size_t i) {
    if (i < faces) {
      const FaceId f = numbering.face(i);
      line << i + 1 << " " << materials.of(f) + 1 << (mesh.corner_count(f) == 4 ? " quad" : " tri");
      for (int k = 0; k < mesh.corner_count(f); ++k) line << " " << numbering.number(mesh.corner(f, k)) + 1;
      line << "\n";
    } else {
      const EdgeId e = numbering.edges()[i - faces];
      const auto [a, b] = mesh.edge_ends(e);
      line << i + 1 << " " << materials.of(e) + 1 << " line " << numbering.number(a) + 1 << " "
           << numbering.number(b) + 1 << "\n";
    }
  });
  file.write("3 1 1 1\nregion, none\nconstraint, none\nkind, none\n");
  write_lines(file, cells, [&](TextLine line, std::size_t i) {
    line << i + 1 << " ";
    if (i < faces)
      line << tags.region(numbering.face(i)) << " -1 0\n";
    else
      line << "-1 " << tags.constraint(numbering.edges()[i - faces]) << " "
           << tags.kind(numbering.edges()[i - faces]) << "\n";
  });
  file.commit();
}

}  // namespace quarry
