// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/number.hpp"

#include <locale.h>
#include <stdlib.h>

#include <cmath>
#include <cstddef>
#include <iomanip>
#include <locale>
#include <sstream>

namespace tern_host {
namespace {

// std::from_chars for doubles is missing in GCC 9 and 10, strtod follows the process' locale: the C locale by name.
locale_t c_locale() {
  static const locale_t locale = newlocale(LC_ALL_MASK, "C", nullptr);
  return locale;
}

std::size_t skip_digits(const std::string& text, std::size_t at) {
  while (at < text.size() && text[at] >= '0' && text[at] <= '9') ++at;
  return at;
}

std::size_t skip_sign(const std::string& text, std::size_t at) {
  return at < text.size() && (text[at] == '+' || text[at] == '-') ? at + 1 : at;
}

/// strtod alone would take hexadecimal, "inf", "nan(...)" and leading blanks.
bool is_decimal(const std::string& text) {
  const std::size_t begin = skip_sign(text, 0);
  std::size_t end = skip_digits(text, begin);
  std::size_t digits = end - begin;
  if (end < text.size() && text[end] == '.') {
    const std::size_t fraction = end + 1;
    end = skip_digits(text, fraction);
    digits += end - fraction;
  }
  if (digits == 0) return false;
  if (end < text.size() && (text[end] == 'e' || text[end] == 'E')) {
    const std::size_t exponent = skip_sign(text, end + 1);
    end = skip_digits(text, exponent);
    if (end == exponent) return false;
  }
  return end == text.size();
}

}  // namespace

bool names_a_non_finite(const std::string& text) {
  std::string word = text.substr(skip_sign(text, 0));
  for (char& c : word) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return word == "nan" || word == "inf" || word == "infinity";
}

NumberError parse_number(const std::string& text, double& value) {
  if (names_a_non_finite(text)) return NumberError::kNotFinite;
  if (!is_decimal(text)) return NumberError::kMalformed;
  const double parsed = strtod_l(text.c_str(), nullptr, c_locale());
  if (!std::isfinite(parsed)) return NumberError::kNotFinite;
  value = parsed;
  return NumberError::kNone;
}

std::string fixed(double value, int decimals) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << std::fixed << std::setprecision(decimals) << value;
  std::string text = out.str();
  if (text[0] == '-' && text.find_first_not_of("-0.") == std::string::npos) text.erase(0, 1);
  return text;
}

std::string brief(double value) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << std::setprecision(9) << value;
  return out.str();
}

std::string exact(double value) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << std::setprecision(17) << value;
  return out.str();
}

std::string shortest(double value) {
  // A round number is written out: 1000, not 1e+03.
  constexpr double kWrittenOut = 1e9;
  const bool is_round = std::fabs(value) < kWrittenOut && value == std::trunc(value);
  if (is_round) return brief(value);
  for (int digits = 1; digits < 17; ++digits) {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out << std::setprecision(digits) << value;
    double read = 0.0;
    if (parse_number(out.str(), read) == NumberError::kNone && read == value) return out.str();
  }
  return exact(value);
}

}  // namespace tern_host
