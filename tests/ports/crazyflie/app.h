/* Copyright (c) 2026, the Tern authors
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * A stand-in for the Crazyflie's header. */
#pragma once

void appMain(void);
