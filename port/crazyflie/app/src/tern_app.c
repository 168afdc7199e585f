/* Copyright (c) 2026, the Tern authors
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * An app for the Crazyflie's firmware: flies a plan that was compiled in, without a ground station. plan.h holds the
 * bytes that `tern export --crazyflie-raw` wrote. The firmware's own high-level commander evaluates them.
 *
 * Nothing moves until the parameter tern.start is set to 1. Setting it to 0 in flight lands at once. */
#include <math.h>
#include <stdint.h>
#include <string.h>

#include "FreeRTOS.h"
#include "app.h"
#include "crtp_commander_high_level.h"
#include "debug.h"
#include "log.h"
#include "param.h"
#include "plan.h"
#include "supervisor.h"
#include "task.h"

#define DEBUG_MODULE "TERN"

enum { TRAJECTORY = 1, PIECE_BYTES = 132, DURATION_AT = 128, AXIS_BYTES = 32, POLL_MS = 100 };

/* The way to the plan's start is not proven, so it must be short. Metres, seen from above. */
static const float NEAR_START = 0.5f;
/* How far from the plan's start the vehicle may be when the plan begins, metres. The tracking margin must hold it. */
static const float AT_START = 0.1f;

static uint8_t start;

PARAM_GROUP_START(tern)
PARAM_ADD(PARAM_UINT8, start, &start)
PARAM_GROUP_STOP(tern)

/* The coefficient of time to the power 0: where piece 0 begins on an axis (0 x, 1 y, 2 z, 3 yaw). */
static float start_of(int axis) {
  float value;
  memcpy(&value, plan_bin + axis * AXIS_BYTES, sizeof value);
  return value;
}

static float duration_of_plan(void) {
  float sum = 0.0f;
  for (uint32_t at = DURATION_AT; at < sizeof plan_bin; at += PIECE_BYTES) {
    float duration;
    memcpy(&duration, plan_bin + at, sizeof duration);
    sum += duration;
  }
  return sum;
}

/* How far the estimated position is from the plan's start, over the first `axes` axes. */
static float distance_to_start(int axes) {
  static const char* const names[3] = {"x", "y", "z"};
  float square = 0.0f;
  for (int axis = 0; axis < axes; ++axis) {
    const float off = logGetFloat(logGetVarId("stateEstimate", names[axis])) - start_of(axis);
    square += off * off;
  }
  return sqrtf(square);
}

/* Waits in flight. False, at once, if tern.start becomes 0 or the supervisor ends the flight. */
static bool wait_in_flight(uint32_t milliseconds) {
  for (uint32_t passed = 0; passed < milliseconds; passed += POLL_MS) {
    vTaskDelay(M2T(POLL_MS));
    if (!start || !supervisorCanFly()) return false;
  }
  return true;
}

static bool arm(void) {
  if (!supervisorIsArmed() && !supervisorRequestArming(true)) return false;
  vTaskDelay(M2T(1000));
  return supervisorCanFly();
}

static bool fly_plan(void) {
  if (crtpCommanderHighLevelTakeoff(start_of(2), 2.0f) != 0 || !wait_in_flight(3000)) return false;
  if (crtpCommanderHighLevelGoTo(start_of(0), start_of(1), start_of(2), start_of(3), 2.0f, false) != 0) return false;
  if (!wait_in_flight(3000)) return false;
  if (!(distance_to_start(3) <= AT_START)) {
    DEBUG_PRINT("not at the plan's start, so it is not flown\n");
    return false;
  }
  /* Neither position nor yaw is relative: a plan that is moved is no longer the plan that was proven. Firmware from
   * before June 2025 has no parameter for a relative yaw: leave out the second false. */
  if (crtpCommanderHighLevelStartTrajectory(TRAJECTORY, 1.0f, false, false, false) != 0) return false;
  return wait_in_flight((uint32_t)(1000.0f * duration_of_plan()) + 1000);
}

void appMain(void) {
  const uint8_t pieces = sizeof plan_bin / PIECE_BYTES;
  if (!crtpCommanderHighLevelWriteTrajectory(0, sizeof plan_bin, plan_bin)) {
    DEBUG_PRINT("the plan does not fit into the trajectory memory\n");
    return;
  }
  crtpCommanderHighLevelDefineTrajectory(TRAJECTORY, CRTP_CHL_TRAJECTORY_TYPE_POLY4D, 0, pieces);

  while (!start) vTaskDelay(M2T(POLL_MS));
  if (!(distance_to_start(2) <= NEAR_START)) {
    DEBUG_PRINT("further than half a metre from the plan's start: no take-off\n");
    return;
  }
  if (!arm()) {
    DEBUG_PRINT("the supervisor does not arm\n");
    return;
  }
  if (!fly_plan()) DEBUG_PRINT("the flight ends early\n");
  crtpCommanderHighLevelLand(0.0f, 3.0f);
}
