# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
set(TERN_STAGE_SOURCES carve.cpp depth_pyramid.cpp projector.cpp view.cpp)
