# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Cortex-M4 with a single-precision FPU and no operating system: doubles are computed by libgcc's functions, to the same
# bits. Images run on QEMU's mps2-an386, where -icount shift=6 makes SysTick deterministic.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_C_COMPILER arm-none-eabi-gcc)
set(CMAKE_CXX_COMPILER arm-none-eabi-g++)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)

set(tern_core_m4f "-mcpu=cortex-m4 -mthumb -mfpu=fpv4-sp-d16 -mfloat-abi=hard")
set(tern_bare "${tern_core_m4f} -fno-stack-protector -fno-unwind-tables -fno-asynchronous-unwind-tables \
-fno-math-errno -ffp-contract=off")
set(CMAKE_ASM_FLAGS_INIT "${tern_core_m4f}")
set(CMAKE_C_FLAGS_INIT "${tern_bare}")
set(CMAKE_CXX_FLAGS_INIT "${tern_bare} -fno-exceptions -fno-rtti -fno-threadsafe-statics -fno-use-cxa-atexit")
# After every library: the core needs libgcc for doubles and 64-bit integers, and the square root of a double.
set(CMAKE_CXX_STANDARD_LIBRARIES_INIT "-lm -lgcc")

set(TERN_PORT "cortex-m4f" CACHE STRING "Platform folder under port/")
set(TERN_PROFILE "fmu" CACHE STRING "Capacity profile: tiny, fmu, mcu or companion")
# The image follows as -kernel's argument; whatever follows it goes to QEMU, e.g. -append "--each" for the image.
set(CMAKE_CROSSCOMPILING_EMULATOR
  "timeout;-k;5;1200;qemu-system-arm;-M;mps2-an386;-icount;shift=6;-nodefaults;-display;none;\
-chardev;stdio,id=sh;-semihosting-config;enable=on,target=native,chardev=sh;-kernel")
