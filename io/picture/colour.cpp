#include "io/picture/colour.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace quarry {
namespace {

// Turning by the golden angle keeps any few numbers in a row well apart in hue.
constexpr double kGoldenAngle = 137.50776405003785;

double srgb_of_linear(double value) {
  const double v = std::clamp(value, 0.0, 1.0);
  return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}

struct Stop {
  double at;
  Colour colour;
};

// Lightness rises from bad to sand and falls a little to good: bad faces are dark among light ones, and the
// scale can be read by people who do not tell red from green.
constexpr std::array<Stop, 8> kQualityScale = {{{0.0, {0.40, 0.00, 0.12}},
                                                {0.2, {0.73, 0.12, 0.16}},
                                                {0.4, {0.91, 0.42, 0.25}},
                                                {0.6, {0.98, 0.70, 0.42}},
                                                {0.75, {0.98, 0.88, 0.66}},
                                                {0.87, {0.91, 0.94, 0.89}},
                                                {0.95, {0.75, 0.87, 0.91}},
                                                {1.0, {0.56, 0.76, 0.88}}}};

double mix(double a, double b, double t) { return a + t * (b - a); }

}  // namespace

Colour oklch(double lightness, double chroma, double hue) {
  const double angle = hue * std::numbers::pi / 180;
  const double a = chroma * std::cos(angle);
  const double b = chroma * std::sin(angle);
  const double l = std::pow(lightness + 0.3963377774 * a + 0.2158037573 * b, 3);
  const double m = std::pow(lightness - 0.1055613458 * a - 0.0638541728 * b, 3);
  const double s = std::pow(lightness - 0.0894841775 * a - 1.2914855480 * b, 3);
  return {srgb_of_linear(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
          srgb_of_linear(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
          srgb_of_linear(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

Colour region_colour(std::int32_t region) {
  constexpr std::array kLightness = {0.90, 0.86, 0.93, 0.88};
  constexpr std::array kChroma = {0.048, 0.060, 0.042};
  const auto number = static_cast<std::uint32_t>(region);
  // The first regions, often the only ones, start from a warm sand.
  return oklch(kLightness[number % kLightness.size()], kChroma[number % kChroma.size()],
               std::fmod(85 + kGoldenAngle * number, 360));
}

Colour line_colour(std::int32_t constraint) {
  if (constraint < 0) return {0.25, 0.27, 0.30};
  constexpr std::array kLightness = {0.52, 0.62, 0.45};
  const auto number = static_cast<std::uint32_t>(constraint);
  return oklch(kLightness[number % kLightness.size()], 0.16, std::fmod(30 + kGoldenAngle * number, 360));
}

Colour quality_colour(double quality) {
  if (!(quality > 0)) return {0, 0, 0};
  const double q = std::min(quality, 1.0);
  const auto* upper = std::find_if(kQualityScale.begin() + 1, kQualityScale.end() - 1,
                                   [&](const Stop& stop) { return stop.at >= q; });
  const Stop& low = *(upper - 1);
  const double t = (q - low.at) / (upper->at - low.at);
  return {mix(low.colour.red, upper->colour.red, t), mix(low.colour.green, upper->colour.green, t),
          mix(low.colour.blue, upper->colour.blue, t)};
}

}  // namespace quarry
