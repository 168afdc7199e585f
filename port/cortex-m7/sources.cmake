# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
enable_language(ASM)
include(${CMAKE_CURRENT_LIST_DIR}/../baremetal/sources.cmake)
target_sources(tern_board PRIVATE
  ${CMAKE_CURRENT_LIST_DIR}/start.S ${CMAKE_CURRENT_LIST_DIR}/fault.cpp ${CMAKE_CURRENT_LIST_DIR}/systick.cpp)
# Where its script finds sections.ld.
target_link_options(tern_board PUBLIC -L${CMAKE_CURRENT_LIST_DIR})
set_target_properties(tern_board PROPERTIES TERN_LINKER_SCRIPT ${CMAKE_CURRENT_LIST_DIR}/mps2_an500.ld)
