/* Copyright (c) 2026, the Tern authors
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Links the library for flight stacks, which brings the core along. */
#include "tern_stacks/stacks.h"

int main(void) {
  tern_px4_parameters parameters;
  tern_limits limits;
  tern_px4_defaults(&parameters);
  if (tern_abi() != TERN_ABI || tern_limits_from_px4(&parameters, &limits, 0) != TERN_OK) return 1;
  return limits.v_horizontal > 0.0 && limits.v_horizontal < parameters.mpc_xy_vel_max ? 0 : 1;
}
