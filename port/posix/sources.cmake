# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
if(CMAKE_SYSTEM_NAME STREQUAL "Linux")
  include(${CMAKE_CURRENT_LIST_DIR}/../linux-perf/sources.cmake)
endif()
