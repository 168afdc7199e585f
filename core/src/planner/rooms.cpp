// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planner/rooms.hpp"

#include "tern/via.hpp"

namespace tern {

Progress rooms_advance(const Problem& problem, const Path& path, CorridorStage& stage, Rooms& rooms, Corridor& corridor,
                       Work& work) noexcept {
  const Progress progress = corridor_advance(stage, world_of(problem), path, work, corridor);
  raise(rooms.planes_high, stage.planes_high);
  raise(rooms.local_boxes_high, stage.boxes_high);
  if (progress == Progress::kMore) return progress;
  rooms.status = stage.status;
  rooms.via = stage.passed < problem.via_count ? stage.passed : kNoVia;
  return progress;
}

}  // namespace tern
