# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
set(TERN_STAGE_SOURCES asked_fences.cpp check_stage.cpp clearance.cpp fence.cpp limits.cpp motion.cpp solid.cpp tolerance.cpp vias.cpp)
