# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
set(TERN_STAGE_SOURCES
  bind.cpp frame.cpp grid_words.cpp map_c.cpp pixels.cpp prior.cpp rolling_map.cpp scan.cpp slide.cpp snapshot.cpp)
