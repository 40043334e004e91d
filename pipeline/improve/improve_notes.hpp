// What an improve job tells its user, of a mesh in the plane or in space: one line each, that begins with the
// file.
#pragma once

#include <cstddef>
#include <string>

#include <fmt/format.h>

namespace quarry {

[[nodiscard]] inline std::string no_quads_note(const std::string& path) {
  return fmt::format("{}: the mesh has no quads: vertices move, but clean-up has nothing to do", path);
}

// first: the place of one of them.
[[nodiscard]] inline std::string invalid_faces_note(const std::string& path, std::size_t count,
                                                    const std::string& first) {
  return fmt::format("{}: {} faces are inverted, concave or flat, the first at {}", path, count, first);
}

[[nodiscard]] inline std::string lost_lines_note(const std::string& path, std::size_t count) {
  return fmt::format("{}: {} lines join points that belong to no face, and are left out", path, count);
}

[[nodiscard]] inline std::string edges_apart_note(const std::string& path, std::size_t count) {
  return fmt::format("{}: {} tagged edges are no side of a face: they are kept, and their ends stay fixed",
                     path, count);
}

}  // namespace quarry
