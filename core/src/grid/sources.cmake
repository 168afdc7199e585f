# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
set(TERN_STAGE_SOURCES
  changes.cpp clear.cpp distance.cpp grid.cpp local_boxes.cpp mark.cpp nearest.cpp stencil.cpp
  touching.cpp)
