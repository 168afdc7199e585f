// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Exact numbers: a double is the rational that it is, and no operation rounds. Only roots and printed numbers are
// rounded, to the side that their name says.
#ifndef TERN_VERIFY_EXACT_HPP
#define TERN_VERIFY_EXACT_HPP

#include <array>
#include <boost/multiprecision/gmp.hpp>
#include <cstddef>
#include <string>

namespace tern_verify {

using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;
using Integer = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;
/// A vector of exact numbers. The operators also take vectors of other numbers.
template <std::size_t N>
using Vector = std::array<Rational, N>;
/// A point or a direction in space.
using Point = Vector<3>;

template <typename T, std::size_t N>
std::array<T, N> operator+(const std::array<T, N>& a, const std::array<T, N>& b) {
  std::array<T, N> sum;
  for (std::size_t i = 0; i < N; ++i) sum[i] = a[i] + b[i];
  return sum;
}

template <typename T, std::size_t N>
std::array<T, N> operator-(const std::array<T, N>& a, const std::array<T, N>& b) {
  std::array<T, N> difference;
  for (std::size_t i = 0; i < N; ++i) difference[i] = a[i] - b[i];
  return difference;
}

template <typename T, std::size_t N>
std::array<T, N> operator*(const typename std::array<T, N>::value_type& s, const std::array<T, N>& a) {
  std::array<T, N> scaled;
  for (std::size_t i = 0; i < N; ++i) scaled[i] = s * a[i];
  return scaled;
}

template <typename T, std::size_t N>
T dot(const std::array<T, N>& a, const std::array<T, N>& b) {
  T sum = 0;
  for (std::size_t i = 0; i < N; ++i) sum = sum + a[i] * b[i];
  return sum;
}

/// 2^-52: a unit in the last place of 1.
Rational ulp();

/// The numerator over a power of ten: `decimal(3, 8)` is 3e-8.
Rational decimal(int numerator, unsigned negative_power);

/// The largest integer that is not above the number, and the smallest that is not below it.
Integer floor_of(const Rational& number);
Integer ceil_of(const Rational& number);

/// A root of a number >= 0, off by less than 2^-119, or not at all where it has few digits.
Rational root_below(const Rational& square);
Rational root_above(const Rational& square);

/// Twelve significant digits, rounded towards minus or plus infinity.
std::string text_below(const Rational& number);
std::string text_above(const Rational& number);

/// In doubles, to look for places that are then judged exactly.
using Guess = std::array<double, 3>;

inline double guess(const Rational& number) {
  return number.convert_to<double>();
}

inline Guess guess(const Point& p) {
  return {guess(p[0]), guess(p[1]), guess(p[2])};
}

inline double dot(const Guess& a, const Guess& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Guess cross(const Guess& a, const Guess& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace tern_verify

#endif
