// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_BASE_TOO_NARROW_HPP
#define TERN_BASE_TOO_NARROW_HPP

#include "tern/status.hpp"

namespace tern {

/// True if a start, goal or via has room, but no voxel near it is free.
inline bool is_too_narrow(Status status) {
  return status == Status::kStartTooNarrow || status == Status::kGoalTooNarrow || status == Status::kViaTooNarrow;
}

/// True if no voxel near the goal is free, whether the goal has room or not.
inline bool lacks_goal_voxel(Status status) {
  return status == Status::kGoalOccupied || status == Status::kGoalTooNarrow;
}

/// True if no voxel near a via is free, whether the via has room or not.
inline bool lacks_via_voxel(Status status) {
  return status == Status::kViaOccupied || status == Status::kViaTooNarrow;
}

}  // namespace tern

#endif
