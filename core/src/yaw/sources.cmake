# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
set(TERN_STAGE_SOURCES angle.cpp yaw_c.cpp yaw_fit.cpp yaw_plan.cpp yaw_planner.cpp yaw_request.cpp)
