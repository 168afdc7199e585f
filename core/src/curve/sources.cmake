# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
set(TERN_STAGE_SOURCES
  axis_brake.cpp bezier.cpp brake.cpp evaluate.cpp flatness.cpp hermite.cpp motion_limits.cpp rest.cpp
  stopping.cpp)
