# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
set(TERN_STAGE_SOURCES
  extract.cpp jump.cpp node_store.cpp open_list.cpp scan.cpp search.cpp jump_stops.cpp dominance.cpp)
