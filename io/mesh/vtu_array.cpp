#include "io/mesh/vtu_array.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>

#include "engine/parallel/parallel.hpp"
#include "io/mesh/cell_nodes.hpp"
#include "io/mesh/material_numbers.hpp"

namespace quarry {
namespace {

// By the number of nodes.
std::uint8_t vtk_face_type(int nodes) {
  switch (nodes) {
    case 3:
      return 5;  // VTK_TRIANGLE
    case 4:
      return 9;  // VTK_QUAD
    case 6:
      return 22;  // VTK_QUADRATIC_TRIANGLE
    case 8:
      return 23;  // VTK_QUADRATIC_QUAD
    default:
      return 28;  // VTK_BIQUADRATIC_QUAD
  }
}

std::uint8_t vtk_line_type(int nodes) { return nodes == 2 ? 3 : 21; }  // VTK_LINE, VTK_QUADRATIC_EDGE

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

// Where the nodes of each face start in the list of those of all cells: known for the first face of each
// group, counted from there within the group.
class NodeStarts {
 public:
  NodeStarts(const LiveNumbering& numbering, CellNodes cell_nodes)
      : numbering_(&numbering),
        nodes_(std::move(cell_nodes)),
        starts_((numbering.face_count() + kGroup - 1) / kGroup, 0) {
    parallel::for_each_chunk(numbering.face_count(), kGroup, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) starts_[begin / kGroup] += node_count(i);
    });
    total_ = parallel::exclusive_scan(std::span(starts_));
  }

  [[nodiscard]] const CellNodes& nodes() const { return nodes_; }
  [[nodiscard]] std::uint64_t total() const { return total_; }
  [[nodiscard]] std::uint64_t node_count(std::size_t face) const {
    return static_cast<std::uint64_t>(nodes_.face_count(numbering_->face(face)));
  }
  // First node of a face.
  [[nodiscard]] std::uint64_t start(std::size_t face) const {
    std::uint64_t at = face / kGroup < starts_.size() ? starts_[face / kGroup] : total_;
    for (std::size_t i = face / kGroup * kGroup; i < face; ++i) at += node_count(i);
    return at;
  }
  // The face that has a node of the list.
  [[nodiscard]] std::size_t face_of(std::uint64_t place) const {
    const auto group = std::upper_bound(starts_.begin(), starts_.end(), place) - starts_.begin() - 1;
    std::size_t face = static_cast<std::size_t>(group) * kGroup;
    for (std::uint64_t at = starts_[static_cast<std::size_t>(group)]; at + node_count(face) <= place; ++face)
      at += node_count(face);
    return face;
  }

 private:
  static constexpr std::size_t kGroup = 4096;
  const LiveNumbering* numbering_;
  CellNodes nodes_;
  std::vector<std::uint64_t> starts_;
  std::uint64_t total_ = 0;
};

template <class T>
void store(std::byte*& out, std::uint64_t value) {
  const T scalar = static_cast<T>(value);
  std::memcpy(out, &scalar, sizeof(T));
  out += sizeof(T);
}

using Starts = std::shared_ptr<const NodeStarts>;

// An item is one node: of the faces first, of the lines after them.
template <class T>
VtuArray connectivity_array(const LiveNumbering& numbering, const Starts& starts) {
  auto fill = [&numbering, starts](std::size_t begin, std::size_t end, std::byte* out) {
    const CellNodes& nodes = starts->nodes();
    std::size_t at = begin;
    if (at < starts->total()) {
      std::size_t face = starts->face_of(at);
      std::size_t node = at - starts->start(face);
      for (; at < end && face < numbering.face_count(); ++face, node = 0)
        for (const std::size_t count = starts->node_count(face); node < count && at < end; ++node, ++at)
          store<T>(out, nodes.face_node(numbering.face(face), static_cast<int>(node)));
    }
    const auto of_line = static_cast<std::size_t>(nodes.edge_count());
    for (; at < end; ++at) {
      const std::size_t place = at - starts->total();
      store<T>(out, nodes.edge_node(place / of_line, static_cast<int>(place % of_line)));
    }
  };
  const std::size_t items =
      starts->total() + static_cast<std::size_t>(starts->nodes().edge_count()) * numbering.edges().size();
  return {"connectivity", vtk_name<T>(), 1, items, sizeof(T), fill};
}

// An item is the end of one cell in the list of all nodes.
template <class T>
VtuArray offset_array(const LiveNumbering& numbering, const Starts& starts) {
  auto fill = [&numbering, starts](std::size_t begin, std::size_t end, std::byte* out) {
    const auto of_line = static_cast<std::uint64_t>(starts->nodes().edge_count());
    std::uint64_t at = starts->start(std::min(begin, numbering.face_count()));
    if (begin > numbering.face_count()) at += of_line * (begin - numbering.face_count());
    for (std::size_t cell = begin; cell < end; ++cell) {
      at += cell < numbering.face_count() ? starts->node_count(cell) : of_line;
      store<T>(out, at);
    }
  };
  return {"offsets", vtk_name<T>(), 1, numbering.face_count() + numbering.edges().size(), sizeof(T), fill};
}

VtuArray point_array(const Starts& starts) {
  return {"Points",
          "Float64",
          3,
          starts->nodes().count(),
          3 * sizeof(double),
          [starts](std::size_t begin, std::size_t end, std::byte* out) {
            for (std::size_t i = begin; i < end; ++i, out += 3 * sizeof(double)) {
              const Vec3 p = starts->nodes().point(i);
              const double coordinates[3] = {p.x, p.y, p.z};
              std::memcpy(out, coordinates, sizeof coordinates);
            }
          }};
}

std::vector<VtuArray> cell_arrays(const LiveNumbering& numbering, const Starts& starts, IndexWidth width) {
  const CellNodes& nodes = starts->nodes();
  const std::size_t faces = numbering.face_count();
  const std::uint64_t places =
      starts->total() + static_cast<std::uint64_t>(nodes.edge_count()) * numbering.edges().size();
  const bool narrow = width == IndexWidth::kNarrow &&
                      std::max<std::uint64_t>(places, nodes.count()) <=
                          static_cast<std::uint64_t>(std::numeric_limits<std::int32_t>::max());
  std::vector<VtuArray> arrays;
  arrays.push_back(narrow ? connectivity_array<std::int32_t>(numbering, starts)
                          : connectivity_array<std::int64_t>(numbering, starts));
  arrays.push_back(narrow ? offset_array<std::int32_t>(numbering, starts)
                          : offset_array<std::int64_t>(numbering, starts));
  arrays.push_back(scalar_array<std::uint8_t>(
      "types", faces + numbering.edges().size(), [&numbering, starts, faces](std::size_t i) {
        return i >= faces ? vtk_line_type(starts->nodes().edge_count())
                          : vtk_face_type(starts->nodes().face_count(numbering.face(i)));
      }));
  return arrays;
}

}  // namespace

VtuArrays make_vtu_arrays(const Mesh& mesh, const LiveNumbering& numbering, const MeshWriteOptions& options,
                          IndexWidth width) {
  const std::size_t faces = numbering.face_count();
  const std::size_t cells = faces + numbering.edges().size();
  const MeshFileTags tags(mesh);
  const auto starts =
      std::make_shared<const NodeStarts>(numbering, CellNodes(mesh, numbering, options.order));
  VtuArrays arrays{point_array(starts), cell_arrays(numbering, starts, width), {}, {}};
  if (const auto point = mesh.find_tag<VertexId, std::int32_t>(kPointTag); point.valid())
    arrays.point_data.push_back(
        scalar_array<std::int32_t>(kPointTag, arrays.points.items, [&numbering, point](std::size_t i) {
          return i < numbering.vertex_count() ? point[numbering.vertex(i)] : -1;
        }));
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
  if (options.consumer == MeshConsumer::kOpenGeoSys)
    arrays.cell_data.push_back(scalar_array<std::int32_t>(
        "MaterialIDs", cells,
        [&numbering, materials = MaterialNumbers(mesh, numbering), faces](std::size_t i) {
          return i < faces ? materials.of(numbering.face(i)) : materials.of(numbering.edges()[i - faces]);
        }));
  if (tags.split())
    arrays.cell_data.push_back(
        scalar_array<std::int32_t>(kSideTag, cells, [&numbering, tags, faces](std::size_t i) {
          return i < faces ? 0 : tags.side(numbering.edges()[i - faces]);
        }));
  if (!options.scaled_jacobian.empty())
    arrays.cell_data.push_back(scalar_array<double>(
        "scaled_jacobian", cells, [&numbering, values = options.scaled_jacobian, faces](std::size_t i) {
          return i < faces ? values[numbering.face(i).value()] : std::numeric_limits<double>::quiet_NaN();
        }));
  for (const Grouping& group : options.groups) {
    const auto of_edges = mesh.find_tag<EdgeId, std::int32_t>(group.tag);
    const auto of_faces = mesh.find_tag<FaceId, std::int32_t>(group.tag);
    if (!of_edges.valid() && !of_faces.valid()) continue;
    arrays.cell_data.push_back(
        scalar_array<std::int32_t>(group.tag, cells, [&numbering, of_edges, of_faces, faces](std::size_t i) {
          if (i < faces) return of_faces.valid() ? of_faces[numbering.face(i)] : -1;
          return of_edges.valid() ? of_edges[numbering.edges()[i - faces]] : -1;
        }));
  }
  if (const auto aperture = mesh.find_tag<EdgeId, double>(kApertureTag); aperture.valid())
    arrays.cell_data.push_back(
        scalar_array<double>(kApertureTag, cells, [&numbering, aperture, faces](std::size_t i) {
          return i < faces ? std::numeric_limits<double>::quiet_NaN()
                           : aperture[numbering.edges()[i - faces]];
        }));
  return arrays;
}

}  // namespace quarry
