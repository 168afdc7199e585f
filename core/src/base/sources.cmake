# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
set(TERN_STAGE_SOURCES common_point.cpp fence_fault.cpp polyhedron.cpp self_test.cpp status.cpp)
