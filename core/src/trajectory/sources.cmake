# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
set(TERN_STAGE_SOURCES
  candidate.cpp chain_ends.cpp curvature.cpp cutting_planes.cpp limit_planes.cpp piece.cpp programme.cpp refinement.cpp
  relative_corridor.cpp stop_and_go.cpp time_prices.cpp trajectory_stage.cpp)
