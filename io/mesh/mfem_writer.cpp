#include <algorithm>

#include <fmt/format.h>

#include "io/mesh/mfem_format.hpp"
#include "io/mesh/single_edges.hpp"
#include "io/text_output.hpp"

namespace quarry {
namespace {

constexpr int kMfemSegment = 1;
constexpr int kMfemTriangle = 2;
constexpr int kMfemSquare = 3;

// Those that are a side of a face.
std::vector<EdgeId> boundary_elements(const Mesh& mesh, const LiveNumbering& numbering) {
  std::vector<EdgeId> edges;
  for (const std::uint32_t i : single_edges(mesh, numbering)) {
    const auto [a, b] = mesh.edge_ends(numbering.edges()[i]);
    if (mesh.find_side(a, b).valid() || mesh.find_side(b, a).valid()) edges.push_back(numbering.edges()[i]);
  }
  return edges;
}

}  // namespace

void write_mfem(const std::string& path, const Mesh& mesh, const MeshWriteOptions& options) {
  AtomicFile file(path);
  const LiveNumbering numbering(mesh);
  const MeshFileTags tags(mesh);
  std::int64_t lowest = 0;
  for (std::size_t i = 0; i < numbering.face_count(); ++i)
    lowest = std::min<std::int64_t>(lowest, tags.region(numbering.face(i)));
  file.write("MFEM mesh v1.0\n\n");
  for (const FieldText& field : options.fields) file.write(fmt::format("# {}: {}\n", field.name, field.text));
  file.write(fmt::format("\ndimension\n2\n\nelements\n{}\n", numbering.face_count()));
  write_lines(file, numbering.face_count(), [&](TextLine line, std::size_t i) {
    const FaceId f = numbering.face(i);
    const int corners = mesh.corner_count(f);
    line << tags.region(f) - lowest + 1 << " " << (corners == 4 ? kMfemSquare : kMfemTriangle);
    for (int k = 0; k < corners; ++k) line << " " << numbering.number(mesh.corner(f, k));
    line << "\n";
  });
  const std::vector<EdgeId> edges = boundary_elements(mesh, numbering);
  file.write(fmt::format("\nboundary\n{}\n", edges.size()));
  write_lines(file, edges.size(), [&](TextLine line, std::size_t i) {
    const auto [a, b] = mesh.edge_ends(edges[i]);
    line << std::int64_t{tags.constraint(edges[i])} + 2 << " " << kMfemSegment << " " << numbering.number(a)
         << " " << numbering.number(b) << "\n";
  });
  file.write(fmt::format("\nvertices\n{}\n{}\n", numbering.vertex_count(), mesh.planar() ? 2 : 3));
  write_lines(file, numbering.vertex_count(), [&](TextLine line, std::size_t i) {
    const Vec3 p = mesh.point3(numbering.vertex(i));
    line << p.x << " " << p.y;
    if (!mesh.planar()) line << " " << p.z;
    line << "\n";
  });
  file.commit();
}

}  // namespace quarry
