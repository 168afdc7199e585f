# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The host's clang with address and undefined-behaviour sanitizers; the first finding ends the test.
set(CMAKE_C_COMPILER clang)
set(CMAKE_CXX_COMPILER clang++)
set(CMAKE_C_FLAGS_INIT "-fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer")
set(CMAKE_CXX_FLAGS_INIT "-fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer")
