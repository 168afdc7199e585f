// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Numbers of twice a double's precision: the unevaluated sum of two doubles, after Dekker (1971) and Knuth. Used for
// results that must not depend on how far the caller's planes are from the origin, or how nearly parallel they are.
#ifndef TERN_BASE_DOUBLE_DOUBLE_HPP
#define TERN_BASE_DOUBLE_DOUBLE_HPP

#include "tern/vec3.hpp"

namespace tern {

/// The number high + low; low is at most half a unit in the last place of high. Sums and products are accurate to
/// 2^-102 of the greatest term. Magnitudes may be up to 1e150.
struct DoubleDouble {
  double high;
  double low;

  DoubleDouble() = default;
  DoubleDouble(double value) noexcept : high(value), low(0.0) {}
  DoubleDouble(double high_part, double low_part) noexcept : high(high_part), low(low_part) {}
};

/// a + b without rounding.
inline DoubleDouble exact_sum(double a, double b) noexcept {
  const double sum = a + b;
  const double of_b = sum - a;
  return {sum, (a - (sum - of_b)) + (b - of_b)};
}

/// a + b without rounding, for |a| >= |b|.
inline DoubleDouble exact_sum_sorted(double a, double b) noexcept {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// a as the sum of two numbers of 26 bits each.
inline DoubleDouble halves(double a) noexcept {
  const double shifted = 134217729.0 * a;  // 2^27 + 1
  const double high = shifted - (shifted - a);
  return {high, a - high};
}

/// a * b without rounding.
inline DoubleDouble exact_product(double a, double b) noexcept {
  const double product = a * b;
  const DoubleDouble p = halves(a);
  const DoubleDouble q = halves(b);
  return {product, ((p.high * q.high - product) + p.high * q.low + p.low * q.high) + p.low * q.low};
}

inline DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) noexcept {
  const DoubleDouble high = exact_sum(a.high, b.high);
  const DoubleDouble low = exact_sum(a.low, b.low);
  const DoubleDouble sum = exact_sum_sorted(high.high, high.low + low.high);
  return exact_sum_sorted(sum.high, sum.low + low.low);
}

inline DoubleDouble operator-(const DoubleDouble& a) noexcept {
  return {-a.high, -a.low};
}

inline DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) noexcept {
  return a + (-b);
}

inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) noexcept {
  const DoubleDouble product = exact_product(a.high, b.high);
  return exact_sum_sorted(product.high, product.low + (a.high * b.low + a.low * b.high));
}

inline DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) noexcept {
  const double first = a.high / b.high;
  const DoubleDouble left = a - b * DoubleDouble(first);
  const double second = left.high / b.high;
  const DoubleDouble rest = left - b * DoubleDouble(second);
  return exact_sum_sorted(first, second) + DoubleDouble(rest.high / b.high);
}

inline bool operator<(const DoubleDouble& a, const DoubleDouble& b) noexcept {
  return a.high < b.high || (!(b.high < a.high) && a.low < b.low);
}

/// offset - normal . point: how far within the half-space the point is, in units of the normal's length.
inline DoubleDouble depth_of(const DoubleDouble& offset, const Vec3& normal, const Vec3& point) noexcept {
  return ((offset - exact_product(normal.x, point.x)) - exact_product(normal.y, point.y)) -
         exact_product(normal.z, point.z);
}

}  // namespace tern

#endif
