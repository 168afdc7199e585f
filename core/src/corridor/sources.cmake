# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
set(TERN_STAGE_SOURCES
  corridor_stage.cpp grow.cpp hull_polyhedron.cpp improve.cpp redundancy.cpp separation.cpp solid_planes.cpp
  tangent_planes.cpp)
