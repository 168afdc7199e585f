# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
set(TERN_STAGE_SOURCES
  barrier_ellipsoid.cpp ellipsoid_fit.cpp ellipsoid_metric.cpp)
