# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
set(TERN_STAGE_SOURCES bound.cpp compressed.cpp crazyflie.cpp export_c.cpp frames.cpp mavlink.cpp pieces.cpp stack_limits.cpp
    yaw_piece.cpp)
