# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
set(TERN_STAGE_SOURCES detour.cpp escape.cpp moving_ends.cpp phases.cpp plan.cpp planner.cpp previous.cpp previous_phase.cpp
  self_test.cpp stage_phases.cpp tern_c.cpp tube.cpp validate.cpp)
