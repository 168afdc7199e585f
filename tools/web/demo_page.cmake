# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
#
# cmake -DTHREE=... -DENGINE=<tern_engine.js> -DSCENARIO=<file> -DOUTPUT=<file.html> -P demo_page.cmake
include(${CMAKE_CURRENT_LIST_DIR}/assemble.cmake)
tern_assemble_page(page ${THREE} ENGINE ${ENGINE}
  SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/scenario.js ${CMAKE_CURRENT_LIST_DIR}/demo.js)
file(READ ${SCENARIO} scenario)
string(REPLACE "\n" "\\n" scenario "${scenario}")
string(REPLACE "@DATA@" "{\"format\":\"tern-page/1\",\"runs\":[],\"demo\":\"${scenario}\"}" page "${page}")
file(WRITE ${OUTPUT} "${page}")
