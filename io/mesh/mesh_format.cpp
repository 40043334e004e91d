#include "io/mesh/mesh_format.hpp"

#include <algorithm>
#include <array>
#include <filesystem>

#include <cctype>
#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "io/mesh/inp_format.hpp"
#include "io/mesh/msh_format.hpp"
#include "io/mesh/obj_format.hpp"
#include "io/mesh/vtu_reader.hpp"
#include "io/mesh/vtu_writer.hpp"

namespace quarry {
namespace {

struct MeshFormat {
  std::string_view extension;
  void (*write)(const std::string& path, const Mesh& mesh, const MeshWriteOptions& options);
  ReadCells (*read)(const std::string& path);
};

constexpr std::array kFormats = {
    MeshFormat{".vtu", write_vtu, read_vtu}, MeshFormat{".msh", write_msh, read_msh},
    MeshFormat{".obj", write_obj, read_obj}, MeshFormat{".inp", write_inp, read_inp}};

std::string extension_of(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

const MeshFormat& format_of(const std::string& path) {
  const std::string extension = extension_of(path);
  std::string known;
  for (const MeshFormat& format : kFormats) {
    if (format.extension == extension) return format;
    known += fmt::format("{}{}", known.empty() ? "" : ", ", format.extension);
  }
  throw Error(ErrorKind::kUsage,
              fmt::format("{}: the mesh format \"{}\" is not known; use one of {}", path, extension, known));
}

}  // namespace

void write_mesh(const std::string& path, const Mesh& mesh, const MeshWriteOptions& options) {
  format_of(path).write(path, mesh, options);
}

ReadCells read_cells(const std::string& path) { return format_of(path).read(path); }

Mesh read_mesh(const std::string& path) { return make_mesh(path, read_cells(path)); }

void check_mesh_extension(const std::string& path) { static_cast<void>(format_of(path)); }

bool is_mesh_file(const std::string& path) {
  const std::string extension = extension_of(path);
  return std::any_of(kFormats.begin(), kFormats.end(),
                     [&](const MeshFormat& format) { return format.extension == extension; });
}

}  // namespace quarry
