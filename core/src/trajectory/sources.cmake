# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
set(TERN_STAGE_SOURCES
  axis_brake.cpp bezier.cpp brake.cpp chain.cpp evaluate.cpp flatness.cpp hermite.cpp limit_planes.cpp motion_limits.cpp programme.cpp refinement.cpp
  relative_corridor.cpp snap_cost.cpp stop_and_go.cpp stopping.cpp time_prices.cpp trajectory_stage.cpp)
