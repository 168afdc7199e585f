# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
set(TERN_STAGE_SOURCES
  bresenham.cpp extract.cpp join.cpp jump.cpp node_store.cpp open_list.cpp path_stage.cpp scan.cpp search.cpp
  shortcut.cpp sight.cpp stops.cpp tighten.cpp witness.cpp)
