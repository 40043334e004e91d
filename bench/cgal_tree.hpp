// CGAL's AABB tree of triangles with its k-d tree of hints: the peer of bench/projection_bench.cpp. That tree
// is under the GPL, so it is compiled into that program alone, which is never installed.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>

#include "engine/geometry/vec.hpp"

namespace quarry::bench {

class CgalTree {
 public:
  CgalTree(std::span<const Vec3> points, std::span<const std::array<std::uint32_t, 3>> triangles);
  ~CgalTree();
  CgalTree(const CgalTree&) = delete;
  CgalTree& operator=(const CgalTree&) = delete;

  struct Closest {
    Vec3 position;
    std::uint32_t triangle = 0;
  };
  [[nodiscard]] Closest closest(Vec3 p) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace quarry::bench
