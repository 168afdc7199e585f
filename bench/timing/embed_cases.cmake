# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
#
# tern_embed_cases(OUTPUT FILE...): scenario files as constant tables of timing/cases.hpp, named after their files. The
# compiler reads the decimals, as strtod would.

# A list of words as a braced triple.
function(tern_triple words first output)
  math(EXPR second "${first}+1")
  math(EXPR third "${first}+2")
  list(GET words ${first} ${second} ${third} triple)
  string(REPLACE ";" "," triple "${triple}")
  set(${output} "{${triple}}" PARENT_SCOPE)
endfunction()

# One scenario file: its blocks' table and its row.
function(tern_embed_case file blocks_output row_output)
  get_filename_component(name ${file} NAME_WE)
  set(blocks "")
  set(count 0)
  set(start_velocity "{0,0,0}")
  file(STRINGS ${file} lines REGEX "^[a-z]")
  foreach(line ${lines})
    string(REGEX REPLACE " +" ";" words "${line}")
    list(GET words 0 key)
    list(LENGTH words length)
    if(key STREQUAL "block" OR key STREQUAL "boundary")
      tern_triple("${words}" 1 lower)
      tern_triple("${words}" 4 upper)
      set(box "{${lower},${upper}}")
      if(key STREQUAL "boundary")
        set(boundary "${box}")
      else()
        string(APPEND blocks "    ${box},\n")
        math(EXPR count "${count}+1")
      endif()
    elseif(length GREATER 3)
      tern_triple("${words}" 1 ${key})
    else()
      list(GET words 1 ${key})
    endif()
  endforeach()
  set(zero "{0,0,0}")
  set(request "{{${start},${start_velocity},${zero}}, {${goal},${zero},${zero}}, \
{{${v_max},${v_max},${v_max}}, {${a_max},${a_max},${a_max}}}, {}, tern::ShortcutMode::kShortestChain}")
  set(table "kBlocks_${name}")
  set(${blocks_output} "const tern::Box ${table}[] = {\n${blocks}};\n" PARENT_SCOPE)
  set(${row_output} "    {\"${name}\", ${boundary}, ${resolution}, ${radius}, ${table}, ${count},\n     ${request}},\n"
      PARENT_SCOPE)
endfunction()

function(tern_embed_cases output)
  set(tables "")
  set(rows "")
  list(LENGTH ARGN count)
  foreach(file ${ARGN})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    tern_embed_case(${file} table row)
    string(APPEND tables "${table}")
    string(APPEND rows "${row}")
  endforeach()
  file(WRITE ${output}.new "// Generated from scenario files; do not edit.\n#include \"timing/cases.hpp\"\n
namespace tern_timing {\nnamespace {\n${tables}}  // namespace\n
const Case kCases[] = {\n${rows}};\nconst int kCaseCount = ${count};\n\n}  // namespace tern_timing\n")
  configure_file(${output}.new ${output} COPYONLY)
endfunction()
