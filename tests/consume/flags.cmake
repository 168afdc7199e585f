# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The self-test compiled with the flags of flight stacks, which change results where Tern's own flags do not undo them.

# tern_add_flags_program(name expected [LIBRARIES library...] [SOURCES file...] [FLAGS flag...])
function(tern_add_flags_program name expected)
  cmake_parse_arguments(ARG "" "" "LIBRARIES;SOURCES;FLAGS" ${ARGN})
  add_executable(consume_flags_${name} flags.cpp ${ARG_SOURCES})
  target_compile_options(consume_flags_${name} PRIVATE -O2 ${ARG_FLAGS})
  target_compile_definitions(consume_flags_${name} PRIVATE "TERN_EXPECTED_FAULTS=${expected}")
  target_link_libraries(consume_flags_${name} PRIVATE ${ARG_LIBRARIES})
  add_test(NAME ${TERN_TEST_PREFIX}consume_flags_${name} COMMAND consume_flags_${name})
endfunction()

# The self-test's source alone, as in a build that lists the core's sources without the core's flags.
add_library(consume_flags_core INTERFACE)
target_compile_features(consume_flags_core INTERFACE cxx_std_17)
target_include_directories(consume_flags_core INTERFACE ${PROJECT_SOURCE_DIR}/core/include ${PROJECT_SOURCE_DIR}/core/src)
get_target_property(eigen_dirs Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
target_include_directories(consume_flags_core SYSTEM INTERFACE ${eigen_dirs})

# tern_add_flags_test(name expected [flag...]): without Tern's own flags the self-test finds the expected faults, and
# with them after the others none. The archive does not mind its caller's flags, but for the constants of the headers.
function(tern_add_flags_test name expected)
  set(source ${PROJECT_SOURCE_DIR}/core/src/base/self_test.cpp)
  tern_add_flags_program(${name} "${expected}" LIBRARIES consume_flags_core SOURCES ${source}
    FLAGS -ffp-contract=off ${ARGN})
  tern_add_flags_program(${name}_undone 0 LIBRARIES consume_flags_core tern_core_flags SOURCES ${source} FLAGS ${ARGN})
endfunction()

tern_add_flags_test(none 0)
tern_add_flags_test(reciprocal kFaultReciprocalMath -freciprocal-math)
tern_add_flags_test(zeros kFaultNoSignedZeros -fno-signed-zeros)
tern_add_flags_test(traps 0 -fno-trapping-math)  # changes exceptions, which Tern does not read, and no value
tern_add_flags_test(finite kFaultArithmetic -ffinite-math-only)
tern_add_flags_test(associative kFaultAssociativeMath|kFaultNoSignedZeros
  -fassociative-math -fno-signed-zeros -fno-trapping-math)
tern_add_flags_test(unsafe kFaultAssociativeMath|kFaultReciprocalMath|kFaultNoSignedZeros -funsafe-math-optimizations)
tern_add_flags_test(px4 kFaultReciprocalMath|kFaultNoSignedZeros
  -fno-math-errno -freciprocal-math -fno-signed-zeros -fno-trapping-math)
tern_add_flags_program(px4_caller 0 LIBRARIES tern FLAGS -freciprocal-math -fno-signed-zeros -fno-trapping-math)
tern_add_flags_test(fast kFaultArithmetic|kFaultReciprocalMath|kFaultNoSignedZeros|kFaultAssociativeMath -ffast-math)
# Every aarch64 can fuse a product into a sum; not every x86 can.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "aarch64")
  tern_add_flags_test(contract kFaultContraction -ffp-contract=fast)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  tern_add_flags_test(ardupilot kFaultSinglePrecisionConstant -fsingle-precision-constant)
  tern_add_flags_program(ardupilot_caller kFaultSinglePrecisionConstant LIBRARIES tern FLAGS -fsingle-precision-constant)
endif()
