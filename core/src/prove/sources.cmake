# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
set(TERN_STAGE_SOURCES allowed.cpp asked_fences.cpp check_stage.cpp cut_off.cpp fence_clear.cpp grants.cpp
  hull_clear.cpp joints.cpp keep_out.cpp proof.cpp proof_piece.cpp solid.cpp vias.cpp)
