// Stereolithography files (.stl): triangles that have three points each of their own, in the text and in the
// binary form. Which form it is shows in the size first, because binary files may start with "solid" too.
//
// The format has no groups of points: equal points become one when read, in order of appearance. Coordinates
// of the binary form have single precision. Normals and attributes are passed over.
//
// Format: 3D Systems, StereoLithography Interface Specification (1989).
#pragma once

#include <string>
#include <string_view>

#include "io/mesh/read_cells.hpp"

namespace quarry {

// Binary; quads are cut along the shorter diagonal. Regions and edges have no place. Throws Error(kOutput),
// also where single precision would make one point of two of a face, or has no number so large.
void write_stl(const std::string& path, const Mesh& mesh, const MeshWriteOptions& options);

// Each solid of the text form is a region with its name. Throws Error(kInput) with file and line, or byte in
// the binary form, also for a size that does not agree with the count.
[[nodiscard]] ReadCells read_stl(const std::string& path);

// Bytes before the first facet of the binary form, and of each facet: normal, three points, an attribute.
inline constexpr std::size_t kStlHeaderBytes = 84;
inline constexpr std::size_t kStlFacetBytes = 50;

// The text form, for read_stl.
[[nodiscard]] ReadCells read_stl_text(const std::string& path, std::string_view text);

// Whether a word of the text form is the given one, in either case of letters.
[[nodiscard]] bool same_stl_word(std::string_view word, std::string_view lower);

}  // namespace quarry
