# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
set(TERN_STAGE_SOURCES
  fence_layer.cpp fences.cpp narrow_boundary.cpp)
