// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What planning a trajectory of 16 segments takes. Only sizes are looked at here, so that this file may set capacities
// of its own.
#undef TERN_MAX_SEGMENTS
#undef TERN_MAX_ACTIVE
#undef TERN_MAX_PLANES
#undef TERN_MAX_SEPARATIONS
#undef TERN_MAX_TRACKS
#define TERN_MAX_SEGMENTS 16
#define TERN_MAX_ACTIVE 96
#define TERN_MAX_PLANES 24
#define TERN_MAX_SEPARATIONS 1
#define TERN_MAX_TRACKS 64

#include <gtest/gtest.h>

#include "trajectory/trajectory_stage.hpp"

namespace {

constexpr std::size_t kKilobyte = 1024;
constexpr std::size_t kOwn =
    sizeof(tern::TrajectoryStage) - sizeof(tern::QpSolver) - sizeof(tern::QpProblem) - sizeof(tern::QpSolution);

static_assert(kOwn <= 34 * kKilobyte,
              "durations and their curvature, control points, the best plan, the fallback, vias, things");

TEST(TrajectoryMemory, ASegmentAddsLittleToTheSolvers) {
  EXPECT_LE(sizeof(tern::QpProblem), 9 * kKilobyte * tern::kMaxSegments);
}

}  // namespace
