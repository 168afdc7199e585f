# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
set(TERN_STAGE_SOURCES aim.cpp blocked.cpp branch.cpp charge.cpp cycle.cpp evade.cpp flight.cpp flight_c.cpp
  flight_text.cpp lookout.cpp mission.cpp mission_check.cpp nose.cpp passages.cpp prove_draft.cpp route_copy.cpp
  sharp_stop.cpp slow_down.cpp start.cpp watch.cpp)
