// The old .msh format (2) has one physical group for each element, so that Gmsh writes an element once for
// each group that it is in. What is to be left out for one of each to remain.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "engine/mesh/build.hpp"

namespace quarry {

// By face, 1: one before it has the same corners in the same order, and another region. A face that is there
// twice in one region is no matter of groups, and stays.
[[nodiscard]] std::vector<std::uint8_t> find_repeated_faces(std::span<const FaceCorners> faces,
                                                            std::span<const std::int32_t> regions);

// What the group of a line element is.
enum class LineGroup : std::uint8_t {
  kLine,   // of a line of ours: it has a number
  kOther,  // of another name
  kExtra,  // beside the lines: sets, materials, names (io/mesh/group_name.hpp)
  kNone,   // the outer boundary, or no group
};

// By line element, 1: another one between the same points says more. Extra groups say nothing beside a line
// of ours, and none says nothing beside any group.
[[nodiscard]] std::vector<std::uint8_t> find_needless_edges(
    std::span<const std::pair<VertexId, VertexId>> edges, std::span<const LineGroup> groups);

}  // namespace quarry
