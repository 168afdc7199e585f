// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The only arithmetic of the core: + - * / sqrt, in a fixed order. base/linear.hpp has that of matrices.
#ifndef TERN_BASE_MATH_HPP
#define TERN_BASE_MATH_HPP

#include "tern/vec3.hpp"

namespace tern {

// One line an operation.
// clang-format off
constexpr Vec3 kZero{0.0, 0.0, 0.0};
/// Half the diagonal of a cube, in edges.
constexpr double kHalfDiagonal = 0.8660254037844386;

inline double dot(const Vec3& a, const Vec3& b) { return (a.x * b.x + a.y * b.y) + a.z * b.z; }

inline Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3 operator*(double s, const Vec3& a) { return {s * a.x, s * a.y, s * a.z}; }

inline double square_root(double x) { return __builtin_sqrt(x); }
inline double length(const Vec3& a) { return square_root(dot(a, a)); }
inline double distance(const Vec3& a, const Vec3& b) { return length(a - b); }
inline double horizontal_length(const Vec3& a) { return square_root(a.x * a.x + a.y * a.y); }

/// Uses the compiler's builtin: one instruction on all platforms. A comparison would need care for the sign of -0.
inline double absolute(double x) { return __builtin_fabs(x); }
inline double smaller(double a, double b) { return b < a ? b : a; }
inline double larger(double a, double b) { return a < b ? b : a; }
inline double clamp(double x, double lo, double hi) { return x < lo ? lo : (hi < x ? hi : x); }
// clang-format on

inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Some unit vector at right angles to `unit`: the cross product with the axis of its smallest component, normalised.
inline Vec3 perpendicular(const Vec3& unit) {
  const double x = absolute(unit.x);
  const double y = absolute(unit.y);
  const double z = absolute(unit.z);
  Vec3 side{0.0, 0.0, 1.0};
  if (x <= y && x <= z) {
    side = {1.0, 0.0, 0.0};
  } else if (y <= z) {
    side = {0.0, 1.0, 0.0};
  }
  const Vec3 v = cross(unit, side);
  return (1.0 / length(v)) * v;
}

/// Component by index, so that loops over axes need no branches at the call site.
inline double axis(const Vec3& v, int a) {
  return a == 0 ? v.x : (a == 1 ? v.y : v.z);
}
inline double& axis(Vec3& v, int a) {
  return a == 0 ? v.x : (a == 1 ? v.y : v.z);
}

/// The cube root of x >= 0, rounded up: its cube is not below x.
inline double cube_root(double x) {
  if (!(x > 0.0)) return 0.0;
  const double fourth = square_root(square_root(x));
  double root = fourth * square_root(square_root(fourth));  // x^(5/16)
  constexpr int kSteps = 12;                                // Newton's: enough for 1e-30 to 1e30
  for (int i = 0; i < kSteps; ++i) root = (2.0 * root + x / (root * root)) / 3.0;
  return root * (1.0 + 1e-15);
}

/// x^7: the snap cost of a trajectory stretched in time by x falls by this factor.
inline double seventh_power(double x) {
  const double cube = x * x * x;
  return cube * cube * x;
}

/// Equal numbers; the signs of zeros do not count, and NaN equals nothing.
inline bool same(double a, double b) {
  return a <= b && b <= a;
}
inline bool same(const Vec3& a, const Vec3& b) {
  return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z);
}

/// Needs no libm. Relies on a build without -ffast-math, which would optimise it away.
inline bool finite(double x) {
  return x - x <= 0.0;
}
inline bool finite(const Vec3& v) {
  return finite(v.x) && finite(v.y) && finite(v.z);
}

}  // namespace tern

#endif
