// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Free space for a plan: the corridor along the path.
#ifndef TERN_PLANNER_ROOMS_HPP
#define TERN_PLANNER_ROOMS_HPP

#include <cstdint>

#include "base/progress.hpp"
#include "base/work.hpp"
#include "corridor/corridor_stage.hpp"
#include "planner/problem.hpp"
#include "tern/corridor.hpp"
#include "tern/path.hpp"
#include "tern/status.hpp"

namespace tern {

struct Rooms {
  Status status;     ///< why there is no corridor; else kOk
  std::int32_t via;  ///< the next via after the place where there was no room; kNoVia: the goal comes next
  // Figures for the report.
  std::int32_t planes_high;
  std::int32_t local_boxes_high;
};

/// Builds the corridor that corridor_begin() has begun.
Progress rooms_advance(const Problem& problem, const Path& path, CorridorStage& stage, Rooms& rooms, Corridor& corridor,
                       Work& work) noexcept;

}  // namespace tern

#endif
