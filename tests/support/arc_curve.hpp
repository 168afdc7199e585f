// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Curves that bounds by hulls find hard.
#ifndef TERN_TESTS_SUPPORT_ARC_CURVE_HPP
#define TERN_TESTS_SUPPORT_ARC_CURVE_HPP

#include "tern/vec3.hpp"

namespace tern_test {

constexpr int kSextic = 6;

/// Bernstein coefficient i of the sum of a[k] (u - 1/2)^k, k = 0 .. 6.
inline double sextic_coefficient(const double (&a)[kSextic + 1], int i) {
  // The polar form: elementary symmetric functions of i halves and 6 - i negative halves.
  constexpr double kBinomial[kSextic + 1] = {1.0, 6.0, 15.0, 20.0, 15.0, 6.0, 1.0};
  double symmetric[kSextic + 1] = {1.0};
  for (int j = 0; j < kSextic; ++j) {
    for (int k = j + 1; k > 0; --k) symmetric[k] += (j < i ? 0.5 : -0.5) * symmetric[k - 1];
  }
  double sum = 0.0;
  for (int k = 0; k <= kSextic; ++k) sum += a[k] * symmetric[k] / kBinomial[k];
  return sum;
}

/// Control point i of a level curve of degree 6 along the unit circle, `angle` radians of it. Its distance from the
/// circle is angle^8 / 2^8 / 5040 at most, from the series' first terms left out.
inline tern::Vec3 arc_point(double angle, int i) {
  const double square = angle * angle;
  const double cosine[] = {
      1.0, 0.0, -square / 2.0, 0.0, square * square / 24.0, 0.0, -square * square * square / 720.0};
  const double sine[] = {0.0, angle, 0.0, -angle * square / 6.0, 0.0, angle * square * square / 120.0, 0.0};
  return {sextic_coefficient(cosine, i), sextic_coefficient(sine, i), 0.0};
}

/// Control point i of 1 - (u - 1/3)^2 along x, in degree 6: its peak is at no end of any half of a half.
inline tern::Vec3 hill_point(int i) {
  const double hill[] = {1.0 - 1.0 / 36.0, -1.0 / 3.0, -1.0, 0.0, 0.0, 0.0, 0.0};
  return {sextic_coefficient(hill, i), 0.0, 0.0};
}

}  // namespace tern_test

#endif
