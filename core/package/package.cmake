# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
#
# What `cmake --install` leaves: the archive, the shared library where there is one, headers and licence, and what
# find_package(tern) and pkg-config find them by. Both give a user the definitions that the archive was compiled with.
include(CMakePackageConfigHelpers)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/tern)
# Before 1.0 a new minor version may change the interface.
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/tern-config-version.cmake COMPATIBILITY SameMinorVersion)

set(TERN_PC_INCLUDEDIR "\${prefix}/${CMAKE_INSTALL_INCLUDEDIR}")
if(IS_ABSOLUTE "${CMAKE_INSTALL_INCLUDEDIR}")
  set(TERN_PC_INCLUDEDIR "${CMAKE_INSTALL_INCLUDEDIR}")
endif()
file(RELATIVE_PATH TERN_PC_PREFIX "${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig" "${CMAKE_INSTALL_PREFIX}")
get_target_property(definitions tern INTERFACE_COMPILE_DEFINITIONS)
list(TRANSFORM definitions PREPEND -D)
list(JOIN definitions " " TERN_PC_DEFINITIONS)
string(REPLACE "\"" "\\\"" TERN_PC_DEFINITIONS "${TERN_PC_DEFINITIONS}")
set(libraries tern)
if(TARGET tern_shared)
  list(APPEND libraries tern_shared)
endif()
foreach(TERN_PC_LIBRARY ${libraries})
  configure_file(${CMAKE_CURRENT_LIST_DIR}/tern.pc.in ${CMAKE_CURRENT_BINARY_DIR}/${TERN_PC_LIBRARY}.pc @ONLY)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/${TERN_PC_LIBRARY}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endforeach()

install(TARGETS ${libraries} EXPORT tern_targets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY include/tern DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h" PATTERN "*.hpp")
install(EXPORT tern_targets FILE tern-targets.cmake NAMESPACE tern:: DESTINATION ${package_folder})
install(FILES ${CMAKE_CURRENT_LIST_DIR}/tern-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/tern-config-version.cmake
  DESTINATION ${package_folder})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
