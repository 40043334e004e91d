#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "io/mesh/numbering.hpp"
#include "io/mesh/stl_format.hpp"
#include "io/text_output.hpp"
#include "io/text_parts.hpp"

namespace quarry {
namespace {

static_assert(std::endian::native == std::endian::little, "the bytes are written as they lie in memory");

using StlPoint = std::array<float, 3>;

struct StlFace {
  std::array<Vec3, 4> p;
  int corners;
};

StlPoint rounded(Vec3 p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

StlFace stl_face(const Mesh& mesh, FaceId f) {
  StlFace face{{}, mesh.corner_count(f)};
  for (int k = 0; k < face.corners; ++k) face.p[static_cast<std::size_t>(k)] = mesh.point3(mesh.corner(f, k));
  return face;
}

class StlWriter {
 public:
  StlWriter(const std::string& path, const Mesh& mesh) : file_(path), mesh_(mesh), numbering_(mesh) {}

  void write() {
    const std::size_t facets = check_faces();
    std::string header = "quarry";  // never "solid", by which many readers know the text form
    header.resize(kStlHeaderBytes - sizeof(std::uint32_t), ' ');
    TextLine(header).bytes(static_cast<std::uint32_t>(facets));
    file_.write(header);
    write_lines(file_, numbering_.face_count(),
                [&](TextLine line, std::size_t i) { write_face(line, stl_face(mesh_, numbering_.face(i))); });
    file_.commit();
  }

 private:
  // Throws for a face that single precision cannot hold; returns the number of facets.
  std::size_t check_faces() {
    constexpr std::size_t kFacesInPart = 16384;
    const std::size_t count = numbering_.face_count();
    std::vector<std::size_t> facets((count + kFacesInPart - 1) / kFacesInPart, 0);
    read_parts(facets.size(), [&](std::size_t part) {
      const std::size_t end = std::min(count, (part + 1) * kFacesInPart);
      for (std::size_t i = part * kFacesInPart; i < end; ++i) {
        const StlFace face = stl_face(mesh_, numbering_.face(i));
        check_face(face);
        facets[part] += static_cast<std::size_t>(face.corners - 2);
      }
    });
    std::size_t total = 0;
    for (const std::size_t part : facets) total += part;
    if (total > std::numeric_limits<std::uint32_t>::max())
      throw Error(ErrorKind::kOutput,
                  fmt::format("{}: {} facets are more than .stl can count; write .ply", file_.path(), total));
    return total;
  }

  void check_face(const StlFace& face) const {
    for (std::size_t a = 0; a < static_cast<std::size_t>(face.corners); ++a) {
      const StlPoint p = rounded(face.p[a]);
      const bool finite = std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
      bool apart = true;
      for (std::size_t b = 0; b < a; ++b) apart = apart && rounded(face.p[b]) != p;
      if (finite && apart) continue;
      throw Error(
          ErrorKind::kOutput,
          fmt::format("{}: .stl has single precision, which cannot hold the face at {}; write .ply, or "
                      "move the mesh towards the origin",
                      file_.path(), format_point(face.p[a].x, face.p[a].y)));
    }
  }

  static void write_face(TextLine line, const StlFace& face) {
    if (face.corners == 3) return write_facet(line, {face.p[0], face.p[1], face.p[2]});
    const auto& p = face.p;
    if (length(p[3] - p[1]) < length(p[2] - p[0])) {
      write_facet(line, {p[0], p[1], p[3]});
      write_facet(line, {p[1], p[2], p[3]});
    } else {
      write_facet(line, {p[0], p[1], p[2]});
      write_facet(line, {p[0], p[2], p[3]});
    }
  }

  static void write_facet(TextLine line, const std::array<Vec3, 3>& corners) {
    const Vec3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double size = length(normal);
    write_point(line, rounded(size > 0 ? Vec3{normal.x / size, normal.y / size, normal.z / size} : Vec3{}));
    for (const Vec3 p : corners) write_point(line, rounded(p));
    line.bytes(std::uint16_t{0});
  }

  static void write_point(TextLine line, StlPoint p) {
    for (const float value : p) line.bytes(value);
  }

  AtomicFile file_;
  const Mesh& mesh_;
  LiveNumbering numbering_;
};

}  // namespace

void write_stl(const std::string& path, const Mesh& mesh, const MeshWriteOptions&) {
  StlWriter(path, mesh).write();
}

}  // namespace quarry
