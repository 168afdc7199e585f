# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The flags that flight stacks compile their own code with, as their build files have them (GCC): PX4's
# cmake/px4_add_common_flags.cmake of August 2025, ArduPilot's Tools/ardupilotwaf/boards.py of July 2025, and the
# Crazyflie firmware's Makefile. -include visibility.h is PX4's own file and has no part in this.

set(TERN_PX4_ARITHMETIC -fno-signed-zeros -fno-trapping-math -freciprocal-math -fno-math-errno -fmerge-all-constants)
set(TERN_PX4_FLAGS -Os ${TERN_PX4_ARITHMETIC} -fno-strict-aliasing -fomit-frame-pointer -fvisibility=hidden
  -fno-exceptions -fno-rtti -fno-sized-deallocation -fno-threadsafe-statics -fcheck-new -fno-builtin-printf
  -Wall -Wextra -Werror -Warray-bounds -Wcast-align -Wdisabled-optimization -Wdouble-promotion -Wfatal-errors
  -Wfloat-equal -Wformat-security -Winit-self -Wlogical-op -Wpointer-arith -Wshadow -Wuninitialized -Wreorder
  -Wno-missing-field-initializers -Wno-unused-parameter)

set(TERN_ARDUPILOT_ARITHMETIC -fsingle-precision-constant)
set(TERN_ARDUPILOT_FLAGS -Os ${TERN_ARDUPILOT_ARITHMETIC} -fno-exceptions -fsigned-char
  -Wall -Wextra -Wpointer-arith -Wno-unused-parameter -Wno-missing-field-initializers -Werror=reorder -Werror=cast-align
  -Werror=attributes -Werror=format-security -Werror=enum-compare -Werror=format -Werror=array-bounds
  -Werror=uninitialized -Werror=init-self -Werror=narrowing -Werror=return-type -Werror=switch -Werror=sign-compare
  -Werror=type-limits -Werror=undef -Werror=unused-result -Werror=shadow -Werror=unused-value -Werror=unused-variable
  -Wfatal-errors -Werror=parentheses -Werror=suggest-override -Werror=implicit-fallthrough -Werror=maybe-uninitialized
  -Werror=duplicated-cond -Werror=unused-but-set-variable -Werror=frame-larger-than=1300)

set(TERN_CRAZYFLIE_PROCESSOR -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16 -mfp16-format=ieee)
set(TERN_CRAZYFLIE_FLAGS -Os -g3 -fno-math-errno -Wall -Wmissing-braces -fno-strict-aliasing
  -ffunction-sections -fdata-sections -Wdouble-promotion -Werror -Wno-address-of-packed-member)
