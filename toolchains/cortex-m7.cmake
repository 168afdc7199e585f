# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Cortex-M7 with a double-precision FPU and no operating system. Newlib's headers serve the compiler; nothing of newlib
# is linked. Images run on QEMU's mps2-an500, where -icount shift=6 makes SysTick deterministic.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_C_COMPILER arm-none-eabi-gcc)
set(CMAKE_CXX_COMPILER arm-none-eabi-g++)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)

set(tern_core_m7 "-mcpu=cortex-m7 -mthumb -mfpu=fpv5-d16 -mfloat-abi=hard")
set(tern_bare "${tern_core_m7} -fno-stack-protector -fno-unwind-tables -fno-asynchronous-unwind-tables \
-fno-math-errno -ffp-contract=off")
set(CMAKE_ASM_FLAGS_INIT "${tern_core_m7}")
set(CMAKE_C_FLAGS_INIT "${tern_bare}")
set(CMAKE_CXX_FLAGS_INIT "${tern_bare} -fno-exceptions -fno-rtti -fno-threadsafe-statics -fno-use-cxa-atexit")
# After every library: the core needs libgcc's integer helpers, too.
set(CMAKE_CXX_STANDARD_LIBRARIES_INIT "-lgcc")

set(TERN_PORT "cortex-m7" CACHE STRING "Platform folder under port/")
set(TERN_PROFILE "mcu" CACHE STRING "Capacity profile: tiny, fmu, mcu or companion")
# The image follows as -kernel's argument; whatever follows it goes to QEMU, e.g. -append "--each" for the image.
set(CMAKE_CROSSCOMPILING_EMULATOR
  "timeout;-k;5;1200;qemu-system-arm;-M;mps2-an500;-icount;shift=6;-nodefaults;-display;none;\
-chardev;stdio,id=sh;-semihosting-config;enable=on,target=native,chardev=sh;-kernel")
