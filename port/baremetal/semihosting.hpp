// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Arm semihosting: the debugger or emulator that the processor hangs on prints, ends the run and hands over a command
// line. Without one the trap faults, so a product's image replaces this file with its own console.
#ifndef TERN_PORT_BAREMETAL_SEMIHOSTING_HPP
#define TERN_PORT_BAREMETAL_SEMIHOSTING_HPP

namespace tern_board {

/// Prints a zero-terminated text as it is.
void write(const char* text) noexcept;

/// Ends the run; the emulator's exit status is `status`.
[[noreturn]] void leave(int status) noexcept;

/// Copies the command line (image name first) into `out`, zero-terminated; false, and an empty text, where there is
/// none or it is longer than size - 1.
bool command_line(char* out, int size) noexcept;

}  // namespace tern_board

#endif
