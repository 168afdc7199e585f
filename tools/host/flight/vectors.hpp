// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lengths and sums, for what watches a flight, which shares no arithmetic with the core.
#ifndef TERN_HOST_FLIGHT_VECTORS_HPP
#define TERN_HOST_FLIGHT_VECTORS_HPP

#include <cmath>

#include "tern/trajectory.hpp"

namespace tern_host {

inline double length(const tern::Vec3& v) {
  return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

/// `from` + k v
inline tern::Vec3 along(const tern::Vec3& from, double k, const tern::Vec3& v) {
  return {from.x + k * v.x, from.y + k * v.y, from.z + k * v.z};
}

inline double distance_between(const tern::Vec3& a, const tern::Vec3& b) {
  return length(along(a, -1.0, b));
}

inline bool rests(const tern::Sample& s) {
  return !(length(s.velocity) > 0.0 || length(s.acceleration) > 0.0 || length(s.jerk) > 0.0);
}

}  // namespace tern_host

#endif
