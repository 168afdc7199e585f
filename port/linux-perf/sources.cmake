# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The kernel's hardware counters, for every port that runs on Linux; #include "linux-perf/perf_counter.hpp".
target_sources(tern_port PRIVATE ${CMAKE_CURRENT_LIST_DIR}/perf_counter.cpp)
target_include_directories(tern_port PUBLIC ${CMAKE_CURRENT_LIST_DIR}/..)
