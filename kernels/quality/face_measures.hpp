// All measures of one face together: the same values as the functions of kernels/quality/element.hpp, from
// products that are computed once.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "kernels/quality/element.hpp"

namespace quarry {

struct FaceMeasures {
  double scaled_jacobian;
  AngleRange angles;
  double lo;  // of a triangle alpha [Lo], of a quad phi [LeeLo]
  EdgeRange edges;
};

namespace detail {

// Grows with the angle of (x, y) in [0, 360) degrees as that does, at the price of one division.
inline double angle_order(double x, double y) {
  const double sum = std::abs(x) + std::abs(y);
  if (!(sum > 0)) return 0;
  return y < 0 ? 3 + x / sum : 1 - x / sum;
}

inline double degrees(double x, double y) {
  const double angle = std::atan2(y, x) * kDegreesPerRadian;
  return angle < 0 ? angle + 360.0 : angle;
}

// Edges and corners of a face; corner i lies between the edges i - 1 and i.
template <std::size_t N>
struct FaceProducts {
  std::array<double, N> squares;  // squared lengths of the edges
  std::array<double, N> turn;     // cross product at each corner
  std::array<double, N> along;    // dot product at each corner

  explicit FaceProducts(const std::array<Vec2, N>& p) {
    std::array<Vec2, N> edge;
    for (std::size_t i = 0; i < N; ++i) {
      edge[i] = p[(i + 1) % N] - p[i];
      squares[i] = squared_length(edge[i]);
    }
    for (std::size_t i = 0; i < N; ++i) {
      const Vec2 back = edge[(i + N - 1) % N];
      turn[i] = cross(back, edge[i]);
      along[i] = -dot(back, edge[i]);
    }
  }

  [[nodiscard]] double smallest_sine() const {
    double smallest = 1;
    for (std::size_t i = 0; i < N; ++i) {
      const double lengths = std::sqrt(squares[i] * squares[(i + N - 1) % N]);
      smallest = std::min(smallest, lengths > 0 ? turn[i] / lengths : -1.0);
    }
    return smallest;
  }

  [[nodiscard]] AngleRange angle_range() const {
    std::array<double, N> order;
    for (std::size_t i = 0; i < N; ++i) order[i] = angle_order(along[i], turn[i]);
    const auto [low, high] = std::minmax_element(order.begin(), order.end());
    const auto smallest = static_cast<std::size_t>(low - order.begin());
    const auto largest = static_cast<std::size_t>(high - order.begin());
    return {degrees(along[smallest], turn[smallest]), degrees(along[largest], turn[largest])};
  }

  [[nodiscard]] EdgeRange edge_range() const {
    const auto [low, high] = std::minmax_element(squares.begin(), squares.end());
    return {std::sqrt(*low), std::sqrt(*high)};
  }
};

}  // namespace detail

inline FaceMeasures face_measures(Vec2 a, Vec2 b, Vec2 c) {
  const detail::FaceProducts<3> face({a, b, c});
  const double squares = face.squares[0] + face.squares[1] + face.squares[2];
  return {2 / kSqrt3 * face.smallest_sine(), face.angle_range(),
          squares > 0 ? 2 * kSqrt3 * face.turn[0] / squares : 0.0, face.edge_range()};
}

inline FaceMeasures face_measures(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const detail::FaceProducts<4> face({a, b, c, d});
  // The triangle at corner i has the edges i - 1 and i and the diagonal that does not meet the corner.
  const std::array<double, 2> diagonals = {squared_length(d - b), squared_length(c - a)};
  std::array<double, 4> alpha;
  for (std::size_t i = 0; i < 4; ++i) {
    const double squares = face.squares[i] + face.squares[(i + 3) % 4] + diagonals[i % 2];
    alpha[i] = squares > 0 ? 2 * kSqrt3 * face.turn[i] / squares : 0.0;
  }
  return {face.smallest_sine(), face.angle_range(), lee_lo_phi(alpha), face.edge_range()};
}

}  // namespace quarry
