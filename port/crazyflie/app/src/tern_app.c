/* Copyright (c) 2026, the Tern authors
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * An app for the Crazyflie's firmware: flies a plan that was compiled in, without a ground station. plan.h holds the
 * bytes that `tern export --crazyflie-raw` wrote. The firmware's own high-level commander evaluates them. */
#include <stdint.h>
#include <string.h>

#include "FreeRTOS.h"
#include "app.h"
#include "crtp_commander_high_level.h"
#include "debug.h"
#include "plan.h"
#include "task.h"

#define DEBUG_MODULE "TERN"

enum { TRAJECTORY = 1, PIECE_BYTES = 132, COEFFICIENTS = 8, DURATION_AT = 128, AXIS_BYTES = 32 };

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

void appMain(void) {
  const uint8_t pieces = sizeof plan_bin / PIECE_BYTES;
  if (!crtpCommanderHighLevelWriteTrajectory(0, sizeof plan_bin, plan_bin)) {
    DEBUG_PRINT("the plan does not fit into the trajectory memory\n");
    return;
  }
  crtpCommanderHighLevelDefineTrajectory(TRAJECTORY, CRTP_CHL_TRAJECTORY_TYPE_POLY4D, 0, pieces);

  crtpCommanderHighLevelTakeoff(start_of(2), 2.0f);
  vTaskDelay(M2T(3000));
  crtpCommanderHighLevelGoTo(start_of(0), start_of(1), start_of(2), start_of(3), 2.0f, false);
  vTaskDelay(M2T(3000));
  /* Not relative: a plan that is moved is no longer the plan that was proven. */
  crtpCommanderHighLevelStartTrajectory(TRAJECTORY, 1.0f, false, false);
  vTaskDelay(M2T((uint32_t)(1000.0f * duration_of_plan()) + 1000));
  crtpCommanderHighLevelLand(0.0f, 3.0f);
}
