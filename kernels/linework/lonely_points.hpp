// Which points have no other near them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/geometry/grid.hpp"
#include "engine/parallel/parallel.hpp"

namespace quarry::linework {

// A flag for each point: 1 if all others are at least `apart` away (units of the points).
inline std::vector<std::uint8_t> lonely_points(std::span<const Vec2> points, double apart) {
  const PointGrid grid(points, 4 * apart);
  const std::span<const std::uint32_t> order = grid.by_cells();
  std::vector<std::uint8_t> lonely(points.size(), 0);
  constexpr std::size_t kPointsPerChunk = 1024;
  const auto near_each_other = [&](Vec2 a, Vec2 b) { return squared_length(a - b) < apart * apart; };
  parallel::for_each(
      order.size(),
      [&](std::size_t k) {
        const Vec2 p = points[order[k]];
        // Where very many points share a place, all would look at all.
        if ((k > 0 && near_each_other(points[order[k - 1]], p)) ||
            (k + 1 < order.size() && near_each_other(points[order[k + 1]], p)))
          return;
        std::size_t near = 0;
        grid.visit_near(Box2{p, p}.grown(apart), [&](std::uint32_t other) {
          if (near_each_other(points[other], p)) ++near;
        });
        lonely[order[k]] = near == 1 ? 1 : 0;  // itself
      },
      kPointsPerChunk);
  return lonely;
}

}  // namespace quarry::linework
