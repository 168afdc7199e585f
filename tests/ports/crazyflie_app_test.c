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
#include "log.h"
#include "supervisor.h"
#include "task.h"

#define REQUIRE(condition)                                   \
  do {                                                       \
    if (!(condition)) {                                      \
      printf("%s:%d: %s\n", __FILE__, __LINE__, #condition); \
      return 1;                                              \
    }                                                        \
  } while (0)

enum { START_AT = 5000, NEVER = 1 << 30 };

/* The app's parameter tern.start. */
uint8_t* parameter_of_tern(void);

/* What the app meets, and what it did. Ticks are milliseconds. */
static struct {
  float position[3], strays; /* the estimate on the ground, and how far from the target every flight ends */
  bool arms, blocked;
  uint32_t stop_at, crash_at;

  uint8_t memory[4096];
  uint32_t written, ticks, ticks_at_takeoff, ticks_at_start, ticks_at_landing;
  float go_to[4], takeoff_height;
  int defined, pieces, arming, takeoffs, starts, relative_starts, landings;
  bool armed;
} world;

void vTaskDelay(uint32_t delay) {
  world.ticks += delay;
  *parameter_of_tern() = world.ticks >= START_AT && world.ticks < world.stop_at;
}
logVarId_t logGetVarId(const char* group, const char* name) {
  return strcmp(group, "stateEstimate") == 0 ? (logVarId_t)(name[0] - 'x') : 9;
}
float logGetFloat(logVarId_t varid) {
  return varid < 3 ? world.position[varid] : NAN;
}
bool supervisorRequestArming(const bool doArm) {
  ++world.arming;
  world.armed = doArm && world.arms;
  return world.armed;
}
bool supervisorIsArmed(void) {
  return world.armed;
}
bool supervisorCanFly(void) {
  return world.armed && world.ticks < world.crash_at;
}
int crtpCommanderHighLevelTakeoff(const float absoluteHeight_m, const float duration_s) {
  ++world.takeoffs;
  world.ticks_at_takeoff = world.ticks;
  world.takeoff_height = absoluteHeight_m;
  return duration_s > 0.0f && !world.blocked ? 0 : 1;
}
int crtpCommanderHighLevelLand(const float absoluteHeight_m, const float duration_s) {
  world.ticks_at_landing = world.ticks;
  world.landings += absoluteHeight_m <= 0.0f && duration_s > 0.0f;
  return 0;
}
int crtpCommanderHighLevelGoTo(const float x, const float y, const float z, const float yaw, const float duration_s,
                               const bool relative) {
  const float to[4] = {x, y, z, yaw};
  memcpy(world.go_to, to, sizeof to);
  memcpy(world.position, to, sizeof world.position);
  world.position[0] += world.strays;
  world.relative_starts += relative;
  return duration_s > 0.0f ? 0 : 1;
}
int crtpCommanderHighLevelStartTrajectory(const uint8_t trajectoryId, const float timeScale,
                                          const bool relativePosition, const bool relativeYaw, const bool reversed) {
  world.starts += trajectoryId == world.defined && timeScale == 1.0f && !reversed;
  world.relative_starts += relativePosition + relativeYaw;
  world.ticks_at_start = world.ticks;
  return 0;
}
int crtpCommanderHighLevelDefineTrajectory(const uint8_t trajectoryId, const crtpCommanderTrajectoryType_t type,
                                           const uint32_t offset, const uint8_t nPieces) {
  world.defined = type == CRTP_CHL_TRAJECTORY_TYPE_POLY4D && offset == 0 ? trajectoryId : -1;
  world.pieces = nPieces;
  return 0;
}
bool crtpCommanderHighLevelWriteTrajectory(const uint32_t offset, const uint32_t length, const uint8_t* data) {
  if (offset + length > sizeof world.memory) return false;
  memcpy(world.memory + offset, data, length);
  world.written = length;
  return true;
}

/* A vehicle on the ground below the plan's start, that flies where it is told. */
static void reset(const float start[4]) {
  memset(&world, 0, sizeof world);
  world.position[0] = start[0];
  world.position[1] = start[1];
  world.arms = true;
  world.stop_at = world.crash_at = NEVER;
  *parameter_of_tern() = 0;
}

static int flies_the_plan(const uint8_t* plan, size_t bytes, const float start[4]) {
  float duration = 0.0f;
  reset(start);
  appMain();
  REQUIRE(world.written == bytes && memcmp(world.memory, plan, bytes) == 0);
  REQUIRE((size_t)world.pieces == bytes / 132 && world.defined == 1);
  REQUIRE(world.arming == 1 && world.starts == 1 && world.landings == 1 && world.relative_starts == 0);
  REQUIRE(world.ticks_at_takeoff >= START_AT + 1000); /* armed for a second before */
  REQUIRE(memcmp(world.go_to, start, sizeof world.go_to) == 0 && world.takeoff_height == start[2]);
  for (size_t at = 128; at < bytes; at += 132) {
    float piece;
    memcpy(&piece, plan + at, sizeof piece);
    duration += piece;
  }
  const float flown = (float)(world.ticks_at_landing - world.ticks_at_start) / 1000.0f;
  REQUIRE(flown > duration && flown < duration + 1.2f);
  printf("%d pieces, %.2f s\n", world.pieces, (double)duration);
  return 0;
}

static int stays_on_the_ground(const float start[4]) {
  reset(start);
  world.arms = false;
  appMain();
  REQUIRE(world.arming == 1 && world.takeoffs == 0 && world.landings == 0);
  reset(start);
  world.position[1] += 0.6f;
  appMain();
  REQUIRE(world.arming == 0 && world.takeoffs == 0);
  reset(start);
  world.position[0] = NAN;
  appMain();
  REQUIRE(world.arming == 0 && world.takeoffs == 0);
  return 0;
}

static int lands_early(const float start[4]) {
  reset(start);
  world.strays = 0.15f; /* from the plan's start */
  appMain();
  REQUIRE(world.takeoffs == 1 && world.starts == 0 && world.landings == 1);
  reset(start);
  world.blocked = true; /* by the supervisor */
  appMain();
  REQUIRE(world.starts == 0 && world.landings == 1);
  reset(start);
  world.stop_at = START_AT + 9000; /* tern.start is set to 0 */
  appMain();
  REQUIRE(world.starts == 1 && world.landings == 1 && world.ticks_at_landing <= world.stop_at + 100);
  reset(start);
  world.crash_at = START_AT + 8500;
  appMain();
  REQUIRE(world.starts == 1 && world.ticks_at_landing <= world.crash_at + 100);
  return 0;
}

int main(int argc, char** argv) {
  uint8_t plan[8192];
  float start[4];
  FILE* file = argc == 2 ? fopen(argv[1], "rb") : NULL;
  REQUIRE(file != NULL);
  const size_t bytes = fread(plan, 1, sizeof plan, file);
  fclose(file);
  REQUIRE(bytes > 0 && bytes % 132 == 0);
  for (int axis = 0; axis < 4; ++axis) memcpy(&start[axis], plan + 32 * axis, sizeof start[axis]);
  return flies_the_plan(plan, bytes, start) || stays_on_the_ground(start) || lands_early(start);
}
