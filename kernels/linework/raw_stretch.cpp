#include "kernels/linework/raw_stretch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/geometry/segment.hpp"

namespace quarry::linework {
namespace {

// Calls visit(segment number, from, to) for each raw segment of the stretch, with the shares it covers.
template <class Visit>
void for_each_part(std::span<const Vec2> line, double from, double to, Visit&& visit) {
  const std::size_t last = line.size() - 2;
  std::size_t i = std::min(last, static_cast<std::size_t>(from));
  const std::size_t end = std::min(last, static_cast<std::size_t>(to));
  for (; i <= end; ++i) {
    const auto base = static_cast<double>(i);
    visit(i, std::clamp(from - base, 0.0, 1.0), std::clamp(to - base, 0.0, 1.0));
  }
}

}  // namespace

Vec2 raw_point(std::span<const Vec2> line, double at) {
  if (line.size() == 1) return line.front();
  const std::size_t i = std::min(line.size() - 2, static_cast<std::size_t>(at));
  return point_at(at - static_cast<double>(i), line[i], line[i + 1]);
}

double nearest_parameter(std::span<const Vec2> line, double from, double to, Vec2 p) {
  double best = from;
  double best_distance = std::numeric_limits<double>::infinity();
  for_each_part(line, from, to, [&](std::size_t i, double low, double high) {
    const double t = std::clamp(closest_parameter(p, line[i], line[i + 1]), low, high);
    const double d = squared_length(point_at(t, line[i], line[i + 1]) - p);
    if (d < best_distance) {
      best_distance = d;
      best = std::clamp(static_cast<double>(i) + t, from, to);
    }
  });
  return best;
}

double deviation(std::span<const Vec2> line, double from, double to, Vec2 a, Vec2 b) {
  const Vec2 begin = raw_point(line, from);
  const Vec2 end = raw_point(line, to);
  // The distance from a convex set is convex along each raw segment: its vertices are enough.
  double worst = std::max(squared_length(begin - a), squared_length(end - b));
  for (auto i = static_cast<std::size_t>(from) + 1; static_cast<double>(i) < to; ++i)
    worst = std::max(worst, squared_distance(line[i], a, b));
  return std::sqrt(worst);
}

double farthest_vertex(std::span<const Vec2> line, double from, double to, Vec2 a, Vec2 b) {
  double best = from;
  double worst = -1;
  for (auto i = static_cast<std::size_t>(from) + 1; static_cast<double>(i) < to; ++i) {
    const double d = squared_distance(line[i], a, b);
    if (d > worst) {
      worst = d;
      best = static_cast<double>(i);
    }
  }
  return best;
}

double advance(std::span<const Vec2> line, double from, double to, double along) {
  const bool forward = from < to;
  double at = from;
  while (at != to) {
    // The next vertex in this direction, or the goal.
    const double vertex = forward ? std::floor(at) + 1 : std::ceil(at) - 1;
    const double next = forward ? std::min(vertex, to) : std::max(vertex, to);
    const double step = distance(raw_point(line, at), raw_point(line, next));
    if (step >= along) return at + (next - at) * (along / step);
    along -= step;
    at = next;
  }
  return to;
}

double stretch_length(std::span<const Vec2> line, double from, double to) {
  double sum = 0;
  for_each_part(line, from, to, [&](std::size_t i, double low, double high) {
    sum += (high - low) * distance(line[i], line[i + 1]);
  });
  return sum;
}

}  // namespace quarry::linework
