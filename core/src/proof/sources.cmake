# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
set(TERN_STAGE_SOURCES fence_clear.cpp hull_clear.cpp proof.cpp proven_joints.cpp proven_limits.cpp)
