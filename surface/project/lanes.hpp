// Several numbers at once, by what every x86-64 processor has. Each lane rounds as a number alone does, so
// that code written once for a number and for lanes gives the same bits either way.
#pragma once

namespace quarry {

using Float4 = float __attribute__((vector_size(16)));
using Double2 = double __attribute__((vector_size(16)));

// A vector of space of such numbers (or of double).
template <class Real>
struct LaneVec3 {
  Real x, y, z;

  friend LaneVec3 operator+(const LaneVec3& a, const LaneVec3& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend LaneVec3 operator-(const LaneVec3& a, const LaneVec3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend LaneVec3 operator*(const Real& s, const LaneVec3& a) { return {s * a.x, s * a.y, s * a.z}; }
};

template <class Real>
Real dot(const LaneVec3<Real>& a, const LaneVec3<Real>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Real>
LaneVec3<Real> cross(const LaneVec3<Real>& a, const LaneVec3<Real>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// a where the condition holds, lane by lane, and b elsewhere.
template <class Condition, class Real>
LaneVec3<Real> choose(const Condition& condition, const LaneVec3<Real>& a, const LaneVec3<Real>& b) {
  return {condition ? a.x : b.x, condition ? a.y : b.y, condition ? a.z : b.z};
}

}  // namespace quarry
