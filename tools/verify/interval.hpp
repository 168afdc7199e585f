// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Numbers between two doubles: fast, and never wrong. Each result is widened by more than its rounding, so it holds
// what exact arithmetic on any members of the operands gives.
#ifndef TERN_VERIFY_INTERVAL_HPP
#define TERN_VERIFY_INTERVAL_HPP

#include <algorithm>
#include <cmath>
#include <limits>

#include "verify/exact.hpp"

namespace tern_verify {

class Interval {
 public:
  Interval(double number = 0.0) : low_(number), high_(number) {}
  /// GMP cuts off what a double does not hold, which is less than a unit in its last place.
  explicit Interval(const Rational& number) : Interval(0.0) {
    const double cut = mpq_get_d(number.backend().data());
    if (number != 0) *this = around(cut, cut, kLeast);
  }

  /// From one number to another one; all numbers unless low <= high, as of infinity less infinity.
  static Interval between(double low, double high) {
    Interval interval;
    const bool is_known = low <= high;
    interval.low_ = is_known ? low : -kInfinity;
    interval.high_ = is_known ? high : kInfinity;
    return interval;
  }

  double low() const { return low_; }
  double high() const { return high_; }

  friend Interval operator+(const Interval& a, const Interval& b) { return around(a.low_ + b.low_, a.high_ + b.high_); }
  friend Interval operator-(const Interval& a, const Interval& b) { return around(a.low_ - b.high_, a.high_ - b.low_); }
  friend Interval operator*(const Interval& a, const Interval& b) {
    if (a.is_zero() || b.is_zero()) return 0.0;
    return hull_of(a.low_ * b.low_, a.low_ * b.high_, a.high_ * b.low_, a.high_ * b.high_);
  }
  /// Nothing is known of a quotient whose divisor may be 0 or less.
  friend Interval operator/(const Interval& a, const Interval& b) {
    if (!(b.low_ > 0.0)) return between(-kInfinity, kInfinity);
    return hull_of(a.low_ / b.low_, a.low_ / b.high_, a.high_ / b.low_, a.high_ / b.high_);
  }
  friend Interval abs(const Interval& a) {
    if (a.low_ >= 0.0) return a;
    return between(std::max(0.0, -a.high_), std::max(-a.low_, a.high_));
  }
  /// The number where it is positive, else 0.
  friend Interval positive_part(const Interval& a) { return between(std::max(0.0, a.low_), std::max(0.0, a.high_)); }
  /// sqrt rounds correctly. What is below 0 comes from widening: no member of interest is.
  friend Interval root(const Interval& a) {
    return around(std::sqrt(std::max(0.0, a.low_)), std::sqrt(std::max(0.0, a.high_)));
  }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  /// The smallest normal number: a product or a quotient below it may have lost more than a unit in its last place.
  /// Sums and roots lose nothing there.
  static constexpr double kLeast = std::numeric_limits<double>::min();

  bool is_zero() const { return low_ == 0.0 && high_ == 0.0; }

  /// Where one of them is infinite, another may be 0 times infinity, of which nothing is known.
  static Interval hull_of(double a, double b, double c, double d) {
    if (!(std::isfinite(a) && std::isfinite(b) && std::isfinite(c) && std::isfinite(d))) {
      return between(-kInfinity, kInfinity);
    }
    return around(std::min(std::min(a, b), std::min(c, d)), std::max(std::max(a, b), std::max(c, d)), kLeast);
  }

  /// A rounded or cut-off x is less than a unit in its last place away from what it stands for, or less than `least`.
  /// |x| epsilon is such a unit or more, and x less a unit is a double, so that the subtraction does not round past it.
  static Interval around(double low, double high, double least = 0.0) {
    constexpr double kUnit = std::numeric_limits<double>::epsilon();
    return between(low - (std::abs(low) * kUnit + least), high + (std::abs(high) * kUnit + least));
  }

  double low_, high_;
};

inline double guess(const Interval& number) {
  return 0.5 * (number.low() + number.high());
}

// The same for both kinds of numbers: bounds on their value, and on roots.
inline const Rational& below(const Rational& number) {
  return number;
}
inline const Rational& above(const Rational& number) {
  return number;
}
inline double below(const Interval& number) {
  return number.low();
}
inline double above(const Interval& number) {
  return number.high();
}
inline bool is_finite(const Rational&) {
  return true;
}
inline bool is_finite(double bound) {
  return std::isfinite(bound);
}
inline Interval root_below(const Interval& square) {
  return root(square);
}
inline Interval root_above(const Interval& square) {
  return root(square);
}
inline Rational positive_part(const Rational& number) {
  return number > 0 ? number : Rational(0);
}

}  // namespace tern_verify

#endif
