// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_NUMBER_HPP
#define TERN_HOST_NUMBER_HPP

#include <string>

namespace tern_host {

enum class NumberError {
  kNone,
  kMalformed,  ///< not a decimal number: empty, hexadecimal, trailing characters, ...
  kNotFinite,  ///< NaN, infinity, or beyond the range of a double
};

/// Reads all of `text` as one decimal number, whatever the process' locale: an optional sign, digits with an optional
/// point, an optional exponent. A value too small for a double becomes a denormal or zero.
NumberError parse_number(const std::string& text, double& value);

/// True for "nan", "inf" and "infinity", in any case and with any sign.
bool names_a_non_finite(const std::string& text);

/// `value` with a fixed number of decimals and a point, whatever the locale; "-0.00" is written "0.00".
std::string fixed(double value, int decimals);

/// `value` with at most nine significant digits, for messages.
std::string brief(double value);

/// `value` with 17 significant digits: reads back to the same bits.
std::string exact(double value);

/// `value` with as few significant digits as read back to the same bits: 0.1, where exact() writes 0.10000000000000001;
/// 1000, not 1e+03.
std::string shortest(double value);

}  // namespace tern_host

#endif
