# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
set(TERN_STAGE_SOURCES inflate.cpp inflation_tile.cpp patch_maker.cpp plane_steps.cpp)
