# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
#
# What an install has beyond the library, and the Debian package of all of it: `cpack -G DEB` in the build tree.
if(TARGET tern_cli)
  install(TARGETS tern_cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
install(FILES README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME tern)
set(CPACK_PACKAGE_VENDOR "the Tern authors")
set(CPACK_PACKAGE_CONTACT "the Tern authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Deterministic trajectory planning core for multirotors")
set(CPACK_PACKAGE_DESCRIPTION "Library with headers for C and C++, command line, Python package and documentation.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES OFF)
set(CPACK_DEBIAN_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "python3-cffi, python3-numpy")
# Which packages the command line needs at run time is for dpkg-shlibdeps to say, where it is installed.
find_program(TERN_SHLIBDEPS dpkg-shlibdeps)
if(TERN_SHLIBDEPS)
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
endif()
include(CPack)
