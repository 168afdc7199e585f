# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
set(TERN_STAGE_SOURCES envelope.cpp flight_record.cpp flight_record_c.cpp obstacles.cpp plan_record.cpp record_c.cpp
  record_map.cpp)
