# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
target_sources(tern_port PRIVATE ${CMAKE_CURRENT_LIST_DIR}/perf_counter.cpp)
target_include_directories(tern_port PUBLIC ${CMAKE_CURRENT_LIST_DIR}/..)
