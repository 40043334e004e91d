// How dear irregular vertices are, by place. Clean-up weighs its valence energy with it, and so drives them
// to where they are cheap.
#pragma once

#include <functional>
#include <vector>

#include "engine/geometry/grid.hpp"
#include "engine/geometry/vec.hpp"

namespace quarry {

// What an irregular vertex at a place costs; 1 is usual, more is dearer. Positive. Asked by many threads at
// once, and the same place always gets the same answer. Empty: all places cost 1.
using IrregularPrice = std::function<double(Vec3)>;

struct LinePrice {
  double distance = 0;  // in input units; above 0
  double factor = 1;    // above 0
};

// `factor` up to `distance` from the nearest of the segments, from there smoothly to 1 at twice the distance.
// Of the plane.
[[nodiscard]] IrregularPrice price_near(std::vector<Segment> segments, const LinePrice& price);

}  // namespace quarry
