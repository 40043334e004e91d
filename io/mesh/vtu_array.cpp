#include "io/mesh/vtu_array.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>

#include "engine/parallel/parallel.hpp"

namespace quarry {
namespace {

constexpr std::uint8_t kVtkLine = 3;
constexpr std::uint8_t kVtkTriangle = 5;
constexpr std::uint8_t kVtkQuad = 9;

template <class T>
constexpr const char* vtk_name() {
  if constexpr (std::is_same_v<T, double>) return "Float64";
  if constexpr (std::is_same_v<T, std::int64_t>) return "Int64";
  if constexpr (std::is_same_v<T, std::int32_t>) return "Int32";
  if constexpr (std::is_same_v<T, std::uint8_t>) return "UInt8";
}

// An array of one scalar an item; value(item) makes it.
template <class T, class Value>
VtuArray scalar_array(std::string name, std::size_t items, Value value) {
  return {std::move(name),
          vtk_name<T>(),
          1,
          items,
          sizeof(T),
          [value = std::move(value)](std::size_t begin, std::size_t end, std::byte* out) {
            for (std::size_t i = begin; i < end; ++i, out += sizeof(T)) {
              const T scalar = value(i);
              std::memcpy(out, &scalar, sizeof(T));
            }
          }};
}

// Where the corners of each face start in the list of all corners: known for the first face of each group,
// counted from there within the group.
class CornerStarts {
 public:
  CornerStarts(const Mesh& mesh, const LiveNumbering& numbering)
      : mesh_(&mesh), numbering_(&numbering), starts_((numbering.face_count() + kGroup - 1) / kGroup, 0) {
    parallel::for_each_chunk(numbering.face_count(), kGroup, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) starts_[begin / kGroup] += corner_count(i);
    });
    total_ = parallel::exclusive_scan(std::span(starts_));
  }

  [[nodiscard]] std::uint64_t total() const { return total_; }
  [[nodiscard]] std::uint64_t corner_count(std::size_t face) const {
    return static_cast<std::uint64_t>(mesh_->corner_count(numbering_->face(face)));
  }
  // First corner of a face.
  [[nodiscard]] std::uint64_t start(std::size_t face) const {
    std::uint64_t at = face / kGroup < starts_.size() ? starts_[face / kGroup] : total_;
    for (std::size_t i = face / kGroup * kGroup; i < face; ++i) at += corner_count(i);
    return at;
  }
  // The face that has a corner.
  [[nodiscard]] std::size_t face_of(std::uint64_t corner) const {
    const auto group = std::upper_bound(starts_.begin(), starts_.end(), corner) - starts_.begin() - 1;
    std::size_t face = static_cast<std::size_t>(group) * kGroup;
    for (std::uint64_t at = starts_[static_cast<std::size_t>(group)]; at + corner_count(face) <= corner;
         ++face)
      at += corner_count(face);
    return face;
  }

 private:
  static constexpr std::size_t kGroup = 4096;
  const Mesh* mesh_;
  const LiveNumbering* numbering_;
  std::vector<std::uint64_t> starts_;
  std::uint64_t total_ = 0;
};

template <class T>
void store(std::byte*& out, std::uint64_t value) {
  const T scalar = static_cast<T>(value);
  std::memcpy(out, &scalar, sizeof(T));
  out += sizeof(T);
}

// An item is one corner: of the faces first, of the lines after them.
template <class T>
VtuArray connectivity_array(const Mesh& mesh, const LiveNumbering& numbering,
                            const std::shared_ptr<const CornerStarts>& starts) {
  auto fill = [&mesh, &numbering, starts](std::size_t begin, std::size_t end, std::byte* out) {
    std::size_t at = begin;
    if (at < starts->total()) {
      std::size_t face = starts->face_of(at);
      std::size_t corner = at - starts->start(face);
      for (; at < end && face < numbering.face_count(); ++face, corner = 0)
        for (const std::size_t count = starts->corner_count(face); corner < count && at < end; ++corner, ++at)
          store<T>(out, numbering.number(mesh.corner(numbering.face(face), static_cast<int>(corner))));
    }
    for (; at < end; ++at) {
      const std::size_t line_corner = at - starts->total();
      const auto [a, b] = mesh.edge_ends(numbering.edges()[line_corner / 2]);
      store<T>(out, numbering.number(line_corner % 2 == 0 ? a : b));
    }
  };
  return {"connectivity", vtk_name<T>(), 1, starts->total() + 2 * numbering.edges().size(), sizeof(T), fill};
}

// An item is the end of one cell in the list of all corners.
template <class T>
VtuArray offset_array(const LiveNumbering& numbering, const std::shared_ptr<const CornerStarts>& starts) {
  auto fill = [&numbering, starts](std::size_t begin, std::size_t end, std::byte* out) {
    std::uint64_t at = starts->start(std::min(begin, numbering.face_count()));
    if (begin > numbering.face_count()) at += 2 * (begin - numbering.face_count());
    for (std::size_t cell = begin; cell < end; ++cell) {
      at += cell < numbering.face_count() ? starts->corner_count(cell) : 2;
      store<T>(out, at);
    }
  };
  return {"offsets", vtk_name<T>(), 1, numbering.face_count() + numbering.edges().size(), sizeof(T), fill};
}

VtuArray point_array(const Mesh& mesh, const LiveNumbering& numbering) {
  return {"Points",
          "Float64",
          3,
          numbering.vertex_count(),
          3 * sizeof(double),
          [&mesh, &numbering](std::size_t begin, std::size_t end, std::byte* out) {
            for (std::size_t i = begin; i < end; ++i, out += 3 * sizeof(double)) {
              const Vec3 p = mesh.point3(numbering.vertex(i));
              const double coordinates[3] = {p.x, p.y, p.z};
              std::memcpy(out, coordinates, sizeof coordinates);
            }
          }};
}

std::vector<VtuArray> cell_arrays(const Mesh& mesh, const LiveNumbering& numbering) {
  const auto starts = std::make_shared<const CornerStarts>(mesh, numbering);
  const std::size_t faces = numbering.face_count();
  const std::uint64_t corners = starts->total() + 2 * numbering.edges().size();
  const bool narrow = std::max<std::uint64_t>(corners, numbering.vertex_count()) <=
                      static_cast<std::uint64_t>(std::numeric_limits<std::int32_t>::max());
  std::vector<VtuArray> arrays;
  arrays.push_back(narrow ? connectivity_array<std::int32_t>(mesh, numbering, starts)
                          : connectivity_array<std::int64_t>(mesh, numbering, starts));
  arrays.push_back(narrow ? offset_array<std::int32_t>(numbering, starts)
                          : offset_array<std::int64_t>(numbering, starts));
  arrays.push_back(scalar_array<std::uint8_t>(
      "types", faces + numbering.edges().size(), [&mesh, &numbering, faces](std::size_t i) {
        if (i >= faces) return kVtkLine;
        return mesh.corner_count(numbering.face(i)) == 4 ? kVtkQuad : kVtkTriangle;
      }));
  return arrays;
}

}  // namespace

VtuArrays make_vtu_arrays(const Mesh& mesh, const LiveNumbering& numbering, const MeshWriteOptions& options) {
  const std::size_t faces = numbering.face_count();
  const std::size_t cells = faces + numbering.edges().size();
  const MeshFileTags tags(mesh);
  VtuArrays arrays{point_array(mesh, numbering), cell_arrays(mesh, numbering), {}};
  arrays.cell_data.push_back(scalar_array<std::int32_t>(
      "region", cells,
      [&numbering, tags, faces](std::size_t i) { return i < faces ? tags.region(numbering.face(i)) : -1; }));
  arrays.cell_data.push_back(
      scalar_array<std::int32_t>("constraint", cells, [&numbering, tags, faces](std::size_t i) {
        return i < faces ? -1 : tags.constraint(numbering.edges()[i - faces]);
      }));
  arrays.cell_data.push_back(
      scalar_array<std::int32_t>("kind", cells, [&numbering, tags, faces](std::size_t i) {
        return i < faces ? 0 : tags.kind(numbering.edges()[i - faces]);
      }));
  if (!options.scaled_jacobian.empty())
    arrays.cell_data.push_back(scalar_array<double>(
        "scaled_jacobian", cells, [&numbering, values = options.scaled_jacobian, faces](std::size_t i) {
          return i < faces ? values[numbering.face(i).value()] : std::numeric_limits<double>::quiet_NaN();
        }));
  for (const LineGrouping& group : options.line_groups)
    if (const auto tag = mesh.find_tag<EdgeId, std::int32_t>(group.tag); tag.valid())
      arrays.cell_data.push_back(
          scalar_array<std::int32_t>(group.tag, cells, [&numbering, tag, faces](std::size_t i) {
            return i < faces ? -1 : tag[numbering.edges()[i - faces]];
          }));
  if (const auto aperture = mesh.find_tag<EdgeId, double>(kApertureTag); aperture.valid())
    arrays.cell_data.push_back(
        scalar_array<double>(kApertureTag, cells, [&numbering, aperture, faces](std::size_t i) {
          return i < faces ? std::numeric_limits<double>::quiet_NaN()
                           : aperture[numbering.edges()[i - faces]];
        }));
  return arrays;
}

}  // namespace quarry
