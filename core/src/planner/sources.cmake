# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
set(TERN_STAGE_SOURCES curves.cpp detour.cpp end_stop.cpp follow.cpp ledger.cpp legs.cpp nearest_point.cpp order.cpp
  pipeline.cpp planner.cpp previous.cpp problem.cpp report.cpp stage_bounds.cpp stop_first.cpp tern_c.cpp
  tube.cpp validate.cpp vias.cpp)
