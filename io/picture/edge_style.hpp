// How strong the edges of elements are drawn.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "engine/geometry/vec.hpp"
#include "io/picture/colour.hpp"
#include "io/picture/view.hpp"

namespace quarry {

inline constexpr Colour kElementInk{0.16, 0.21, 0.28};
inline constexpr Colour kConstraintInk{0.10, 0.13, 0.18};
inline constexpr Colour kOutlineInk{0.05, 0.07, 0.10};

// How edges of elements of at least so many pixels are drawn.
struct EdgeStyle {
  double from_pixels;
  double opacity;
  double width;
};
inline constexpr std::array<EdgeStyle, 6> kEdgeStyles = {{{2.2, 0.10, 0.5},
                                                          {3.2, 0.20, 0.55},
                                                          {4.5, 0.30, 0.6},
                                                          {7.0, 0.42, 0.7},
                                                          {12.0, 0.52, 0.85},
                                                          {24.0, 0.62, 1.1}}};

// The side of a square of the face's area, in pixels of a picture of 1600. corners: as in the mesh, or as
// seen.
inline double pixels_of_face(const PictureView& view, std::span<const Vec2> corners) {
  double doubled = 0;
  for (std::size_t k = 1; k + 1 < corners.size(); ++k)
    doubled += cross(corners[k] - corners[0], corners[k + 1] - corners[0]);
  return std::sqrt(0.5 * std::abs(doubled)) * view.scale() / view.unit();
}

// The number of a style; -1: the edges could not be told apart.
inline int edge_style_of(double pixels) {
  int style = -1;
  while (style + 1 < static_cast<int>(kEdgeStyles.size()) &&
         pixels >= kEdgeStyles[static_cast<std::size_t>(style + 1)].from_pixels)
    ++style;
  return style;
}

// Lines as wide as elements of so many pixels leave room for.
inline double constraint_width(double mean_pixels) { return std::clamp(0.25 * mean_pixels, 1.2, 2.4); }

}  // namespace quarry
