// How many faces each region has, and how large it is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/mesh/mesh.hpp"

namespace quarry {

struct RegionSummary {
  std::int32_t region = 0;
  std::size_t faces = 0;
  double area = 0;
};

// By the face tag "region", ascending. Empty for a mesh without that tag.
[[nodiscard]] std::vector<RegionSummary> summarize_regions(const Mesh& mesh);

}  // namespace quarry
