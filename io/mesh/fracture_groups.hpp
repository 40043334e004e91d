// Lines as finite element codes know them: sets of sides of faces, and line elements of their own.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/mesh/grouped_entities.hpp"
#include "io/mesh/mesh_file.hpp"

namespace quarry {

struct NamedEdges {
  std::string name;
  std::vector<std::uint32_t> edges;  // places in LiveNumbering::edges()
};

struct FractureGroups {
  std::vector<NamedEdges> side_sets;  // the outer boundary, then each line, or each side of one
  std::vector<NamedEdges> blocks;     // the interior part of each line, each edge in one of them
};

[[nodiscard]] FractureGroups fracture_groups(const Mesh& mesh, const LiveNumbering& numbering,
                                             const GroupedEntities& grouped, const GroupNames& names);

}  // namespace quarry
