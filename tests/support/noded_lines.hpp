// Hand-made cleaned line work for tests.
#pragma once

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "engine/base/random.hpp"
#include "engine/geometry/line_set.hpp"
#include "engine/geometry/predicates.hpp"

namespace quarry::test {

// Builds NodedLines piece by piece; equal points are one node.
class NodedLinesBuilder {
 public:
  NodeId node(Vec2 p) {
    for (std::size_t i = 0; i < lines_.nodes.size(); ++i)
      if (lines_.nodes[NodeId(i)] == p) return NodeId(i);
    return lines_.nodes.push_back(p);
  }
  void piece(Vec2 a, Vec2 b) {
    const NodeId from = node(a);
    const NodeId to = node(b);
    lines_.line_begin.push_back(static_cast<std::uint32_t>(lines_.line_numbers.size()));
    lines_.line_numbers.push_back(LineId(lines_.pieces.size()));
    lines_.pieces.push_back({from, to, PieceKindOf::kInterior});
  }
  void polyline(const std::vector<Vec2>& points) {
    for (std::size_t i = 0; i + 1 < points.size(); ++i) piece(points[i], points[i + 1]);
  }
  NodedLines finish() {
    lines_.line_begin.push_back(static_cast<std::uint32_t>(lines_.line_numbers.size()));
    return std::move(lines_);
  }

 private:
  NodedLines lines_;
};

// Rays from one point, evenly spread over `turn` radians.
inline NodedLines star(Vec2 center, double radius, int rays, double turn = 2 * std::numbers::pi,
                       double first = 0.1) {
  NodedLinesBuilder builder;
  for (int i = 0; i < rays; ++i) {
    const double angle = first + turn * i / rays;
    builder.piece(center, {center.x + radius * std::cos(angle), center.y + radius * std::sin(angle)});
  }
  return builder.finish();
}

// Parallel lines of a given length and distance, at an angle.
inline NodedLines comb(Vec2 origin, double length, double gap, int teeth, double angle) {
  NodedLinesBuilder builder;
  const Vec2 along{std::cos(angle), std::sin(angle)};
  const Vec2 across{-along.y, along.x};
  for (int i = 0; i < teeth; ++i) {
    const Vec2 a = origin + (gap * i) * across;
    builder.piece(a, a + length * along);
  }
  return builder.finish();
}

// Random segments of which none comes nearer than `gap` to another: a soup that needs no cleaning.
inline NodedLines random_segments(std::uint64_t seed, int wanted, double size, double gap, Vec2 origin) {
  NodedLinesBuilder builder;
  std::vector<std::pair<Vec2, Vec2>> kept;
  const auto near = [&](Vec2 p, Vec2 a, Vec2 b) {
    const Vec2 d = b - a;
    const double t = std::clamp(dot(p - a, d) / squared_length(d), 0.0, 1.0);
    return distance(p, a + t * d) < gap;
  };
  for (int i = 0; i < 20 * wanted && static_cast<int>(kept.size()) < wanted; ++i) {
    const auto draw = [&](int k) { return uniform01(seed, static_cast<std::uint64_t>(4 * i + k)); };
    const Vec2 a{origin.x + size * draw(0), origin.y + size * draw(1)};
    const double angle = 2 * std::numbers::pi * draw(2);
    const double length = size * (0.01 + 0.2 * draw(3));
    const Vec2 b{a.x + length * std::cos(angle), a.y + length * std::sin(angle)};
    bool clear = b.x > origin.x && b.y > origin.y && b.x < origin.x + size && b.y < origin.y + size;
    for (const auto& [c, d] : kept) {
      if (!clear) break;
      const bool crosses =
          orient2d(a, b, c) * orient2d(a, b, d) <= 0 && orient2d(c, d, a) * orient2d(c, d, b) <= 0;
      clear = !crosses && !near(a, c, d) && !near(b, c, d) && !near(c, a, b) && !near(d, a, b);
    }
    if (clear) kept.emplace_back(a, b);
  }
  for (const auto& [a, b] : kept) builder.piece(a, b);
  return builder.finish();
}

}  // namespace quarry::test
