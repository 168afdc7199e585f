// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "yaw/angle.hpp"

#include <cstdint>

#include "base/math.hpp"

namespace tern {
namespace {

/// A quarter turn as a sum. Its first part has 33 bits, so the product with a whole number of 20 bits is exact.
constexpr double kQuarterHigh = 1.57079632673412561417;
constexpr double kQuarterLow = 6.07710050650619224932e-11;
/// An angle beyond this has lost its meaning, and counts as 0.
constexpr double kLargestAngle = 1e6;

/// The nearest whole number; a tie goes away from zero.
std::int64_t nearest(double x) {
  return static_cast<std::int64_t>(x < 0.0 ? x - 0.5 : x + 0.5);
}

/// Taylor's series around 0, for |x| <= pi/4: the first term left out is below 1e-18.
double sine_near_zero(double x) {
  const double y = x * x;
  double sum = 1.0;
  for (int k = 17; k >= 3; k -= 2) sum = 1.0 - y / (k * (k - 1.0)) * sum;
  return x * sum;
}
double cosine_near_zero(double x) {
  const double y = x * x;
  double sum = 1.0;
  for (int k = 18; k >= 2; k -= 2) sum = 1.0 - y / (k * (k - 1.0)) * sum;
  return sum;
}

}  // namespace

Heading heading_of(double angle) noexcept {
  const double x = absolute(angle) <= kLargestAngle ? angle : 0.0;
  const std::int64_t quarters = nearest(x / (0.5 * kPi));
  const double turned = static_cast<double>(quarters);
  const double rest = (x - turned * kQuarterHigh) - turned * kQuarterLow;
  const double c = cosine_near_zero(rest);
  const double s = sine_near_zero(rest);
  switch (quarters & 3) {
    case 0:
      return {c, s};
    case 1:
      return {-s, c};
    case 2:
      return {-c, -s};
    default:
      return {s, -c};
  }
}

double angle_of(const Heading& heading) noexcept {
  const double x = absolute(heading.cosine);
  const double y = absolute(heading.sine);
  const double scale = larger(x, y);
  if (!(scale > 0.0)) return 0.0;
  const double c = heading.cosine / scale;
  const double s = heading.sine / scale;
  const double norm = square_root(c * c + s * s);
  const double ratio = smaller(x, y) / scale;
  // A guess within 0.004 of the arc tangent. Two corrections follow, each from the sine of the error. The first leaves
  // less than 1e-13, the second only rounding.
  double angle = ratio * (0.25 * kPi + 0.273 * (1.0 - ratio));
  if (y > x) angle = 0.5 * kPi - angle;
  if (heading.cosine < 0.0) angle = kPi - angle;
  if (heading.sine < 0.0) angle = -angle;
  for (int i = 0; i < 2; ++i) {
    const Heading guess = heading_of(angle);
    const double error = (s * guess.cosine - c * guess.sine) / norm;
    angle += error * (1.0 + error * error / 6.0);
  }
  return angle;
}

double whole_turns(double angle) noexcept {
  return absolute(angle) <= kLargestAngle ? static_cast<double>(nearest(angle / (2.0 * kPi))) : 0.0;
}

double wrapped(double angle) noexcept {
  const double x = absolute(angle) <= kLargestAngle ? angle : 0.0;
  const double turns = whole_turns(x);
  const double rest = (x - 4.0 * turns * kQuarterHigh) - 4.0 * turns * kQuarterLow;
  return rest <= -kPi ? rest + 2.0 * kPi : rest;
}

}  // namespace tern
