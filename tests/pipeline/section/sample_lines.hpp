// Random line work of the sorts that break meshers, as files in memory order: the same for a seed everywhere.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "engine/base/random.hpp"
#include "engine/geometry/vec.hpp"
#include "tests/support/geojson_text.hpp"

namespace quarry {

// Draws numbers in order.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : seed_(seed) {}
  double between(double low, double high) { return low + (high - low) * uniform01(seed_, counter_++); }
  Vec2 point(double side) {
    const double x = between(0, side);
    return {x, between(0, side)};
  }

 private:
  std::uint64_t seed_;
  std::uint64_t counter_ = 0;
};

// In a square of side 100: fractures of any length, a walk, a star, a comb whose teeth nearly touch, lines on
// top of each other, lines along the lattice, and ends on other lines.
inline std::vector<Polyline> random_lines(std::uint64_t seed) {
  Dice dice(seed);
  std::vector<Polyline> lines = {{{0, 0}, {100, 0}}, {{100, 100}, {0, 100}}};
  for (int i = 0; i < 12; ++i) {
    const Vec2 a = dice.point(100);
    const Vec2 b = dice.point(100);
    lines.push_back({a, a + dice.between(0.01, 1) * (b - a)});
  }
  Polyline walk = {dice.point(100)};
  for (int i = 0; i < 20; ++i) walk.push_back(walk.back() + dice.point(8) - Vec2{4, 4});
  lines.push_back(walk);
  const Vec2 hub = dice.point(60) + Vec2{20, 20};
  const int arms = static_cast<int>(dice.between(3, 24));
  for (int i = 0; i < arms; ++i) {
    const double angle = 2 * std::numbers::pi * i / arms;
    lines.push_back({hub, hub + dice.between(2, 15) * Vec2{std::cos(angle), std::sin(angle)}});
  }
  const Vec2 foot = dice.point(60);
  const double gap = std::pow(10.0, dice.between(-2, 1));
  for (int i = 0; i < 10; ++i)
    lines.push_back({foot + Vec2{i * gap, 0}, foot + Vec2{i * gap, dice.between(5, 30)}});
  lines.push_back({foot, foot + Vec2{9 * gap, 0}});
  lines.push_back({foot - Vec2{3, 0}, foot + Vec2{4.5 * gap, 0}});
  const double lattice = 4 * std::floor(dice.between(1, 20));
  lines.push_back({{lattice, 0}, {lattice, 60}});
  lines.push_back({{0, lattice}, {80, lattice}});
  const Polyline first = lines[2];
  lines.push_back({0.5 * (first[0] + first[1]), dice.point(100)});
  return lines;
}

}  // namespace quarry
