/* Copyright (c) 2026, the Tern authors
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * crazyflie_app_test PLAN: runs port/crazyflie's app over a stand-in for the firmware, and compares what it does with
 * the plan's file. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "app.h"
#include "crtp_commander_high_level.h"
#include "task.h"

#define REQUIRE(condition)                                   \
  do {                                                       \
    if (!(condition)) {                                      \
      printf("%s:%d: %s\n", __FILE__, __LINE__, #condition); \
      return 1;                                              \
    }                                                        \
  } while (0)

static uint8_t memory[4096];
static uint32_t written, ticks, ticks_at_start, ticks_at_landing;
static float go_to[4], takeoff_height;
static int defined, pieces, started, relative_starts, landed;

void vTaskDelay(uint32_t delay) {
  ticks += delay;
}
int crtpCommanderHighLevelTakeoff(const float absoluteHeight_m, const float duration_s) {
  takeoff_height = absoluteHeight_m;
  return duration_s > 0.0f ? 0 : 1;
}
int crtpCommanderHighLevelLand(const float absoluteHeight_m, const float duration_s) {
  ticks_at_landing = ticks;
  landed = absoluteHeight_m <= 0.0f && duration_s > 0.0f;
  return 0;
}
int crtpCommanderHighLevelGoTo(const float x, const float y, const float z, const float yaw, const float duration_s,
                               const bool relative) {
  const float to[4] = {x, y, z, yaw};
  memcpy(go_to, to, sizeof go_to);
  relative_starts += relative;
  return duration_s > 0.0f ? 0 : 1;
}
int crtpCommanderHighLevelStartTrajectory(const uint8_t trajectoryId, const float timeScale, const bool relative,
                                          const bool reversed) {
  started = trajectoryId == defined && timeScale == 1.0f && !reversed;
  relative_starts += relative;
  ticks_at_start = ticks;
  return 0;
}
int crtpCommanderHighLevelDefineTrajectory(const uint8_t trajectoryId, const crtpCommanderTrajectoryType_t type,
                                           const uint32_t offset, const uint8_t nPieces) {
  defined = type == CRTP_CHL_TRAJECTORY_TYPE_POLY4D && offset == 0 ? trajectoryId : -1;
  pieces = nPieces;
  return 0;
}
bool crtpCommanderHighLevelWriteTrajectory(const uint32_t offset, const uint32_t length, const uint8_t* data) {
  if (offset + length > sizeof memory) return false;
  memcpy(memory + offset, data, length);
  written = length;
  return true;
}

int main(int argc, char** argv) {
  uint8_t plan[8192];
  float start[4], duration = 0.0f;
  FILE* file = argc == 2 ? fopen(argv[1], "rb") : NULL;
  REQUIRE(file != NULL);
  const size_t bytes = fread(plan, 1, sizeof plan, file);
  fclose(file);
  REQUIRE(bytes > 0 && bytes % 132 == 0);

  appMain();
  REQUIRE(written == bytes && memcmp(memory, plan, bytes) == 0);
  REQUIRE((size_t)pieces == bytes / 132 && defined == 1 && started && landed && relative_starts == 0);
  for (int axis = 0; axis < 4; ++axis) memcpy(&start[axis], plan + 32 * axis, sizeof start[axis]);
  REQUIRE(memcmp(go_to, start, sizeof start) == 0 && takeoff_height == start[2]);
  for (size_t at = 128; at < bytes; at += 132) {
    float piece;
    memcpy(&piece, plan + at, sizeof piece);
    duration += piece;
  }
  const float flown = (float)(ticks_at_landing - ticks_at_start) / 1000.0f;
  REQUIRE(flown > duration && flown < duration + 1.1f);
  printf("%d pieces, %.2f s\n", pieces, (double)duration);
  return 0;
}
