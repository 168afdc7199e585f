# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
#
# 64-bit Arm with no operating system and no C library: the ordinary Linux cross compiler, whose C++ headers Eigen
# needs, and a link without its run-time. Images run on QEMU's `virt` machine under -icount shift=0, where one
# instruction is one nanosecond of virtual time.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)

# Nothing may call a run-time that is not there: no unwinder, no libc guard, no atomics helper, no atexit.
set(tern_bare "-mcpu=cortex-a57 -mno-outline-atomics -fno-PIE -fno-stack-protector -fno-unwind-tables \
-fno-asynchronous-unwind-tables -fno-math-errno -ffp-contract=off")
set(CMAKE_ASM_FLAGS_INIT "-mcpu=cortex-a57")
set(CMAKE_C_FLAGS_INIT "${tern_bare}")
set(CMAKE_CXX_FLAGS_INIT "${tern_bare} -fno-exceptions -fno-rtti -fno-threadsafe-statics -fno-use-cxa-atexit")
# After every library: the core needs libgcc's integer helpers, too.
set(CMAKE_CXX_STANDARD_LIBRARIES_INIT "-lgcc")

set(TERN_PORT "baremetal-aarch64" CACHE STRING "Platform folder under port/")
# The image follows as -kernel's argument; whatever follows it goes to QEMU, e.g. -append "--each" for the image.
set(CMAKE_CROSSCOMPILING_EMULATOR
  "timeout;-k;5;1200;qemu-system-aarch64;-M;virt;-cpu;cortex-a57;-m;1G;-icount;shift=0;-nodefaults;-display;none;\
-chardev;stdio,id=sh;-semihosting-config;enable=on,target=native,chardev=sh;-kernel")
