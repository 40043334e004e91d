// Exact arithmetic on sums of doubles (expansions) of a length bounded at compile time. Terms are kept
// without zeros, by increasing magnitude, strongly nonoverlapping; every operation below keeps them so.
// Source: J. R. Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric
// predicates", Discrete & Computational Geometry 18, 1997 (FAST-EXPANSION-SUM, SCALE-EXPANSION, both with
// zero elimination).
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "engine/geometry/double_word.hpp"

namespace quarry {

template <std::size_t Capacity>
struct Expansion {
  // Neither initialised nor copied beyond size: the longest ones could hold some kilobytes and seldom do.
  std::array<double, Capacity> terms;
  std::size_t size = 0;

  Expansion() = default;
  explicit Expansion(DoubleWord value) {
    push(value.low);
    push(value.high);
  }
  Expansion(const Expansion& other) : size(other.size) { copy_terms(other); }
  Expansion& operator=(const Expansion& other) {
    size = other.size;
    copy_terms(other);
    return *this;
  }

  void push(double term) {
    if (term != 0) terms[size++] = term;
  }
  // The greatest term: it has the sign of the sum, and its magnitude within a rounding error.
  [[nodiscard]] double leading() const { return size == 0 ? 0 : terms[size - 1]; }

 private:
  void copy_terms(const Expansion& other) {
    for (std::size_t i = 0; i < size; ++i) terms[i] = other.terms[i];
  }
};

template <std::size_t N>
Expansion<N> operator-(Expansion<N> a) {
  for (std::size_t i = 0; i < a.size; ++i) a.terms[i] = -a.terms[i];
  return a;
}

// sum = a + b; sum is neither a nor b, and its capacity holds the terms of both.
template <std::size_t N, std::size_t M, std::size_t K>
void add(const Expansion<N>& a, const Expansion<M>& b, Expansion<K>& sum) {
  sum.size = 0;
  std::size_t i = 0;
  std::size_t j = 0;
  const auto next_smallest = [&] {
    const bool from_a = j == b.size || (i < a.size && std::abs(a.terms[i]) < std::abs(b.terms[j]));
    return from_a ? a.terms[i++] : b.terms[j++];
  };
  double carry = 0;
  while (i < a.size || j < b.size) {
    const DoubleWord step = two_sum(carry, next_smallest());
    sum.push(step.low);
    carry = step.high;
  }
  sum.push(carry);
}

template <std::size_t N, std::size_t M>
Expansion<N + M> operator+(const Expansion<N>& a, const Expansion<M>& b) {
  Expansion<N + M> sum;
  add(a, b, sum);
  return sum;
}

template <std::size_t N, std::size_t M>
Expansion<N + M> operator-(const Expansion<N>& a, const Expansion<M>& b) {
  return a + (-b);
}

template <std::size_t N>
Expansion<2 * N> operator*(const Expansion<N>& a, double factor) {
  Expansion<2 * N> product;
  double carry = 0;
  for (std::size_t i = 0; i < a.size; ++i) {
    const DoubleWord term = two_product(a.terms[i], factor);
    const DoubleWord low = two_sum(carry, term.low);
    const DoubleWord high = fast_two_sum(term.high, low.high);
    product.push(low.low);
    product.push(high.low);
    carry = high.high;
  }
  product.push(carry);
  return product;
}

// The sum of a times each term of b, small terms first.
template <std::size_t N, std::size_t M>
Expansion<2 * N * M> operator*(const Expansion<N>& a, const Expansion<M>& b) {
  Expansion<2 * N * M> product;
  Expansion<2 * N * M> longer;
  for (std::size_t j = 0; j < b.size; ++j) {
    add(product, a * b.terms[j], longer);
    product = longer;
  }
  return product;
}

}  // namespace quarry
