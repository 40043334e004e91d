// What constraints make of a mesh: which faces lie in the domain, which regions constraints enclose, and the
// edges that are written out.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/geometry/line_set.hpp"
#include "engine/mesh/constraint.hpp"
#include "engine/mesh/mesh.hpp"

namespace quarry {

// Deletes the faces outside the outline, and the vertices that lose all faces. Pieces of kind kOutline have
// the domain on exactly one side: what can be reached from the hull without crossing one is outside, beyond
// one it is inside, and so on. A hull edge that is itself on the outline has the inside next to it.
// Tombstones stay. Returns the number of faces deleted.
std::size_t remove_outside(Mesh& mesh, ConstraintTags tags, const NodedLines& lines);

// Sets the face tag "region" (int32): faces that are joined without crossing a constrained side share a
// number. Regions are numbered from 0 in the order of their first face. Returns how many there are.
std::int32_t label_regions(Mesh& mesh, ConstraintTags tags);

// The values of the edge tag "kind".
inline constexpr std::int32_t kKindInterior = 1;
inline constexpr std::int32_t kKindBoundary = 2;

// Makes an edge entity of each constrained or boundary side, once for each input line that runs along it (tag
// "constraint": its number, or -1 for an outline that is no input line; tag "kind"). In the order of the
// sides.
void extract_edges(Mesh& mesh, ConstraintTags tags, const NodedLines& lines);

}  // namespace quarry
