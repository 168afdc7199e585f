# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
set(TERN_STAGE_SOURCES barrier_ellipsoid.cpp corridor_stage.cpp ellipsoid_fit.cpp ellipsoid_metric.cpp
                       fence_planes.cpp grow.cpp hull_polyhedron.cpp
                       improve.cpp inscribe.cpp local_boxes.cpp redundancy.cpp reuse.cpp separation.cpp
                       tangent_planes.cpp)
