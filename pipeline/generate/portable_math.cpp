#include "pipeline/generate/portable_math.hpp"

#include <cmath>
#include <numbers>

namespace quarry::portable {
namespace {

// log 2 and pi / 2 in two parts: the first has so many zeros at its end that its products with small whole
// numbers are exact.
constexpr double kLogTwoHigh = 0x1.62e42fee00000p-1;
constexpr double kLogTwoLow = 0x1.a39ef35793c76p-33;
constexpr double kQuarterHigh = 0x1.921fb54400000p+0;
constexpr double kQuarterLow = 0x1.0b4611a626331p-34;

// Of |r| up to pi / 4: Taylor's series to the terms that a double no longer feels.
double small_sine(double r) {
  const double square = r * r;
  double sum = 0;
  for (int k = 17; k >= 3; k -= 2) sum = (1 + sum) * -square / (k * (k - 1));
  return r + r * sum;
}

double small_cosine(double r) {
  const double square = r * r;
  double sum = 0;
  for (int k = 18; k >= 2; k -= 2) sum = (1 + sum) * -square / (k * (k - 1));
  return 1 + sum;
}

}  // namespace

double log(double x) {
  int exponent = 0;
  double mantissa = std::frexp(x, &exponent);  // exact
  if (mantissa < 0.5 * std::numbers::sqrt2) {
    mantissa *= 2;
    --exponent;
  }
  // log m = 2 artanh((m - 1) / (m + 1)), whose argument is at most 0.172.
  const double s = (mantissa - 1) / (mantissa + 1);
  const double square = s * s;
  double sum = 0;
  for (int k = 21; k >= 3; k -= 2) sum = (sum + 1.0 / k) * square;
  return exponent * kLogTwoHigh + (2 * s + (2 * s * sum + exponent * kLogTwoLow));
}

double exp(double x) {
  const double whole = std::round(x / std::numbers::ln2);
  const double r = (x - whole * kLogTwoHigh) - whole * kLogTwoLow;
  double sum = 1;
  for (int k = 16; k >= 1; --k) sum = 1 + sum * r / k;
  return std::ldexp(sum, static_cast<int>(whole));  // exact
}

double power(double base, double exponent) { return exp(exponent * log(base)); }

Vec2 direction(double radians) {
  const double quarters = std::round(radians / (0.5 * std::numbers::pi));
  const double r = (radians - quarters * kQuarterHigh) - quarters * kQuarterLow;
  const double sine = small_sine(r), cosine = small_cosine(r);
  switch (static_cast<int>(quarters) & 3) {
    case 0:
      return {cosine, sine};
    case 1:
      return {-sine, cosine};
    case 2:
      return {-cosine, -sine};
    default:
      return {sine, -cosine};
  }
}

}  // namespace quarry::portable
