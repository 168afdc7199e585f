// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verify/exact.hpp"

#include <algorithm>

namespace tern_verify {
namespace {

constexpr unsigned kRootBits = 120;
constexpr int kDigits = 12;
/// Numbers that need more leading zeros than this are printed with an exponent.
constexpr int kLeastPlain = -4;
constexpr int kMostPlain = 8;

Rational power_of_ten(int exponent) {
  const Rational power = Rational(boost::multiprecision::pow(Integer(10), static_cast<unsigned>(std::abs(exponent))));
  return exponent < 0 ? Rational(1 / power) : power;
}

/// Where the first digit stands: 10^e <= size < 10^(e + 1).
int exponent_of(const Rational& size) {
  int e = 0;
  while (size >= power_of_ten(e + 1)) ++e;
  while (size < power_of_ten(e)) --e;
  return e;
}

std::string without_trailing_zeros(std::string digits, std::size_t least) {
  while (digits.size() > least && digits.back() == '0') digits.pop_back();
  return digits;
}

/// `digits` is a whole number whose first digit counts for 10^e.
std::string written(const std::string& digits, int e) {
  if (e < kLeastPlain || e > kMostPlain) {
    const std::string fraction = without_trailing_zeros(digits.substr(1), 0);
    return digits.substr(0, 1) + (fraction.empty() ? "" : "." + fraction) + "e" + std::to_string(e);
  }
  if (e < 0) return "0." + std::string(static_cast<std::size_t>(-e - 1), '0') + without_trailing_zeros(digits, 1);
  const auto whole = static_cast<std::size_t>(e + 1);
  const std::string fraction = without_trailing_zeros(digits.substr(whole), 0);
  return digits.substr(0, whole) + (fraction.empty() ? "" : "." + fraction);
}

/// A positive number's digits, the last one rounded up or down.
std::string positive_text(const Rational& size, bool up) {
  int e = exponent_of(size);
  const Rational scaled = size * power_of_ten(kDigits - 1 - e);
  std::string digits = (up ? ceil_of(scaled) : floor_of(scaled)).str();
  // 9.99 rounds up to 10.0.
  if (digits.size() > static_cast<std::size_t>(kDigits)) ++e;
  digits.resize(kDigits);
  return written(digits, e);
}

std::string text(const Rational& number, bool up) {
  if (number == 0) return "0";
  return number > 0 ? positive_text(number, up) : "-" + positive_text(-number, !up);
}

Rational scaled(const Rational& square) {
  return square * Rational(Integer(1) << (2 * kRootBits));
}

Rational unscaled(const Integer& root) {
  return Rational(root) / Rational(Integer(1) << kRootBits);
}

}  // namespace

Rational ulp() {
  return Rational(1) / Rational(Integer(1) << 52);
}

Rational decimal(int numerator, unsigned negative_power) {
  return numerator * power_of_ten(-static_cast<int>(negative_power));
}

Integer floor_of(const Rational& number) {
  const Integer over = boost::multiprecision::numerator(number);
  const Integer under = boost::multiprecision::denominator(number);
  const Integer towards_zero = over / under;
  return towards_zero * under > over ? Integer(towards_zero - 1) : towards_zero;
}

Integer ceil_of(const Rational& number) {
  return -floor_of(-number);
}

Rational root_below(const Rational& square) {
  return unscaled(boost::multiprecision::sqrt(floor_of(scaled(square))));
}

Rational root_above(const Rational& square) {
  const Integer root = boost::multiprecision::sqrt(floor_of(scaled(square)));
  return unscaled(Rational(root * root) == scaled(square) ? root : Integer(root + 1));
}

std::string text_below(const Rational& number) {
  return text(number, false);
}

std::string text_above(const Rational& number) {
  return text(number, true);
}

}  // namespace tern_verify
