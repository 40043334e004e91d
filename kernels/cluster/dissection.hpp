// The ways to cut a polygon into quads, with one triangle where its number of corners is odd; four corners
// may also be cut into two triangles.
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace quarry {

inline constexpr int kMostPolygonCorners = 10;

struct Dissection {
  static constexpr int kMostFaces = 4;
  static constexpr std::uint8_t kNone = 255;

  int face_count = 0;
  int triangle_count = 0;
  // Corners by their place around the polygon, counter-clockwise; the fourth of a triangle is kNone.
  std::array<std::array<std::uint8_t, 4>, kMostFaces> faces{};
  // How many faces meet at each corner of the polygon.
  std::array<std::uint8_t, kMostPolygonCorners> faces_at{};
};

// All dissections of a polygon of 4 to 10 corners without new points, in a fixed order: 3, 5, 3, 28, 12, 165,
// 55.
[[nodiscard]] std::span<const Dissection> dissections(int corners);

}  // namespace quarry
