// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What autopilots say in north-east-down, in Tern's frames: the world east, north, up, the body ahead, left, up.
#ifndef TERN_COMPANION_NED_HPP
#define TERN_COMPANION_NED_HPP

#include <array>

#include "tern_stacks/stacks.hpp"

namespace tern_companion {

inline tern::Vec3 enu_from_ned(const std::array<float, 3>& ned) {
  return tern::ned_from_enu({ned[0], ned[1], ned[2]});  // the same both ways
}

/// An attitude from forward-right-down to north-east-down, as one from ahead-left-up to east-north-up. (w, x, y, z).
inline void enu_from_ned(const std::array<float, 4>& ned, double (&enu)[4]) {
  const double q[4] = {ned[0], ned[1], ned[2], ned[3]};
  tern::attitude_ned(q, enu);  // its own inverse
}

}  // namespace tern_companion

#endif
