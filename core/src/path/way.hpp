// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The path of a plan with vias: one path after the other, each from a via to the next.
#ifndef TERN_PATH_WAY_HPP
#define TERN_PATH_WAY_HPP

#include "tern/path.hpp"
#include "tern/status.hpp"

namespace tern {

/// Empties the path.
void clear_way(Path& way) noexcept;

/// Appends a path that begins where the way ends. The waypoint at which they meet is kept only once. kOk, or
/// kJumpPointsFull or kSegmentsFull with the way unchanged.
Status append_to_way(const Path& part, Path& way) noexcept;

}  // namespace tern

#endif
