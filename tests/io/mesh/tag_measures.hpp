// How much of a mesh bears which tags: what must be the same before and after it is changed within its lines.
#pragma once

#include <cstdint>
#include <map>
#include <utility>

#include <gtest/gtest.h>

#include "io/mesh/mesh_file.hpp"

namespace quarry {

using Lengths = std::map<std::pair<std::int32_t, std::int32_t>, double>;

// The length of the edges of each constraint and kind.
inline Lengths edge_lengths(const Mesh& mesh) {
  const MeshFileTags tags(mesh);
  Lengths lengths;
  for (const EdgeId e : mesh.edges()) {
    const auto [a, b] = mesh.edge_ends(e);
    lengths[{tags.constraint(e), tags.kind(e)}] += length(mesh.point3(b) - mesh.point3(a));
  }
  return lengths;
}

// The area of the faces of each value of a tag.
inline std::map<std::int32_t, double> areas_by(const Mesh& mesh, const char* tag_name) {
  std::map<std::int32_t, double> areas;
  const auto tag = mesh.find_tag<FaceId, std::int32_t>(tag_name);
  for (const FaceId f : mesh.faces()) {
    const Vec3 a = mesh.point3(mesh.corner(f, 0));
    for (int k = 1; k + 1 < mesh.corner_count(f); ++k)
      areas[tag[f]] +=
          0.5 * length(cross(mesh.point3(mesh.corner(f, k)) - a, mesh.point3(mesh.corner(f, k + 1)) - a));
  }
  return areas;
}

// share: of each value, by which it may differ.
inline void expect_near(const auto& found, const auto& wanted, double share = 1e-6) {
  ASSERT_EQ(found.size(), wanted.size());
  for (const auto& [key, value] : wanted) EXPECT_NEAR(found.at(key), value, share * value);
}

}  // namespace quarry
