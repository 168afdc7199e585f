// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Angles and directions, from + - * / sqrt alone: the same bits on every machine, which no C library promises.
#ifndef TERN_YAW_ANGLE_HPP
#define TERN_YAW_ANGLE_HPP

#include "tern/yaw.hpp"

namespace tern {

constexpr double kPi = 3.14159265358979323846;

/// Cosine and sine of an angle, |angle| <= 1e6 rad; off by 1e-15 + 1e-16 |angle| at most.
Heading heading_of(double angle) noexcept;

/// The angle of a direction, -pi .. pi; off by 1e-15 at most. 0 if cosine and sine are both zero.
double angle_of(const Heading& heading) noexcept;

/// The whole number of turns that is nearest to the angle, |angle| <= 1e6 rad; 0 for larger ones.
double whole_turns(double angle) noexcept;

/// The angle less whole turns, in (-pi, pi] but for rounding.
double wrapped(double angle) noexcept;

}  // namespace tern

#endif
