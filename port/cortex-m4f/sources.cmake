# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
#
# All but the memory is as on the Cortex-M7.
include(${CMAKE_CURRENT_LIST_DIR}/../cortex-m7/sources.cmake)
target_sources(tern_board PRIVATE ${CMAKE_CURRENT_LIST_DIR}/errno.cpp)
target_compile_definitions(tern_board PRIVATE "TERN_BOARD_NAME=\"Cortex-M4F bare metal (QEMU mps2-an386)\"")
set_target_properties(tern_board PROPERTIES TERN_LINKER_SCRIPT ${CMAKE_CURRENT_LIST_DIR}/mps2_an386.ld)
