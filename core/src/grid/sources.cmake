# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
set(TERN_STAGE_SOURCES
  changes.cpp clear.cpp distance.cpp fence_layer.cpp fences.cpp grid.cpp hull_gap.cpp inflate.cpp mark.cpp nearest.cpp
  stencil.cpp tile.cpp)
