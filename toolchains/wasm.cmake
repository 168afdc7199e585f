# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
#
# WebAssembly with Debian's emscripten (em++ must be found), for browsers and node.
find_program(emcc emcc REQUIRED)
get_filename_component(emcc "${emcc}" REALPATH)
get_filename_component(emscripten "${emcc}" DIRECTORY)
if(NOT EXISTS ${emscripten}/cmake/Modules/Platform/Emscripten.cmake)
  set(emscripten /usr/share/emscripten)
endif()
include(${emscripten}/cmake/Modules/Platform/Emscripten.cmake)
# Headers alone, which serve every target.
set(Eigen3_DIR /usr/share/eigen3/cmake CACHE PATH "Eigen's package")
# This target has no floating-point exceptions that could be trapped or kept, so -fno-fast-math has nothing to keep.
set(CMAKE_CXX_FLAGS_INIT "-Wno-unsupported-floating-point-opt")
