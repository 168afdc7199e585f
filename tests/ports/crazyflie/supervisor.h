/* Copyright (c) 2026, the Tern authors
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * A stand-in for the Crazyflie's supervisor. The test defines the functions. */
#pragma once

#include <stdbool.h>

bool supervisorRequestArming(const bool doArm);
bool supervisorIsArmed(void);
bool supervisorCanFly(void);
