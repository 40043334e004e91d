#include "engine/geometry/predicates.hpp"

#include <cmath>

#include "engine/geometry/double_word.hpp"
#include "engine/geometry/expansion.hpp"

// Each predicate has three stages, and "permanent" is the sum of the magnitudes of the determinant's terms:
//   1. plain doubles, with the error bounds of the first stage of Shewchuk 1997 (table of section 4:
//   ccwerrboundA,
//      o3derrboundA, iccerrboundA), in units of u = 2^-53;
//   2. double-words on exact differences, with the bound kDoubleWordBound;
//   3. expansions, exact.
// The second stage stands in place of Shewchuk's B and C: it costs the same whether or not the differences
// round.

namespace quarry {
namespace {

constexpr double kUnit = 0x1p-53;
constexpr double kOrient2dBound = (3 + 16 * kUnit) * kUnit;
constexpr double kOrient3dBound = (7 + 56 * kUnit) * kUnit;
constexpr double kIncircleBound = (10 + 96 * kUnit) * kUnit;

// Differences are exact, a product adds 5 u^2 and a sum 3 u^2 of relative error to the permanent of its terms
// (double_word.hpp). A 2x2 minor has 9 u^2 (rounded up, as all that follow); orient3d is 9 + 5 + 3 + 3, below
// 21 u^2; incircle has lifts of 5 + 3, below 9 u^2, and is 9 + 9 + 5 + 3 + 3, below 30 u^2. 64 u^2 = 2^-100
// leaves a factor of two for the rounding of the permanent itself.
constexpr double kDoubleWordBound = 0x1p-100;

// The numbers that the later stages work with: exact differences, either as double-words or as expansions.
template <class Number>
Number exact_difference(double a, double b) {
  return Number(two_difference(a, b));
}

template <class Number>
auto orient2d_determinant(Vec2 a, Vec2 b, Vec2 c) {
  const Number acx = exact_difference<Number>(a.x, c.x);
  const Number acy = exact_difference<Number>(a.y, c.y);
  const Number bcx = exact_difference<Number>(b.x, c.x);
  const Number bcy = exact_difference<Number>(b.y, c.y);
  return acx * bcy - acy * bcx;
}

template <class Number>
auto orient3d_determinant(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  const Number adx = exact_difference<Number>(a.x, d.x);
  const Number ady = exact_difference<Number>(a.y, d.y);
  const Number adz = exact_difference<Number>(a.z, d.z);
  const Number bdx = exact_difference<Number>(b.x, d.x);
  const Number bdy = exact_difference<Number>(b.y, d.y);
  const Number bdz = exact_difference<Number>(b.z, d.z);
  const Number cdx = exact_difference<Number>(c.x, d.x);
  const Number cdy = exact_difference<Number>(c.y, d.y);
  const Number cdz = exact_difference<Number>(c.z, d.z);
  return (bdx * cdy - cdx * bdy) * adz + (cdx * ady - adx * cdy) * bdz + (adx * bdy - bdx * ady) * cdz;
}

template <class Number>
auto incircle_determinant(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const Number adx = exact_difference<Number>(a.x, d.x);
  const Number ady = exact_difference<Number>(a.y, d.y);
  const Number bdx = exact_difference<Number>(b.x, d.x);
  const Number bdy = exact_difference<Number>(b.y, d.y);
  const Number cdx = exact_difference<Number>(c.x, d.x);
  const Number cdy = exact_difference<Number>(c.y, d.y);
  return (bdx * cdy - cdx * bdy) * (adx * adx + ady * ady) +
         (cdx * ady - adx * cdy) * (bdx * bdx + bdy * bdy) +
         (adx * bdy - bdx * ady) * (cdx * cdx + cdy * cdy);
}

bool certain(double determinant, double bound) { return std::abs(determinant) >= bound; }

[[gnu::noinline]] double orient2d_slow(Vec2 a, Vec2 b, Vec2 c, double permanent) {
  const DoubleWord near = orient2d_determinant<DoubleWord>(a, b, c);
  if (certain(near.high, kDoubleWordBound * permanent)) return near.high;
  return orient2d_determinant<Expansion<2>>(a, b, c).leading();
}

[[gnu::noinline]] double orient3d_slow(Vec3 a, Vec3 b, Vec3 c, Vec3 d, double permanent) {
  const DoubleWord near = orient3d_determinant<DoubleWord>(a, b, c, d);
  if (certain(near.high, kDoubleWordBound * permanent)) return near.high;
  return orient3d_determinant<Expansion<2>>(a, b, c, d).leading();
}

[[gnu::noinline]] double incircle_slow(Vec2 a, Vec2 b, Vec2 c, Vec2 d, double permanent) {
  const DoubleWord near = incircle_determinant<DoubleWord>(a, b, c, d);
  if (certain(near.high, kDoubleWordBound * permanent)) return near.high;
  return incircle_determinant<Expansion<2>>(a, b, c, d).leading();
}

}  // namespace

double orient2d(Vec2 a, Vec2 b, Vec2 c) {
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  const double determinant = left - right;
  const double permanent = std::abs(left) + std::abs(right);
  if (certain(determinant, kOrient2dBound * permanent)) return determinant;
  return orient2d_slow(a, b, c, permanent);
}

double orient3d(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  const Vec3 ad = a - d;
  const Vec3 bd = b - d;
  const Vec3 cd = c - d;
  const double bc = bd.x * cd.y;
  const double cb = cd.x * bd.y;
  const double ca = cd.x * ad.y;
  const double ac = ad.x * cd.y;
  const double ab = ad.x * bd.y;
  const double ba = bd.x * ad.y;
  const double determinant = ad.z * (bc - cb) + bd.z * (ca - ac) + cd.z * (ab - ba);
  const double permanent = (std::abs(bc) + std::abs(cb)) * std::abs(ad.z) +
                           (std::abs(ca) + std::abs(ac)) * std::abs(bd.z) +
                           (std::abs(ab) + std::abs(ba)) * std::abs(cd.z);
  if (certain(determinant, kOrient3dBound * permanent)) return determinant;
  return orient3d_slow(a, b, c, d, permanent);
}

double incircle(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const Vec2 ad = a - d;
  const Vec2 bd = b - d;
  const Vec2 cd = c - d;
  const double bc = bd.x * cd.y;
  const double cb = cd.x * bd.y;
  const double ca = cd.x * ad.y;
  const double ac = ad.x * cd.y;
  const double ab = ad.x * bd.y;
  const double ba = bd.x * ad.y;
  const double a_lift = squared_length(ad);
  const double b_lift = squared_length(bd);
  const double c_lift = squared_length(cd);
  const double determinant = a_lift * (bc - cb) + b_lift * (ca - ac) + c_lift * (ab - ba);
  const double permanent = (std::abs(bc) + std::abs(cb)) * a_lift + (std::abs(ca) + std::abs(ac)) * b_lift +
                           (std::abs(ab) + std::abs(ba)) * c_lift;
  if (certain(determinant, kIncircleBound * permanent)) return determinant;
  return incircle_slow(a, b, c, d, permanent);
}

}  // namespace quarry
