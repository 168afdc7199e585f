# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
#
# tern_assemble_page(OUTPUT THREE [SCRIPTS file...] [ENGINE file]): the text of page.html with its style, its scripts and
# three.js in it; THREE is the folder of three.js. Further scripts come before page.js, which starts the page. The engine
# is a script for a thread of its own.
cmake_minimum_required(VERSION 3.21)

function(tern_assemble_page output three)
  cmake_parse_arguments(ARG "" "ENGINE" "SCRIPTS" ${ARGN})
  set(web ${CMAKE_CURRENT_FUNCTION_LIST_DIR})
  file(READ ${web}/page.html page)
  file(READ ${web}/page.css style)
  set(libraries "")
  foreach(file ${three}/build/three.min.js ${three}/examples/js/controls/OrbitControls.js)
    file(READ ${file} text)
    string(APPEND libraries "${text}\n")
  endforeach()
  set(engine "")
  if(ARG_ENGINE)
    file(READ ${ARG_ENGINE} engine)
  endif()
  set(script "")
  set(own "")
  foreach(name palette polyhedra tube solid world things motion vehicle film run_view framing stage labels legend plots player)
    list(APPEND own ${web}/${name}.js)
  endforeach()
  foreach(file ${own} ${ARG_SCRIPTS} ${web}/page.js)
    file(READ ${file} text)
    string(APPEND script "${text}\n")
  endforeach()
  string(REPLACE "@STYLE@" "${style}" page "${page}")
  string(REPLACE "@THREE@" "${libraries}" page "${page}")
  string(REPLACE "@ENGINE@" "${engine}" page "${page}")
  string(REPLACE "@SCRIPT@" "${script}" page "${page}")
  set(${output} "${page}" PARENT_SCOPE)
endfunction()
