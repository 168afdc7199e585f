# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
#
# NVIDIA Jetson Xavier NX (Carmel cores, JetPack 4 and 5). Linked statically: JetPack's C library is older than the
# cross compiler's, and what is copied to the board must start there. GCC has no -mcpu=carmel; its architecture does.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_C_FLAGS_INIT "-march=armv8.2-a")
set(CMAKE_CXX_FLAGS_INIT "-march=armv8.2-a")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-static")
set(TERN_PORT "aarch64-linux" CACHE STRING "Platform folder under port/")
set(CMAKE_CROSSCOMPILING_EMULATOR "qemu-aarch64;-cpu;max")
