// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What C can pass and C++ never would: numbers that are no value of an enumeration. Each has an answer, and the
// sanitizers' build finds none of them undefined.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "support/world.hpp"
#include "tern/tern.h"

namespace {

using tern::Field;
using tern::Status;
using tern_test::World;

/// Writes a byte as C would: no value of the enumeration need have it.
template <typename Enumeration>
void set_byte(Enumeration& value, int byte) {
  static_assert(sizeof value == 1, "a byte in C");
  std::memset(&value, byte, 1);
}

World small_world() {
  World world({20, 20, 10}, 0.1, 0.1);
  world.from({0.55, 0.55, 0.55}).to({1.45, 1.45, 0.55});
  return world;
}

TEST(CInterface, SizesOfNothing) {
  for (const int what : {-1, 6, 7, 8, 99, std::numeric_limits<int>::max(), std::numeric_limits<int>::min()}) {
    EXPECT_EQ(tern_size_of(what), 0u) << what;
  }
}

TEST(CInterface, SizesOfEverything) {
  EXPECT_EQ(tern_size_of(TERN_SIZE_REQUEST), sizeof(tern_request));
  EXPECT_EQ(tern_size_of(TERN_SIZE_TRAJECTORY), sizeof(tern_trajectory));
  EXPECT_EQ(tern_size_of(TERN_SIZE_REPORT), sizeof(tern_report));
  EXPECT_EQ(tern_size_of(TERN_SIZE_GRID_SPEC), sizeof(tern_grid_spec));
  EXPECT_EQ(tern_size_of(TERN_SIZE_WORKSPACE), tern::kWorkspaceBytes);
  EXPECT_EQ(tern_size_of(TERN_SIZE_WORKSPACE_ALIGNMENT), tern::kWorkspaceAlignment);
}

TEST(CInterface, AGridThatWasNeverBoundIsNotInflated) {
  tern_grid grid;
  std::memset(static_cast<void*>(&grid), 0, sizeof grid);
  EXPECT_EQ(tern_grid_inflate(nullptr), static_cast<std::uint8_t>(Status::kInvalidArgument));
  EXPECT_EQ(tern_grid_inflate(&grid), static_cast<std::uint8_t>(Status::kInvalidArgument));
}

/// The storage of a grid that another one took over is no longer the first one's.
TEST(CInterface, AGridWhoseStorageAnotherOneTookIsNotInflated) {
  const tern_voxel dims{4, 4, 4};
  tern_grid_spec spec{};
  spec.cell = 0.5;
  spec.dims = dims;
  spec.boundary = {{0.0, 0.0, 0.0}, {2.0, 2.0, 2.0}};
  std::vector<std::uint64_t> words(tern_grid_words(dims));
  tern_grid grids[2];
  std::memset(static_cast<void*>(grids), 0, sizeof grids);
  for (tern_grid& grid : grids) ASSERT_EQ(tern_grid_bind(&grid, &spec, words.data(), words.size()), 0);
  EXPECT_EQ(tern_grid_inflate(&grids[1]), 0);
  EXPECT_EQ(tern_grid_inflate(&grids[0]), static_cast<std::uint8_t>(Status::kInvalidArgument));
}

TEST(CInterface, HeaderAndLibraryHaveOneConfiguration) {
  EXPECT_EQ(tern_header_hash(), tern::configuration_hash());
  EXPECT_EQ(tern_header_hash(), tern_configuration_hash());
}

TEST(CInterface, EveryByteHasNames) {
  for (int byte = 0; byte < 256; ++byte) {
    const auto value = static_cast<std::uint8_t>(byte);
    EXPECT_GT(std::strlen(tern_status_meaning(value)), 0u) << byte;
    EXPECT_GT(std::strlen(tern_stage_name(value)), 0u) << byte;
    EXPECT_GT(std::strlen(tern_field_name(value)), 0u) << byte;
    EXPECT_GT(std::strlen(tern_finding_name(value)), 0u) << byte;
  }
  EXPECT_STREQ(tern_status_name(200), "unknown");
  EXPECT_STREQ(tern_stage_name(200), "unknown");
  EXPECT_STREQ(tern_field_name(200), "unknown");
  EXPECT_STREQ(tern_finding_name(200), "unknown");
  EXPECT_STREQ(tern_stage_name(1), "search");
  EXPECT_STREQ(tern_stage_name(10), "stop_first");
  EXPECT_STREQ(tern_finding_name(2), "obstacle");
  EXPECT_STREQ(tern_field_name(static_cast<std::uint8_t>(Field::kSearch)), "search");
}

TEST(CInterface, EveryStatusHasItsConstant) {
  const struct {
    tern_status status;
    const char* name;
  } constants[] = {
      {TERN_OK, "ok"},
      {TERN_RUNNING, "running"},
      {TERN_NON_FINITE_INPUT, "non_finite_input"},
      {TERN_INVALID_ARGUMENT, "invalid_argument"},
      {TERN_LIMITS_INVALID, "limits_invalid"},
      {TERN_OUT_OF_MAP, "out_of_map"},
      {TERN_START_EXCEEDS_LIMITS, "start_exceeds_limits"},
      {TERN_GOAL_EXCEEDS_LIMITS, "goal_exceeds_limits"},
      {TERN_VIA_EXCEEDS_LIMITS, "via_exceeds_limits"},
      {TERN_FENCE_EMPTY, "fence_empty"},
      {TERN_POSE_INVALID, "pose_invalid"},
      {TERN_CAMERA_INVALID, "camera_invalid"},
      {TERN_RECORD_DAMAGED, "record_damaged"},
      {TERN_RECORD_VERSION, "record_version"},
      {TERN_CLOCK_BEHIND, "clock_behind"},
      {TERN_START_OCCUPIED, "start_occupied"},
      {TERN_GOAL_OCCUPIED, "goal_occupied"},
      {TERN_NO_PATH, "no_path"},
      {TERN_MAP_CHANGED, "map_changed"},
      {TERN_CORRIDOR_BLOCKED, "corridor_blocked"},
      {TERN_NO_TRAJECTORY, "no_trajectory"},
      {TERN_START_FENCED, "start_fenced"},
      {TERN_GOAL_FENCED, "goal_fenced"},
      {TERN_VIA_OCCUPIED, "via_occupied"},
      {TERN_VIA_FENCED, "via_fenced"},
      {TERN_START_TOO_NARROW, "start_too_narrow"},
      {TERN_GOAL_TOO_NARROW, "goal_too_narrow"},
      {TERN_VIA_TOO_NARROW, "via_too_narrow"},
      {TERN_START_IN_CONTACT, "start_in_contact"},
      {TERN_GOAL_COVERED, "goal_covered"},
      {TERN_NO_CLEAR_TIME, "no_clear_time"},
      {TERN_NODES_FULL, "nodes_full"},
      {TERN_OPEN_FULL, "open_full"},
      {TERN_JUMP_POINTS_FULL, "jump_points_full"},
      {TERN_SEGMENTS_FULL, "segments_full"},
      {TERN_PLANES_FULL, "planes_full"},
      {TERN_OBSTACLES_FULL, "obstacles_full"},
      {TERN_WORKING_SET_FULL, "working_set_full"},
      {TERN_ITERATION_LIMIT, "iteration_limit"},
      {TERN_FENCES_FULL, "fences_full"},
      {TERN_FENCE_PLANES_FULL, "fence_planes_full"},
      {TERN_WORLD_FULL, "world_full"},
      {TERN_VIAS_FULL, "vias_full"},
      {TERN_PIXELS_FULL, "pixels_full"},
      {TERN_PRIOR_FULL, "prior_full"},
      {TERN_RECORD_FULL, "record_full"},
      {TERN_TRACKS_FULL, "tracks_full"},
      {TERN_NEIGHBOURS_FULL, "neighbours_full"},
      {TERN_TRACK_PIECES_FULL, "track_pieces_full"},
      {TERN_SEPARATIONS_FULL, "separations_full"},
      {TERN_FLOOD_FULL, "flood_full"},
      {TERN_INFEASIBLE, "infeasible"},
      {TERN_NUMERICAL, "numerical"},
      {TERN_CHECK_FAILED, "check_failed"},
      {TERN_SELF_TEST_FAILED, "self_test_failed"},
      {TERN_BUDGET_SEARCH, "budget_search"},
      {TERN_BUDGET_SHORTCUT, "budget_shortcut"},
      {TERN_BUDGET_CORRIDOR, "budget_corridor"},
      {TERN_BUDGET_TRACKS, "budget_tracks"},
      {TERN_BUDGET_OPTIMISE, "budget_optimise"},
  };
  for (const auto& constant : constants) {
    EXPECT_STREQ(tern_status_name(static_cast<std::uint8_t>(constant.status)), constant.name);
  }
  std::size_t named = 0;
  for (int byte = 0; byte < 256; ++byte) {
    named += std::strcmp(tern_status_name(static_cast<std::uint8_t>(byte)), "unknown") != 0 ? 1 : 0;
  }
  EXPECT_EQ(named, sizeof constants / sizeof *constants);
}

TEST(CInterface, UnknownSearchIsRefused) {
  World world = small_world();
  for (int byte = 0; byte < 256; ++byte) {
    set_byte(world.request.search, byte);
    EXPECT_EQ(world.plan(), byte < 2 ? Status::kOk : Status::kInvalidArgument) << byte;
    EXPECT_EQ(world.report.field, byte < 2 ? Field::kNone : Field::kSearch) << byte;
    EXPECT_EQ(world.trajectory_untouched(), byte >= 2) << byte;
  }
}

TEST(CInterface, UnknownFenceKindIsRefused) {
  World world = small_world();
  tern::Halfspace planes[tern::kBoxPlanes];
  tern::box_planes({{0.0, 0.0, 0.0}, {2.0, 2.0, 1.0}}, planes);
  tern::Fence fence{planes, tern::kBoxPlanes, tern::FenceKind::kKeepIn};
  world.request.fences = &fence;
  world.request.fence_count = 1;
  EXPECT_EQ(world.plan(), Status::kOk);
  for (int byte = 2; byte < 256; ++byte) {
    set_byte(fence.kind, byte);
    EXPECT_EQ(world.plan(), Status::kInvalidArgument) << byte;
    EXPECT_EQ(world.report.field, Field::kFences) << byte;
    EXPECT_TRUE(world.trajectory_untouched()) << byte;
  }
}

}  // namespace
