# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Runs a command and compares what a test of exit status alone cannot:
#   cmake -DCOMMAND=<program;arguments> -DSTATUS=<n> [-DOUT=<regex>] [-DERR=<regex>]
#         [-DREMOVE=<files>] [-DKEEP=<file>] [-DWRITES=<files>] [-DCONTAINS=<file;regex>] [-DSAME=<file;file>]
#         -P expect.cmake
# REMOVE: deleted before. KEEP: given a content before that the command must not change. WRITES: must exist after.
# SAME: must have the same content after.
if(REMOVE)
  file(REMOVE ${REMOVE})
endif()
if(KEEP)
  file(WRITE ${KEEP} "as it was\n")
endif()

execute_process(COMMAND ${COMMAND} RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE err TIMEOUT 300)
message(STATUS "exit status ${status}\n${out}${err}")

if(NOT status STREQUAL STATUS)
  message(FATAL_ERROR "exit status ${status}, expected ${STATUS}")
endif()
if(OUT AND NOT out MATCHES "${OUT}")
  message(FATAL_ERROR "standard output does not match ${OUT}")
endif()
if(ERR AND NOT err MATCHES "${ERR}")
  message(FATAL_ERROR "standard error does not match ${ERR}")
endif()
foreach(file ${WRITES})
  if(NOT EXISTS ${file})
    message(FATAL_ERROR "${file} was not written")
  endif()
endforeach()
if(KEEP)
  file(READ ${KEEP} content)
  if(NOT content STREQUAL "as it was\n")
    message(FATAL_ERROR "${KEEP} was changed")
  endif()
endif()
if(CONTAINS)
  list(GET CONTAINS 0 file)
  list(GET CONTAINS 1 pattern)
  file(READ ${file} content)
  if(NOT content MATCHES "${pattern}")
    message(FATAL_ERROR "${file} does not match ${pattern}")
  endif()
endif()
if(SAME)
  execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${SAME} RESULT_VARIABLE different)
  if(NOT different EQUAL 0)
    message(FATAL_ERROR "${SAME} differ")
  endif()
endif()
