# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
set(TERN_STAGE_SOURCES
  corners.cpp facet.cpp fences.cpp hull_gap.cpp narrow_boundary.cpp solid_layer.cpp world.cpp world_memory.cpp)
