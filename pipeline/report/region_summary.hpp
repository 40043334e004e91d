// How many faces each region has, and how large it is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "engine/mesh/mesh.hpp"
#include "io/mesh/mesh_file.hpp"

namespace quarry {

struct RegionSummary {
  std::int32_t region = 0;
  std::size_t faces = 0;
  double area = 0;
  std::vector<std::pair<std::string, std::string>> groups;  // tag and name
};

// By the face tag "region", ascending. Empty for a mesh without that tag. groups: of which those of faces are
// told.
[[nodiscard]] std::vector<RegionSummary> summarize_regions(const Mesh& mesh,
                                                           const std::vector<Grouping>& groups = {});

}  // namespace quarry
