// Random lines and polygons, each a pure function of its seed.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "engine/base/random.hpp"
#include "tests/kernels/linework/line_samples.hpp"

namespace quarry {

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : seed_(seed) {}
  double operator()(double low, double high) { return low + (high - low) * uniform01(seed_, counter_++); }

 private:
  std::uint64_t seed_;
  std::uint64_t counter_ = 0;
};

// Lines in a box of side 10: random segments, short and crooked lines, copies shifted by about the snapping
// distance, ends near other lines, lines through common points, shared vertices, some on a coarse lattice.
inline LineSet soup(std::uint64_t seed, Vec2 origin) {
  Dice dice(seed);
  const auto anywhere = [&] { return Vec2{dice(0, 10), dice(0, 10)}; };
  std::vector<Points> lines{{anywhere(), Vec2{dice(0, 5), 12}}};  // one that is long at any size
  const auto near = [&](Vec2 p, double r) { return p + Vec2{dice(-r, r), dice(-r, r)}; };
  const int count = 4 + static_cast<int>(dice(0, 26));
  for (int i = 0; i < count; ++i) {
    const double kind = dice(0, 1);
    Points line{anywhere()};
    const double step = std::pow(10, dice(-2, 1));
    const int length = 1 + static_cast<int>(dice(0, 8));
    if (kind < 0.5 || lines.empty()) {
      for (int k = 0; k < length; ++k) line.push_back(near(line.back(), step));
    } else {
      const Points& other = lines[static_cast<std::size_t>(dice(0, static_cast<double>(lines.size())))];
      const double shift = std::pow(10, dice(-4, -0.5));
      if (kind < 0.65) {
        line.clear();
        for (const Vec2 p : other) line.push_back(near(p, shift));
      } else if (kind < 0.8) {
        const std::size_t s = static_cast<std::size_t>(dice(0, static_cast<double>(other.size() - 1)));
        line.push_back(near(point_at(dice(0, 1), other[s], other[s + 1]), shift));
      } else {
        line.push_back(other[static_cast<std::size_t>(dice(0, static_cast<double>(other.size())))]);
        line.push_back(anywhere());
      }
    }
    if (dice(0, 1) < 0.15)
      for (Vec2& p : line) p = {std::round(p.x), std::round(p.y)};
    if (dice(0, 1) < 0.1 && line.size() > 2) line.push_back(line.front());
    lines.push_back(line);
  }
  for (Points& line : lines)
    for (Vec2& p : line) p = p + origin;
  return lines_of(lines);
}

// Star-shaped polygons, some with a star-shaped hole, that overlap at random.
inline LineSet random_polygons(std::uint64_t seed) {
  LineSet set;
  set.files = {"made.geojson"};
  Dice dice(seed);
  const auto star = [&](Vec2 center, double low, double high) {
    Points ring;
    const int corners = 3 + static_cast<int>(dice(0, 9));
    for (int k = 0; k < corners; ++k) {
      const double angle = 2 * std::numbers::pi * k / corners;
      const double radius = dice(low, high);
      ring.push_back(center + Vec2{radius * std::cos(angle), radius * std::sin(angle)});
    }
    ring.push_back(ring.front());
    return ring;
  };
  for (int i = 0; i < 8; ++i) {
    const Vec2 center{dice(0, 10), dice(0, 10)};
    InputLine ring;
    ring.polygon_ring = true;
    ring.points = star(center, 2, 4);
    set.lines.push_back(ring);
    if (dice(0, 1) < 0.5) {
      // The outer ring is at least cos(60 degrees) of its smallest radius away from the center.
      ring.points = star(center, 0.2, 0.99);
      ring.hole = true;
      set.lines.push_back(ring);
    }
  }
  return set;
}

}  // namespace quarry
