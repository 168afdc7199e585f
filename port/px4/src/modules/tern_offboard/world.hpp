// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What is known before the flight: the map, from a file.
#pragma once

#include <tern/tern.hpp>

namespace tern_offboard {

constexpr int32_t kMostBlocks = tern::kMaxPriorBoxes < 64 ? tern::kMaxPriorBoxes : 64;

/// Metres, in east, north, up from the origin of the local frame. All of the boundary is free, but for the blocks.
struct World {
  tern::Box boundary{};             ///< the vehicle's centre stays inside
  double resolution = 0.0;          ///< edge of a voxel
  double radius = 0.0;              ///< of the body, and the error of its position
  double tracking_margin = 0.0;     ///< how far the controller strays from the plan
  double v_horizontal = 0.0;        ///< m/s, of plans; well below MPC_XY_VEL_MAX
  tern::Vec3 v_max = {50, 50, 50};  ///< m/s; PX4's parameters limit plans, too
  tern::Vec3 a_max = {50, 50, 50};  ///< m/s^2
  tern::Box blocks[kMostBlocks];
  int32_t block_count = 0;
};

/// Reads a scenario (docs/formats.md): boundary, resolution, radius, tracking_margin and v_horizontal, which must be
/// there, and block, keepout, v_max and a_max. Start, goal and what only shapes a plan are skipped; anything else is
/// refused. False: the log names the line and what is wrong with it, and `world` has unspecified content.
bool read_world(const char* path, World& world);

}  // namespace tern_offboard
