// Error-free sums and products of doubles, and double-words: numbers kept as the unevaluated sum of two
// doubles, which carry about 106 bits. Everything here supposes round-to-nearest, no contraction and no
// overflow or underflow. Sources: T. J. Dekker 1971 (split, product), D. E. Knuth (two_sum), M. Joldes, J.-M.
// Muller, V. Popescu, "Tight and rigorous error bounds for basic building blocks of double-word arithmetic",
// ACM TOMS 44(2), 2017.
#pragma once

namespace quarry {

// high + low, with high the double nearest to that sum.
struct DoubleWord {
  double high = 0;
  double low = 0;
};

// a + b exactly.
constexpr DoubleWord two_sum(double a, double b) {
  const double sum = a + b;
  const double b_part = sum - a;
  const double a_part = sum - b_part;
  return {sum, (a - a_part) + (b - b_part)};
}

// a + b exactly, if a is zero or its exponent is not below that of b.
constexpr DoubleWord fast_two_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

// a - b exactly.
constexpr DoubleWord two_difference(double a, double b) { return two_sum(a, -b); }

// a as the sum of two doubles of at most 26 bits each (Veltkamp).
constexpr DoubleWord split(double a) {
  constexpr double kSplitter = 0x1p27 + 1;
  const double scaled = kSplitter * a;
  const double high = scaled - (scaled - a);
  return {high, a - high};
}

// a * b exactly. By splitting and not by a fused product, which the baseline of x86-64 lacks.
constexpr DoubleWord two_product(double a, double b) {
  const double product = a * b;
  const DoubleWord x = split(a);
  const DoubleWord y = split(b);
  const double rest = ((product - x.high * y.high) - x.low * y.high) - x.high * y.low;
  return {product, x.low * y.low - rest};
}

constexpr DoubleWord operator-(DoubleWord a) { return {-a.high, -a.low}; }

// With an error of at most 3 u^2 (|a| + |b|), u = 2^-53: the sum of the low parts is rounded once (u times at
// most u (|a| + |b|)) and once more after the rounding error of the high parts joins it (u times at most
// twice that).
constexpr DoubleWord operator+(DoubleWord a, DoubleWord b) {
  const DoubleWord sum = two_sum(a.high, b.high);
  return two_sum(sum.high, sum.low + (a.low + b.low));
}
constexpr DoubleWord operator-(DoubleWord a, DoubleWord b) { return a + (-b); }

// With an error of at most 5 u^2 |a b| (Joldes, Muller & Popescu 2017, algorithm DWTimesDW1).
constexpr DoubleWord operator*(DoubleWord a, DoubleWord b) {
  const DoubleWord product = two_product(a.high, b.high);
  return fast_two_sum(product.high, product.low + (a.high * b.low + a.low * b.high));
}

}  // namespace quarry
