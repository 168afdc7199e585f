# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
set(TERN_STAGE_SOURCES allowed.cpp check_stage.cpp cut_off.cpp fences.cpp grants.cpp
  hull_clear.cpp joints.cpp proof.cpp proof_piece.cpp solid.cpp vias.cpp)
