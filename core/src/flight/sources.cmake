# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
set(TERN_STAGE_SOURCES aim.cpp blocked.cpp branch.cpp branch_search.cpp committed_plans.cpp cycle.cpp
  cycle_questions.cpp draft.cpp evasion.cpp flight.cpp flight_c.cpp flight_facts.cpp flight_text.cpp
  itinerary.cpp nose.cpp report.cpp rest_search.cpp results.cpp route_copy.cpp sharp_stop.cpp slow_down.cpp start.cpp
  tick.cpp watch.cpp)
