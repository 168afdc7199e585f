/* Copyright (c) 2026, the Tern authors
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * A stand-in for the Crazyflie's parameters: a group of one parameter becomes a function that gives its address. */
#pragma once

#include <stdint.h>

#define PARAM_UINT8 8
#define PARAM_GROUP_START(GROUP)        \
  uint8_t* parameter_of_##GROUP(void);  \
  uint8_t* parameter_of_##GROUP(void) { \
    return
#define PARAM_ADD(TYPE, NAME, ADDRESS) (ADDRESS)
#define PARAM_GROUP_STOP(GROUP) \
  ;                             \
  }
