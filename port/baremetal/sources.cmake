# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
#
# What boards without an operating system share. A board's sources.cmake includes this, then adds its own start-up
# sources to tern_board and its linker script.
add_library(tern_board OBJECT EXCLUDE_FROM_ALL
  ${CMAKE_CURRENT_LIST_DIR}/memory.cpp ${CMAKE_CURRENT_LIST_DIR}/print.cpp ${CMAKE_CURRENT_LIST_DIR}/run.cpp
  ${CMAKE_CURRENT_LIST_DIR}/semihosting.cpp ${CMAKE_CURRENT_LIST_DIR}/stack.cpp)
target_include_directories(tern_board PUBLIC ${CMAKE_CURRENT_LIST_DIR}/.. ${CMAKE_CURRENT_LIST_DIR}/../include)
target_include_directories(tern_port PRIVATE ${CMAKE_CURRENT_LIST_DIR}/..)
target_compile_features(tern_board PUBLIC cxx_std_17)
# A fault report must not fault itself: nothing here uses a floating-point register.
target_compile_options(tern_board PRIVATE $<$<COMPILE_LANGUAGE:CXX>:-mgeneral-regs-only -Wall -Wextra -Wconversion
  -Wshadow -fno-tree-loop-distribute-patterns $<$<BOOL:${TERN_WERROR}>:-Werror>>)
set_source_files_properties(${CMAKE_CURRENT_LIST_DIR}/memory.cpp PROPERTIES COMPILE_OPTIONS -fno-builtin)

# tern_add_image(NAME SOURCE...): an executable for the board. Only libgcc's integer helpers are linked (the toolchain
# file names them): a stray operator new, exception or printf is a link error.
function(tern_add_image name)
  add_executable(${name} ${ARGN})
  target_link_libraries(${name} PRIVATE tern_board)
  target_compile_options(${name} PRIVATE -Wall -Wextra -Wshadow $<$<BOOL:${TERN_WERROR}>:-Werror>)
  get_target_property(script tern_board TERN_LINKER_SCRIPT)
  target_link_options(${name} PRIVATE -nostdlib -nostartfiles -static -no-pie -Wl,--gc-sections -Wl,--build-id=none
    -Wl,--fatal-warnings -Wl,-Map=${CMAKE_CURRENT_BINARY_DIR}/${name}.map -T ${script})
  set_target_properties(${name} PROPERTIES LINK_DEPENDS ${script})
endfunction()
