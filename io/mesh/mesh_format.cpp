#include "io/mesh/mesh_format.hpp"

#include <algorithm>
#include <array>
#include <filesystem>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "io/coordinate_limit.hpp"
#include "io/lower_case.hpp"
#include "io/mesh/avs_format.hpp"
#include "io/mesh/exodus_format.hpp"
#include "io/mesh/gocad_format.hpp"
#include "io/mesh/inp_format.hpp"
#include "io/mesh/mfem_format.hpp"
#include "io/mesh/msh_format.hpp"
#include "io/mesh/obj_format.hpp"
#include "io/mesh/off_format.hpp"
#include "io/mesh/ply_format.hpp"
#include "io/mesh/stl_format.hpp"
#include "io/mesh/vtkhdf_format.hpp"
#include "io/mesh/vtu_reader.hpp"
#include "io/mesh/vtu_writer.hpp"

namespace quarry {
namespace {

struct MeshFormat {
  std::string_view extension;
  void (*write)(const std::string& path, const Mesh& mesh, const MeshWriteOptions& options);  // or nullptr
  ReadCells (*read)(const std::string& path);                                                 // or nullptr
  ElementOrder highest_order = ElementOrder::kLinear;  // of the elements that are written
};

constexpr std::array kFormats = {MeshFormat{".vtu", write_vtu, read_vtu, ElementOrder::kBiquadratic},
                                 MeshFormat{".msh", write_msh, read_msh, ElementOrder::kBiquadratic},
                                 MeshFormat{".obj", write_obj, read_obj},
                                 MeshFormat{".inp", write_inp, read_inp, ElementOrder::kQuadratic},
                                 MeshFormat{".ply", write_ply, read_ply},
                                 MeshFormat{".stl", write_stl, read_stl},
                                 MeshFormat{".avs", write_avs, read_avs},
                                 MeshFormat{".ucd", write_avs, read_avs},
                                 MeshFormat{".mesh", write_mfem, read_mfem},
                                 MeshFormat{".vtkhdf", write_vtkhdf, nullptr, ElementOrder::kBiquadratic},
                                 MeshFormat{".hdf", write_vtkhdf, nullptr, ElementOrder::kBiquadratic},
#ifdef QUARRY_EXODUS
                                 MeshFormat{".exo", write_exodus, nullptr, ElementOrder::kBiquadratic},
                                 MeshFormat{".e", write_exodus, nullptr, ElementOrder::kBiquadratic},
#endif
                                 MeshFormat{".off", nullptr, read_off},
                                 MeshFormat{".ts", nullptr, read_gocad},
                                 MeshFormat{".ml", nullptr, read_gocad}};

std::string extension_of(const std::string& path) {
  return lower_case(std::filesystem::path(path).extension().string());
}

// ".vtu, .msh or .obj"
std::string list_of(const std::vector<std::string_view>& extensions) {
  const std::size_t last = extensions.size() - 1;
  return fmt::format(
      "{} or {}", fmt::join(extensions.begin(), extensions.begin() + static_cast<std::ptrdiff_t>(last), ", "),
      extensions[last]);
}

// usable: the formats that would do, for the message.
const MeshFormat& format_of(const std::string& path, std::string (*usable)()) {
  const std::string extension = extension_of(path);
  for (const MeshFormat& format : kFormats)
    if (format.extension == extension) return format;
#ifndef QUARRY_EXODUS
  if (extension == ".exo" || extension == ".e")
    throw Error(
        ErrorKind::kUsage,
        fmt::format("{}: this quarry was built without Exodus II; build it with -DQUARRY_EXODUS=ON", path));
#endif
  throw Error(ErrorKind::kUsage, fmt::format("{}: the mesh format \"{}\" is not known; use one of {}", path,
                                             extension, usable()));
}

const MeshFormat& written_format_of(const std::string& path) {
  const MeshFormat& format = format_of(path, writable_mesh_formats);
  if (format.write == nullptr)
    throw Error(ErrorKind::kUsage, fmt::format("{}: {} is read and not written; write one of {}", path,
                                               format.extension, writable_mesh_formats()));
  return format;
}

const MeshFormat& read_format_of(const std::string& path) {
  const MeshFormat& format = format_of(path, readable_mesh_formats);
  if (format.read == nullptr)
    throw Error(ErrorKind::kUsage, fmt::format("{}: {} is written and not read; read one of {}", path,
                                               format.extension, readable_mesh_formats()));
  return format;
}

void check_points(const std::string& path, const ReadCells& cells) {
  for (std::size_t i = 0; i < cells.x.size(); ++i)
    if (!is_usable_coordinate(cells.x[i]) || !is_usable_coordinate(cells.y[i]) ||
        !is_usable_coordinate(cells.z[i]))
      throw Error(
          ErrorKind::kInput,
          fmt::format("{}: point {} has a coordinate that is not a usable number; the largest is {:g}: "
                      "({}, {}, {})",
                      path, i, kLargestCoordinate, cells.x[i], cells.y[i], cells.z[i]));
}

}  // namespace

void write_mesh(const std::string& path, const Mesh& mesh, const MeshWriteOptions& options) {
  written_format_of(path).write(path, mesh, options);
}

ReadCells read_cells(const std::string& path) {
  ReadCells cells = read_format_of(path).read(path);
  check_points(path, cells);
  return cells;
}

Mesh read_mesh(const std::string& path) { return make_mesh(path, read_cells(path)); }

void check_readable_extension(const std::string& path) { static_cast<void>(read_format_of(path)); }

void check_writable_extension(const std::string& path) { static_cast<void>(written_format_of(path)); }

void check_writable_order(const std::string& path, ElementOrder order) {
  const MeshFormat& format = written_format_of(path);
  if (order <= format.highest_order) return;
  std::vector<std::string_view> extensions;
  for (const MeshFormat& each : kFormats)
    if (order <= each.highest_order) extensions.push_back(each.extension);
  throw Error(ErrorKind::kUsage, fmt::format("{}: {} has no such elements of second order; write one of {}",
                                             path, format.extension, list_of(extensions)));
}

void check_writable_for(const std::string& path, MeshConsumer consumer) {
  const std::string_view extension = written_format_of(path).extension;
  if (consumer == MeshConsumer::kOpenGeoSys && extension != ".vtu")
    throw Error(ErrorKind::kUsage, fmt::format("{}: OpenGeoSys reads .vtu files", path));
  if (consumer == MeshConsumer::kMoose && extension != ".msh")
    throw Error(ErrorKind::kUsage, fmt::format("{}: for MOOSE .msh files are written", path));
}

std::string readable_mesh_formats() {
  std::vector<std::string_view> extensions;
  for (const MeshFormat& format : kFormats)
    if (format.read != nullptr) extensions.push_back(format.extension);
  return list_of(extensions);
}

std::string writable_mesh_formats() {
  std::vector<std::string_view> extensions;
  for (const MeshFormat& format : kFormats)
    if (format.write != nullptr) extensions.push_back(format.extension);
  return list_of(extensions);
}

bool is_mesh_file(const std::string& path) {
  const std::string extension = extension_of(path);
  return std::any_of(kFormats.begin(), kFormats.end(), [&](const MeshFormat& format) {
    return format.read != nullptr && format.extension == extension;
  });
}

}  // namespace quarry
