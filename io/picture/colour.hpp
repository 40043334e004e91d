// Colours of pictures. All are functions of a number alone, so that a region keeps its colour from picture to
// picture.
#pragma once

#include <cstdint>

namespace quarry {

// sRGB, each in [0, 1].
struct Colour {
  double red = 0;
  double green = 0;
  double blue = 0;
};

// A colour of even lightness for the eye. lightness in [0, 1], chroma from 0 (grey), hue in degrees.
// Source: B. Ottosson, "A perceptual color space for image processing" (Oklab), 2020.
[[nodiscard]] Colour oklch(double lightness, double chroma, double hue);

// Pastels; numbers that follow each other are far apart in hue.
[[nodiscard]] Colour region_colour(std::int32_t region);
// Strong colours for lines on pale ground; dark grey for -1.
[[nodiscard]] Colour line_colour(std::int32_t constraint);
// From deep red at 0 over sand to blue at 1; black where quality is not positive or not a number.
[[nodiscard]] Colour quality_colour(double quality);

}  // namespace quarry
