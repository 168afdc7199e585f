# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
set(TERN_STAGE_SOURCES
  pace.cpp time_unit.cpp times_stage.cpp trapezoid.cpp)
