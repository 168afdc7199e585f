// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Geometry of the checker: long double throughout, none of it the core's.
#ifndef TERN_TESTS_ATTACK_EXACT_HPP
#define TERN_TESTS_ATTACK_EXACT_HPP

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "tern/tern.hpp"

namespace tern_attack {

using Real = long double;

/// Spacing of doubles at 1.
constexpr Real kUlp = 2.220446049250313e-16L;

struct Point {
  Real c[3];
  Real& operator[](int a) { return c[a]; }
  Real operator[](int a) const { return c[a]; }
};

inline double axis(const tern::Vec3& v, int a) {
  return a == 0 ? v.x : (a == 1 ? v.y : v.z);
}
inline double& axis(tern::Vec3& v, int a) {
  return a == 0 ? v.x : (a == 1 ? v.y : v.z);
}
inline int axis(const tern::Voxel& v, int a) {
  return a == 0 ? v.x : (a == 1 ? v.y : v.z);
}
inline std::int32_t& axis(tern::Voxel& v, int a) {
  return a == 0 ? v.x : (a == 1 ? v.y : v.z);
}

inline Point point(const tern::Vec3& v) {
  return {{v.x, v.y, v.z}};
}
inline Point operator+(const Point& a, const Point& b) {
  return {{a[0] + b[0], a[1] + b[1], a[2] + b[2]}};
}
inline Point operator-(const Point& a, const Point& b) {
  return {{a[0] - b[0], a[1] - b[1], a[2] - b[2]}};
}
inline Point operator*(Real s, const Point& a) {
  return {{s * a[0], s * a[1], s * a[2]}};
}
inline Real dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Point cross(const Point& a, const Point& b) {
  return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}
inline Real length(const Point& a) {
  return std::sqrt(dot(a, a));
}
inline Real largest(const Point& a) {
  return std::max({std::fabs(a[0]), std::fabs(a[1]), std::fabs(a[2])});
}

/// What halving a curve, or a time, comes to.
enum class Proof {
  kProven,
  kBroken,    ///< some point breaks the rule
  kUnproven,  ///< neither after many halvings
};

}  // namespace tern_attack

#endif
