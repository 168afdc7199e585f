# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
set(TERN_STAGE_SOURCES
  join.cpp path_stage.cpp shortcut.cpp sight.cpp tighten.cpp)
