# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
include("${CMAKE_CURRENT_LIST_DIR}/tern-targets.cmake")
