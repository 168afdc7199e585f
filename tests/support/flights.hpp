// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the tests of whole flights share.
#ifndef TERN_TESTS_SUPPORT_FLIGHTS_HPP
#define TERN_TESTS_SUPPORT_FLIGHTS_HPP

#include <cmath>
#include <cstdio>
#include <string>

#include "support/flown.hpp"

namespace tern_test {

inline FlightSettings fast() {
  FlightSettings settings;
  settings.v = 5.0;
  settings.a = 8.0;
  return settings;
}

inline double size(const tern::Vec3& v) {
  return std::hypot(v.x, std::hypot(v.y, v.z));
}

/// Where a flight is and why, for messages.
inline std::string story(const Flown& flown) {
  char text[200];
  std::snprintf(text, sizeof text, "t %.2f at (%.2f %.2f %.2f), reason %d, mode %d, asked %u committed %u failed %u",
                1e-9 * static_cast<double>(flown.time), flown.position().x, flown.position().y, flown.position().z,
                static_cast<int>(flown.report.reason), static_cast<int>(flown.report.mode), flown.report.asked,
                flown.report.committed, flown.report.failed);
  return text;
}

}  // namespace tern_test

#endif
