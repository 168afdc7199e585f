/* Copyright (c) 2026, the Tern authors
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * The functions of the Crazyflie's high-level commander that the app calls. The test defines them. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

typedef enum {
  CRTP_CHL_TRAJECTORY_TYPE_POLY4D = 0,
  CRTP_CHL_TRAJECTORY_TYPE_POLY4D_COMPRESSED = 1
} crtpCommanderTrajectoryType_t;

int crtpCommanderHighLevelTakeoff(const float absoluteHeight_m, const float duration_s);
int crtpCommanderHighLevelLand(const float absoluteHeight_m, const float duration_s);
int crtpCommanderHighLevelGoTo(const float x, const float y, const float z, const float yaw, const float duration_s,
                               const bool relative);
int crtpCommanderHighLevelStartTrajectory(const uint8_t trajectoryId, const float timeScale,
                                          const bool relativePosition, const bool relativeYaw, const bool reversed);
int crtpCommanderHighLevelDefineTrajectory(const uint8_t trajectoryId, const crtpCommanderTrajectoryType_t type,
                                           const uint32_t offset, const uint8_t nPieces);
bool crtpCommanderHighLevelWriteTrajectory(const uint32_t offset, const uint32_t length, const uint8_t* data);
