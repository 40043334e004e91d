// What the input and the command line call the regions of a mesh.
#pragma once

#include <string>
#include <vector>

#include "engine/geometry/line_set.hpp"
#include "engine/mesh/mesh.hpp"
#include "io/mesh/mesh_file.hpp"

namespace quarry {

// A point in the region that is to have a name.
struct SeedPoint {
  Vec2 place;
  std::string name;
};

// "X,Y,NAME" each. Throws Error(kUsage).
[[nodiscard]] std::vector<SeedPoint> parse_seed_points(const std::vector<std::string>& texts);

// Gives the faces of each region the name of the smallest polygon of the sets around it that has one, as
// kZoneTag, and the material of the smallest that has one, as the tag "material"; -1 where there is none. The
// names of seeds come before those of polygons. Adds groupings, or to that of the materials of lines; no tag
// is made that no region has. mesh: finished, with the face tag "region". Throws Error(kInput) for a seed
// outside the mesh and for two of different names in one region.
void name_regions(Mesh& mesh, const std::vector<const LineSet*>& sets, const std::vector<SeedPoint>& seeds,
                  std::vector<Grouping>& groups);

}  // namespace quarry
