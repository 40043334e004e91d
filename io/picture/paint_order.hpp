// In which order shapes that cover one another are painted.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace quarry {

// Shapes in an order in which for each of the pairs the first comes before the second, by depth (greater
// nearer to the eye) where pairs leave a choice. Where pairs contradict one another, the shape farthest away
// among those left comes next. depths: one for each shape; the shapes of pairs are numbers of them.
[[nodiscard]] std::vector<std::uint32_t> paint_order(
    const std::vector<double>& depths, std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs);

}  // namespace quarry
