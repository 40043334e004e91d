#include <bit>

#include <fmt/format.h>

#include "io/mesh/numbering.hpp"
#include "io/mesh/ply_format.hpp"
#include "io/text_output.hpp"

namespace quarry {
namespace {

static_assert(std::endian::native == std::endian::little, "the bytes are written as they lie in memory");

std::string ply_header(const LiveNumbering& numbering, const std::vector<FieldText>& fields) {
  std::string text = "ply\nformat binary_little_endian 1.0\n";
  for (const FieldText& field : fields) text += fmt::format("comment {}: {}\n", field.name, field.text);
  text += fmt::format("element vertex {}\n", numbering.vertex_count());
  for (const char* name : {"x", "y", "z"}) text += fmt::format("property double {}\n", name);
  text += fmt::format("element face {}\n", numbering.face_count());
  text += "property list uchar int vertex_indices\nproperty int region\n";
  if (!numbering.edges().empty()) {
    text += fmt::format("element edge {}\n", numbering.edges().size());
    for (const char* name : {"vertex1", "vertex2", "constraint", "kind"})
      text += fmt::format("property int {}\n", name);
  }
  return text + "end_header\n";
}

}  // namespace

void write_ply(const std::string& path, const Mesh& mesh, const MeshWriteOptions& options) {
  AtomicFile file(path);
  const LiveNumbering numbering(mesh);
  const MeshFileTags tags(mesh);
  file.write(ply_header(numbering, options.fields));
  write_lines(file, numbering.vertex_count(), [&](TextLine line, std::size_t i) {
    const Vec3 p = mesh.point3(numbering.vertex(i));
    line.bytes(p.x).bytes(p.y).bytes(p.z);
  });
  write_lines(file, numbering.face_count(), [&](TextLine line, std::size_t i) {
    const FaceId f = numbering.face(i);
    const int corners = mesh.corner_count(f);
    line.bytes(static_cast<std::uint8_t>(corners));
    for (int k = 0; k < corners; ++k) line.bytes(numbering.number(mesh.corner(f, k)));
    line.bytes(tags.region(f));
  });
  write_lines(file, numbering.edges().size(), [&](TextLine line, std::size_t i) {
    const EdgeId e = numbering.edges()[i];
    const auto [a, b] = mesh.edge_ends(e);
    line.bytes(numbering.number(a)).bytes(numbering.number(b)).bytes(tags.constraint(e)).bytes(tags.kind(e));
  });
  file.commit();
}

}  // namespace quarry
