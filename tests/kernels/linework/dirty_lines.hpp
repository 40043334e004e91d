// Dirty line sets, each a pure function of its numbers: grids, stars, combs, crossings under a degree and
// random lines, with copies that are off by anything from a thousandth of the box down to one unit in the
// last place.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include "tests/kernels/linework/random_lines.hpp"

namespace quarry {

struct DirtySet {
  std::uint64_t seed = 0;
  int lines = 5;        // about as many, 5 to 500
  int snap = 4;         // the snapping distance is 10^-snap of the box
  int scale = 0;        // the box has a side of 10^scale
  int offset = 0;       // and lies at 10^offset, or at 0 for 0
  double min_edge = 1;  // in snapping distances
};

class DirtyLines {
 public:
  explicit DirtyLines(const DirtySet& set) : set_(set), dice_(set.seed) {}

  LineSet draw() {
    while (static_cast<int>(lines_.size()) < set_.lines) {
      const int kind = static_cast<int>(dice_(0, 8));
      if (kind == 0) add_grid();
      if (kind == 1) add_star();
      if (kind == 2) add_comb();
      if (kind == 3) add_narrow_crossing();
      if (kind == 4) lines_.push_back({anywhere(), anywhere()});
      if (kind == 5) add_crooked();
      if (kind >= 6) add_copy();
    }
    lines_.resize(static_cast<std::size_t>(set_.lines));
    lines_.push_back({{0, 0}, {1, 0.5}});  // one that no snapping distance swallows
    const double scale = std::pow(10, set_.scale);
    const double offset = set_.offset == 0 ? 0 : std::pow(10, set_.offset);
    for (Points& line : lines_)
      for (Vec2& p : line) p = {p.x * scale + offset, p.y * scale + offset};
    add_last_units();
    return lines_of(lines_);
  }

 private:
  Vec2 anywhere() { return {dice_(0, 1), dice_(0, 1)}; }
  // A share of the box: 10^-3 to 10^-16, or 0.
  double little() { return dice_(0, 1) < 0.1 ? 0 : std::pow(10, dice_(-16, -3)); }
  Vec2 near(Vec2 p, double by) { return p + Vec2{dice_(-by, by), dice_(-by, by)}; }
  int count(int most) { return 2 + static_cast<int>(dice_(0, most - 1)); }

  void add_grid() {
    const int side = count(12);
    const double by = little();
    for (int i = 0; i < side; ++i) {
      const double at = (i + 0.5) / side;
      lines_.push_back({near({0, at}, by), near({1, at}, by)});
      lines_.push_back({near({at, 0}, by), near({at, 1}, by)});
    }
  }

  void add_star() {
    const Vec2 middle = anywhere();
    const int rays = count(40);
    const double by = little();
    const double length = dice_(0.05, 0.5);
    const bool through = dice_(0, 1) < 0.5;
    for (int i = 0; i < rays; ++i) {
      const double angle = std::numbers::pi * (through ? 1 : 2) * i / rays;
      const Vec2 along = length * Vec2{std::cos(angle), std::sin(angle)};
      lines_.push_back({near(through ? middle - along : middle, by), middle + along});
    }
  }

  void add_comb() {
    const Vec2 from = anywhere();
    const Vec2 to = anywhere();
    const double gap = little();
    const int teeth = count(20);
    for (int i = 0; i < teeth; ++i) lines_.push_back({from + Vec2{0, i * gap}, to + Vec2{0, i * gap}});
  }

  void add_narrow_crossing() {
    const Vec2 from = anywhere();
    const Vec2 to = anywhere();
    const Vec2 across = std::pow(10, dice_(-7, -1.8)) * Vec2{from.y - to.y, to.x - from.x};
    lines_.push_back({from, to});
    lines_.push_back({from - across, to + across});
  }

  void add_crooked() {
    Points line{anywhere()};
    const double step = std::pow(10, dice_(-5, -0.5));
    const int steps = count(10);
    for (int i = 0; i < steps; ++i) line.push_back(dice_(0, 1) < 0.1 ? line.back() : near(line.back(), step));
    if (dice_(0, 1) < 0.2) line.push_back(line.front());
    lines_.push_back(line);
  }

  // Of an earlier line: the same or backwards, shifted as a whole, point by point, or to a point.
  void add_copy() {
    if (lines_.empty()) return;
    Points line = lines_[static_cast<std::size_t>(dice_(0, static_cast<double>(lines_.size())))];
    const double by = little();
    const double kind = dice_(0, 1);
    const Vec2 shift = near({}, by);
    for (Vec2& p : line) p = kind < 0.5 ? p + shift : near(p, by);
    if (dice_(0, 1) < 0.3) line = Points(line.rbegin(), line.rend());
    if (dice_(0, 1) < 0.1) line = Points(line.size(), line.front());
    if (dice_(0, 1) < 0.2) line.front() = line.front() + 0.5 * (line.back() - line.front());
    lines_.push_back(line);
  }

  // Copies that differ from the line before by one unit in the last place of some coordinates.
  void add_last_units() {
    const std::size_t size = lines_.size();
    for (std::size_t i = 0; i < size; i += 7) {
      Points line = lines_[i];
      for (Vec2& p : line)
        if (dice_(0, 1) < 0.5) p.x = std::nextafter(p.x, std::numeric_limits<double>::infinity());
      lines_.push_back(line);
    }
  }

  DirtySet set_;
  Dice dice_;
  std::vector<Points> lines_;
};

}  // namespace quarry
