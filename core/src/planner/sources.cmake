# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
set(TERN_STAGE_SOURCES detour.cpp escape.cpp legs.cpp moving_ends.cpp plan.cpp planner.cpp previous.cpp run_previous.cpp
  run_reach.cpp run_stages.cpp stages.cpp tern_c.cpp tube.cpp validate.cpp)
