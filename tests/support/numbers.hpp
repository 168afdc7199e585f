// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Numbers that are none.
#ifndef TERN_TESTS_SUPPORT_NUMBERS_HPP
#define TERN_TESTS_SUPPORT_NUMBERS_HPP

#include <limits>

namespace tern_test {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace tern_test

#endif
