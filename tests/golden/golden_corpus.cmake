# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
include(${CMAKE_CURRENT_LIST_DIR}/embed_maps.cmake)
# Users' projects have the corpus, too: their PROJECT_SOURCE_DIR is another.
get_filename_component(TERN_GOLDEN_ROOT ${CMAKE_CURRENT_LIST_DIR}/../.. ABSOLUTE)

# tern_add_golden_corpus(TARGET [LIBRARY]): the corpus, with the maps embedded, becomes part of TARGET, on any platform.
# LIBRARY: the core with other capacities than those of tern.
function(tern_add_golden_corpus target)
  set(library tern)
  if(ARGC GREATER 1)
    set(library ${ARGV1})
  endif()
  set(maps "")
  foreach(i RANGE 1 6)
    list(APPEND maps ${TERN_GOLDEN_ROOT}/bench/maps/map${i}.txt)
  endforeach()
  tern_embed_maps(${CMAKE_CURRENT_BINARY_DIR}/golden_maps.inc ${maps})
  target_sources(${target} PRIVATE ${TERN_GOLDEN_ROOT}/tests/golden/corpus.cpp)
  target_include_directories(${target} PRIVATE ${TERN_GOLDEN_ROOT}/tests ${CMAKE_CURRENT_BINARY_DIR})
  # Tests have a scale already.
  get_target_property(libraries ${target} LINK_LIBRARIES)
  if(NOT "tern_test_support" IN_LIST libraries)
    target_compile_definitions(${target} PRIVATE TERN_TEST_SCALE=1)
  endif()
  # The corpus must be the same numbers everywhere, too.
  target_compile_options(${target} PRIVATE -ffp-contract=off)
  target_link_libraries(${target} PRIVATE ${library})
endfunction()
