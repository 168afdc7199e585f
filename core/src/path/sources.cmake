# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
set(TERN_STAGE_SOURCES
  finer_cell.cpp flood.cpp join.cpp polyline.cpp reach_stage.cpp search_stage.cpp shortcut.cpp shortcut_stage.cpp
  sight.cpp tighten.cpp)
