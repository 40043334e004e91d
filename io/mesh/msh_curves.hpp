// The curves of a .msh file and the physical groups that they are in.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/mesh/extra_groups.hpp"
#include "io/mesh/fracture_groups.hpp"
#include "io/mesh/grouped_entities.hpp"
#include "io/mesh/mesh_file.hpp"

namespace quarry {

struct MshCurve {
  std::vector<std::size_t> groups;   // physical tags
  std::vector<std::uint32_t> edges;  // places in LiveNumbering::edges()
};

struct MshCurves {
  std::vector<MshCurve> curves;
  std::vector<std::string> names;  // of physical groups, from tag 1 on
  // Added to the physical tags of surfaces, which count from 1.
  std::size_t surface_offset = 0;

  [[nodiscard]] std::size_t edge_count() const {
    std::size_t count = 0;
    for (const MshCurve& curve : curves) count += curve.edges.size();
    return count;
  }
};

// Group 1 is the outer boundary, and each line, or each side of one, has one too; groups of lines follow. An
// edge may be in several.
[[nodiscard]] MshCurves curves_by_line(const GroupedEntities& grouped, const GroupNames& names,
                                       const ExtraGroups<EdgeId>& extra_groups);

// As libMesh, and so MOOSE, reads them: a curve is in one group, and no tag is that of a surface too. The
// outer boundary and each line become sidesets; each line is there again as "..._lower_dimensional_block",
// which becomes a block of elements of its own: each fracture edge once.
[[nodiscard]] MshCurves curves_for_moose(const FractureGroups& groups);

}  // namespace quarry
