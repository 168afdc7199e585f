# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
include(${CMAKE_CURRENT_LIST_DIR}/embed_maps.cmake)

# tern_add_golden_corpus(TARGET): the corpus, with the maps embedded, becomes part of TARGET, on any platform.
function(tern_add_golden_corpus target)
  set(maps "")
  foreach(i RANGE 1 6)
    list(APPEND maps ${PROJECT_SOURCE_DIR}/bench/maps/map${i}.txt)
  endforeach()
  tern_embed_maps(${CMAKE_CURRENT_BINARY_DIR}/golden_maps.inc ${maps})
  target_sources(${target} PRIVATE ${PROJECT_SOURCE_DIR}/tests/golden/corpus.cpp)
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/tests ${CMAKE_CURRENT_BINARY_DIR})
  target_compile_definitions(${target} PRIVATE TERN_TEST_SCALE=1)
  # The corpus must be the same numbers everywhere, too.
  target_compile_options(${target} PRIVATE -ffp-contract=off)
  target_link_libraries(${target} PRIVATE tern)
endfunction()
